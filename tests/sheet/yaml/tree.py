"""tree.py TYPED UNTYPED FILE...: YAML files as lines, file and path, number or text, value; in UNTYPED text that is a decimal number is one."""
import re
import struct
import sys

import yaml

NUMBER = re.compile(r'[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\Z')


def walk(to, untyped, path, value):
    if isinstance(value, dict):
        for key, item in value.items():
            walk(to, untyped, f'{path}/{key if isinstance(key, str) else type(key).__name__ + " " + repr(key)}', item)
    elif isinstance(value, list):
        for i, item in enumerate(value):
            walk(to, untyped, f'{path}/{i}', item)
    elif isinstance(value, (int, float)) and not isinstance(value, bool) or untyped and isinstance(value, str) and NUMBER.match(value):
        print(path, 'number', struct.pack('>d', float(value)).hex(), sep='\t', file=to)
    elif isinstance(value, str):
        print(path, 'text', value.replace('\n', '\\n'), sep='\t', file=to)
    else:
        print(path, type(value).__name__, value, sep='\t', file=to)


trees = {name: yaml.safe_load(open(name, encoding='utf-8')) for name in sys.argv[3:]}
for untyped in False, True:
    with open(sys.argv[1 + untyped], 'w', encoding='utf-8') as to:
        for name, tree in trees.items():
            walk(to, untyped, name, tree)
