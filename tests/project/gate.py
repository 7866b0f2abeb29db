"""The gate: each equation of the sheet has its function, an executed passing test, a measured error, a proof, golden vectors, a
verdict and a place in the edition; and none of these names an equation that the sheet lacks.
    BUILD=FOLDER [DATA=FOLDER] gate.py
It reads what was executed: Check's TAP logs, the proofs and errors as the program printed them. A line a section of the sheet, then
a line a broken link; the last line counts, and the status is 1 where a link is broken. Where none is, it writes BUILD/gate.csv."""
import collections
import csv
import glob
import json
import os
import re
import sys

build, data = os.environ["BUILD"], os.environ.get("DATA", "data")
QUALIFIER = {"": "", "lin": ", small angles", "inv": ", inverse", "exact": ", exact", "roots": ", roots",
             "flow": ", flow", "rk4": ", Runge-Kutta"}
problems = []


def broken(name, text):
    problems.append((name, text))


def expect(name, true, text):
    if not true:
        broken(name, text)


def known(place, text, true):
    """What names an equation that the sheet lacks is no link."""
    expect(place, true, text + ", which the sheet lacks")
    return true


def made(name):
    path = f"{build}/{name}.json"
    if not os.path.exists(path):
        sys.exit(f"gate: no {path}: run make check")
    with open(path, encoding="utf-8") as file:
        return json.load(file, parse_float=str)


def lines_of(pattern):
    for path in sorted(glob.glob(pattern)):
        with open(path, encoding="utf-8") as file:
            for at, line in enumerate(file, 1):
                yield path, at, line


def base_of(number):
    return re.sub("[a-z]$", "", number)


# ---- the sheet ----

sections = {s["id"]: s for s in made("equations")}
numbers = {number for s in sections.values() for number in s["equations"]}
whole = set(map(base_of, numbers))
for name, s in sections.items():
    # Its key in ref/, "10, small angles", and its tests' prefix, eq10_small_angles: what stands around the digits of its id says
    # which of that number it is.
    number, which = int(re.search(r"^eq(\d+)|$", name)[1] or base_of(s["equations"][0])), QUALIFIER[re.sub(r"^eq\d+|_.*", "", name)]
    s["key"], s["prefix"] = f"{number}{which}", f"eq{number:02}" + re.sub(", |[ -]", "_", which.lower())
    s["algorithm"] = s["computes"] and "formula" not in s

# ---- ref/: a header comment begins "Eq. (10), small angles   purpose" or "Eqs. (3a)-(3c)   purpose", its function is next ----

functions, header = collections.defaultdict(list), ""
for path, _, line in lines_of("ref/*.c"):
    if found := re.match(r" \* Eqs?\. \((\d+)[^,]*(,.*)?", line.rstrip().split("   ")[0]):
        header = found[1] + (found[2] or "")
    elif header and (found := re.match(r"(?!typedef)[a-z][^(]*?(\w+)\(.*[^;]$", line)):
        known("ref/", f"{found[1]} carries Eq. ({header})", header.split(",")[0] in whole)
        functions[header].append(found[1])
        header = ""

# ---- tests: eq10_small_angles_whole_numbers is one of section eq10lin ----

executed, passed = False, collections.Counter()
for _, _, line in lines_of(f"{build}/tests/*.tap"):
    if found := re.search(r":(([a-z]+)0*(\d*)[a-z0-9_]*): ", line):
        executed, (test, kind, number) = True, found.groups()
        if kind == "eq" and number and known("tests/", f"{test} tests ({number})", number in whole) or re.match("flow_|rk4_", test):
            owners = {part: name for name, s in sections.items() for part in (name, s["prefix"]) if test.startswith(part + "_")}
            owner = owners.get(max(owners, key=len, default=""))
            passed[owner] += line.startswith("ok ")
            expect(owner, line.startswith("ok "), f"test {test} failed")

# ---- errors, proofs, vectors, verdicts ----

worst = {error["id"]: error["worst_E"] for error in made("errors")["errors"]}
for name, error in worst.items():
    known("errors", f"{name} was measured", name in sections)
    expect(name, float(error) <= 8, f"ref errs by {error} roundings, at most 8 are expected")  # what `coulomb-tether verify errors` allows

# A step leads to a number or to all of its equation, "eq42.margin1" to the numbers of its section. Which of these an output has, and
# that every one is reached, the verifier says.
steps_to = collections.defaultdict(list)
for step in made("derivations")["derivations"]["steps"]:
    for entry in step["from"] + step["to"]:
        if entry[0].isdigit():
            known("derivations", f"step {step['id']} names ({entry})", entry in numbers | whole)
    holds = step["step"]["finding"] == "holds"
    expect("derivations", holds, f"step {step['id']} does not hold")
    for entry in step["to"] if holds else []:
        section = sections.get(entry.split(".")[0])
        for number in section["equations"] if section else [entry]:
            steps_to[number].append(step["id"])

vectors = collections.Counter()
for path, _, line in lines_of(f"{data}/golden/*.csv"):
    name = os.path.basename(path).removesuffix(".csv")
    vectors[name] += line.startswith(name + "-")
for name in vectors:
    known("golden", f"{data}/golden/{name}.csv has vectors of {name}", name in sections)

with open(f"{data}/verdicts.csv", encoding="utf-8") as file:
    rulings = {row["id"][9:]: row["verdict"] for row in csv.DictReader(file) if row["id"].startswith("equation-")}
for number in rulings:
    known("verdicts", f"equation-{number} is a verdict on ({number})", number in numbers | whole)

# ---- the edition: its chapters are the numbered files ----

places, listed = {}, set()
for path, at, line in lines_of("paper/[0-9]*.md"):
    if found := re.match(r"<<(equation|printed|function) (\w+)", line):
        kind, name = found.groups()
        is_place = known("edition", f"{path}:{at} names {name}", name in sections) and (kind == "equation" or sections[name]["algorithm"])
        if is_place and kind != "printed":
            places.setdefault(name, f"{path}:{at}")
        if kind == "function":
            listed.add(name)

# ---- what is missing, and the table ----

form = "{:14} {:39} {:>5} {:>6} {:>5} {:>7}  {:19} {}".format
rows, good = [["id", "equations", "function", "tests", "error", "vectors", "steps", "verdict", "edition"]], 0
expect("tests/", executed, f"no executed tests, expected Check's TAP logs in {build}/tests/")
print(form("equation", "function in ref/", "tests", "E <=", "steps", "vectors", "verdict", "edition"))
for name, s in sections.items():
    key, carriers, proofs, verdicts = s["key"], functions[s["key"]], {}, {}
    for number in s["equations"]:
        leading = steps_to[number] + (steps_to[base_of(number)] if base_of(number) != number else [])
        expect(name, leading or not s["computes"], f"no derivation step leads to ({number})")
        expect(name, number in rulings, f"no verdict equation-{number} in {data}/verdicts.csv")
        proofs.update(dict.fromkeys(leading))
        verdicts[rulings.get(number, "")] = True
    if s["computes"]:
        expect(name, len(carriers) == 1, f"{len(carriers)} functions in ref/ with the header Eq. ({key}), expected one")
        expect(name, passed[name], f"no passing test, expected one named {s['prefix']}_... in {build}/tests/*.tap")
        if re.match("flow_|rk4_", name):
            worst[name] = "digits"  # a motion has no error in roundings: its vectors are judged by digits
        expect(name, name in worst, f"no measured error in {build}/errors.json")
        expect(name, vectors[name], f"no golden vectors in {data}/golden/{name}.csv")
        expect(name, name in listed, f"its function is not in the edition, expected <<function {name}>> in paper/*.md")
    else:
        expect(name, not carriers, f"is a definition, yet {''.join(carriers[-1:])} in ref/ carries Eq. ({key})")
        carriers = ["(definition)"]
    expect(name, s["algorithm"] or name in places, f"no place in the edition, expected <<equation {name}>> in paper/*.md")
    link = [(carriers or ["-"])[-1], passed[name] or "-", worst.get(name, "-")]
    verdict, place, count = ", ".join(verdicts), places.get(name, ""), vectors[name] or "-"
    bad = any(of == name for of, _ in problems)
    print(form("! " * bad + name, *link, len(proofs) or "-", count, verdict or "-", place or "-"))
    rows.append([name, " ".join(s["equations"]), *link, count, " ".join(proofs), verdict, place])
    good += not bad
for name, text in problems:
    print(f"gate: {name}: {text}")
print(f"gate: {good} of {len(sections)} equations have every link" + (f"; {len(problems)} broken" if problems else ""))
if problems:
    sys.exit(1)
with open(f"{build}/gate.csv.tmp", "w", encoding="utf-8") as file:
    csv.writer(file, lineterminator="\n").writerows(rows)
os.replace(f"{build}/gate.csv.tmp", f"{build}/gate.csv")
