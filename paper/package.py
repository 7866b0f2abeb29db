"""data/datapackage.json (Frictionless Data, tabular data package) of the words of paper/package.json, the quantities and titles of
the sheet, the meanings of a design, and the files:
    coulomb-tether design n=12 --json | package.py VERSION paper/package.json build/equations.json FILE..."""
import hashlib
import json
import re
import sys
from pathlib import Path

version, words, sheet, *paths = sys.argv[1:]
words, sheet, design = json.load(open(words)), json.load(open(sheet)), json.load(sys.stdin)

# What paper/package.json says of a column goes before the sheet, and this before a design. That is in SI, data/ in units of L_ref and Omega.
of_rest = {"m": "L_ref", "rad/s": "Omega", "m/s": "Omega L_ref", "m/s^2": "Omega^2 L_ref"}
columns = {q["name"]: {"unit": of_rest.get(q["unit"]), "meaning": q["meaning"]} for q in design["outputs"]}
columns.update((q["name"], q) for section in reversed(sheet) for q in reversed(section["inputs"] + section["outputs"]))
columns.update(words["columns"])
titles = words["files"] | {"golden-" + section["id"]: section["title"] for section in sheet}


def field(name):
    prefix, base, suffix = re.fullmatch(f"({'|'.join(words['prefixes'])}|)(.*?)({'|'.join(words['suffixes'])}|)", name).groups()
    column = columns.get(base, {"type": "string"})
    meaning = column.get("meaning") and words["prefixes"].get(prefix, "") + column["meaning"] + words["suffixes"].get(suffix, "")
    known = {"name": name, "type": column.get("type", "number"), "unit": column.get("unit"), "description": meaning}
    return "    " + json.dumps({key: text for key, text in known.items() if text})


def resource(path):
    content = Path(path).read_bytes() if Path(path).exists() else b""
    within = re.search(r"(golden/)?[^/]*$", path)[0]
    name = within.split(".")[0].replace("/", "-")
    if not content or name not in titles:
        sys.exit(f"package: {path}: " + ("has no title in paper/package.json" if content else "expected a header line"))
    checksum = "sha256:" + hashlib.sha256(content).hexdigest()
    described = [
        {"name": name, "path": within, "profile": "tabular-data-resource"},
        {"title": titles[name]},
        {"format": "csv", "mediatype": "text/csv", "encoding": "utf-8", "bytes": len(content), "hash": checksum},
    ]
    lines = ",\n   ".join(json.dumps(part)[1:-1] for part in described)
    fields = ",\n".join(map(field, content.decode().split("\n", 1)[0].split(",")))
    return f'  {{{lines},\n   "schema": {{"missingValues": [""], "fields": [\n{fields}]}}}}'


head = ",\n ".join(json.dumps({key: value})[1:-1] for key, value in (words["package"] | {"version": version}).items())
print(f'{{{head},\n "resources": [\n' + ",\n".join(map(resource, paths)) + "\n ]}")
