"""A YAML file as lines: path, number or text, value. With 'untyped', text that is a decimal number is one."""
import re
import struct
import sys

import yaml

UNTYPED = sys.argv[2:] == ['untyped']
NUMBER = re.compile(r'[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?\Z')


def walk(path, value):
    if isinstance(value, dict):
        for key, item in value.items():
            walk(f'{path}/{key if isinstance(key, str) else type(key).__name__ + " " + repr(key)}', item)
    elif isinstance(value, list):
        for i, item in enumerate(value):
            walk(f'{path}/{i}', item)
    elif isinstance(value, (int, float)) and not isinstance(value, bool) or UNTYPED and isinstance(value, str) and NUMBER.match(value):
        print(path, 'number', struct.pack('>d', float(value)).hex(), sep='\t')
    elif isinstance(value, str):
        print(path, 'text', value.replace('\n', '\\n'), sep='\t')
    else:
        print(path, type(value).__name__, value, sep='\t')


sys.stdout.reconfigure(encoding='utf-8')
with open(sys.argv[1], encoding='utf-8') as file:
    walk('', yaml.safe_load(file))
