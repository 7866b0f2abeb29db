"""The verdicts as data/verdicts.csv (RFC 4180), or as README's table of what does not simply hold:
    claims.py csv|markdown <build/claims.json"""
import csv
import itertools
import json
import re
import sys

claims = json.load(sys.stdin)["claims"]
if sys.argv[1] == "csv":
    rows = csv.DictWriter(sys.stdout, "id where kind claim verdict how evidence".split(), extrasaction="ignore", lineterminator="\n")
    rows.writeheader()
    rows.writerows(claims)
else:
    print("| where | claim | verdict | why |\n|---|---|---|---|")
    # Rows that differ in their place alone are one.
    for row, same in itertools.groupby((c for c in claims if "why" in c), lambda c: [c["claim"], c["verdict"], c["why"]]):
        cells = [", ".join(c["where"] for c in same), *row]
        print("|", " | ".join(re.sub(r"[|*_]", r"\\\g<0>", cell.replace("<", "&lt;")) for cell in cells), "|")
