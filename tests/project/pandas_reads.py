"""data/ as pandas reads it: with float_precision="round_trip" every number is the nearest binary64 and no column is
lost; without, a number is at most a few roundings off. Prints a line for each failure; exit status 1 if there was one."""
import csv
import glob
import math
import sys

import pandas

# Without round_trip pandas sums up 17 digits (two roundings) and scales by a power of ten (two more); digits that it
# leaves out are less than one.
FEW = 5 * 2.0**-53


def number(text):
    try:
        return float(text)
    except ValueError:
        return None


failures = numbers = off = 0
for path in sorted(glob.glob("data/**/*.csv", recursive=True)):
    with open(path, newline="") as file:
        header, *rows = csv.reader(file)
    exact = pandas.read_csv(path, float_precision="round_trip")
    plain = pandas.read_csv(path)
    if list(exact.columns) != header or len(exact) != len(rows):
        print(f"{path}: columns or rows are lost")
        failures += 1
        continue
    for name in header:
        if exact[name].dtype.kind != "f":
            continue
        for text, x, y in zip((row[header.index(name)] for row in rows), exact[name], plain[name]):
            due = number(text)
            if due is None or math.isnan(due):
                good = math.isnan(x) and math.isnan(y)
            else:
                good = x == due and (y == due or abs(y - due) <= FEW*abs(due))
                numbers += 1
                off += y != due
            if not good:
                print(f"{path}: {name} = {text} is read as {x!r}, without round_trip as {y!r}")
                failures += 1
print(f"pandas {pandas.__version__} reads {numbers} numbers, {off} of them a few roundings off without round_trip")
sys.exit(failures > 0)
