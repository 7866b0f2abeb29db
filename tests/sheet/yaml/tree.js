// YAML files as lines: file and path, number or text, value; by the package yaml, as YAML 1.1, and as YAML 1.2 where that is otherwise.
const yaml = require('yaml');
const { isDeepStrictEqual } = require('util');

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

for (const file of process.argv.slice(2)) {
  const text = require('fs').readFileSync(file, 'utf8');
  const [tree, newer] = ['1.1', '1.2'].map(version => yaml.parse(text, { version, mapAsMap: true }));
  walk(file, tree);
  if (!isDeepStrictEqual(tree, newer)) walk(`${file} as YAML 1.2`, newer);
}
