// A YAML file as lines: path, number or text, value; by the package yaml, of the version of YAML that is named.
const yaml = require('yaml');

function walk(path, value) {
  if (Array.isArray(value)) {
    value.forEach((item, i) => walk(`${path}/${i}`, item));
  } else if (value instanceof Map) {
    for (const [key, item] of value) walk(`${path}/${typeof key === 'string' ? key : typeof key + ' ' + key}`, item);
  } else if (typeof value === 'number') {
    const bits = Buffer.alloc(8);
    bits.writeDoubleBE(value);
    console.log([path, 'number', bits.toString('hex')].join('\t'));
  } else if (typeof value === 'string') {
    console.log([path, 'text', value.replace(/\n/g, '\\n')].join('\t'));
  } else {
    console.log([path, typeof value, value].join('\t'));
  }
}

const text = require('fs').readFileSync(process.argv[2], 'utf8');
walk('', yaml.parse(text, { version: process.argv[3], mapAsMap: true }));
