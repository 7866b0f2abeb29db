"""The weaver: chapters with what the build found in place of their directives, as pandoc's Markdown for LaTeX or for a page of the web.
    CT_PROGRAM=... CT_DATA=... CT_BUILD=... [CT_PAGE=NAME.html] weave.py CHAPTER.md ...
What cannot be found is told with file and line, and nothing is woven. A line by itself:
    <<equation ID [NAME ...]>>   the formula from the sheet as parsed, under its number; of several those named
    <<printed ID [NAME ...]>>    what the paper has instead, and why it cannot be
    <<function ID>>              the function of ref/ that carries the equation's number;  <<helper NAME>>  another one
    <<step ID>>                  a derivation step, its algebra, where it holds, and what is dropped
    <<verdict ID>>               a verdict;  <<findings VERDICT>>  a table of those that have it, and why
    <<run ARGUMENT ...>>         a command of the program, and what it prints
    <<rows KEY ...>> LINE        the line for each key, in place of @; @1 and @2 are the parts of a key A,B
    <<symbols>>, <<index>>       rows of tables: the quantities of the sheet, the index of equations
    <<places>>, <<verdicts>>     for the web: each equation with all that belongs to it; all verdicts
    ![CAPTION](plot:NAME)        a plot of data/;  ![CAPTION](graph:CHAPTER)  what a chapter's steps lead from and to
Within a line, the first two between dollars:
    <<number FILE ROW COLUMN DIGITS[*SCALE]>>   from data/FILE or build/FILE, the row by its first columns: A,B
    <<value NAME DIGITS[*SCALE] ARGUMENT ...>>  what a command of the program finds
    <<quote ID before|text|after>>    `text`, provided that the evidence of a verdict reads so
    <<count WHAT>>                    vectors, inputs, misprints, verdicts, or one kind of verdict
    [(7)](#eq:7), [section](#ID), [Figure](#fig:NAME), [](#ref:NAME)            have to lead somewhere"""
import collections
import csv
import itertools
import json
import os
import re
import subprocess
import sys
from pathlib import Path

PROGRAM, DATA, BUILD, web = os.environ["CT_PROGRAM"], Path(os.environ["CT_DATA"]), Path(os.environ["CT_BUILD"]), os.environ.get("CT_PAGE")


class Stop(Exception):
    """What cannot be woven."""


def stop(text):
    raise Stop(text)


def the(kind, table, name):
    return table[name] if name in table else stop(f"unknown {kind} '{name}'")


# ---- reading ----


def made(name):
    path = BUILD / name
    return path.read_text() if path.exists() else sys.exit(f"no {path}: run make check")


def output_of(arguments):
    done = subprocess.run([PROGRAM, *arguments.split()], capture_output=True, text=True)
    return "" if done.returncode else done.stdout


def by_id(rows):
    return {row["id"]: row for row in rows}


steps = by_id(json.loads(made("derivations.json"))["derivations"]["steps"])
claims = by_id(json.loads(made("claims.json"))["claims"])
sections = by_id(json.loads(made("equations.json")))
# (1) is no formula of the sheet: vectors are none of its quantities.
sections["eq01"]["display"] = [{"kind": "relation", "equation": "1", "defines": "", "tex": r"\boldsymbol\rho = (x,\; y,\; z)"}]
gate = by_id(csv.DictReader(made("gate.csv").splitlines()))

counts = collections.Counter(v["verdict"] for v in claims.values())
counts["misprints"] = sum((v["verdict"], v["kind"]) == ("holds as corrected", "equation") for v in claims.values())
counts["vectors"] = sum(int(g["vectors"]) for g in gate.values() if g["vectors"] != "-")
counts.update(verdicts=len(claims), inputs=json.loads(made("errors.json"))["errors"][0]["inputs"], refuted=0)


def span_of(names):
    """[2a, 2b, 2c] as the reader sees it: 2a to 2c."""
    return "–".join([names[0], names[-1]]) if len(names) > 2 else ", ".join(names)


QUALIFIER = {"lin": "small angles", "inv": "inverse", "exact": "exact", "roots": "roots", "flow": "flow", "rk4": "Runge-Kutta"}
# Of the sections that have a number one is named for it alone; (6) stands where (6a) does.
symbol = {name: "\\" + name for name in "pi lambda mu phi kappa epsilon rho omega cos sin tan".split()}
labels, section_of = {}, {}  # what is referred to: its number, its page
for s in sections.values():
    symbol.update((quantity["name"], quantity["tex"]) for quantity in s["inputs"] + s["outputs"])
    numbers = s["equations"] if s["id"][2:].isdigit() else []
    s["names"] = [name for number in numbers for name in [number, *re.findall(r"^(\d+)a$", number)]]
    labels.update(("eq:" + name, ("", "equations.html")) for name in s["names"])
    s["which"] = QUALIFIER.get(re.sub(r"^eq\d+|_.*", "", s["id"]), "")
    section_of.update((name, s["id"]) for name in s["names"])
    s["targets"] = "".join([rf"\place{{{s['id']}}}", *(rf"\target{{{name}}}" for name in s["names"])])  # for the index, and for references

# Chapters, figures of ours and references are numbered as they come; those without a number are the last chapters.
pages, page_of_step, letters, cited = [], {}, iter("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), itertools.count(1)
for path in sorted(Path("paper").glob("[0-9]*.md")):
    page, text = path.stem + ".html", path.read_text()
    title, name, unnumbered = re.search(r"^# (.*?) {#(\S+)( ?.*)}", text).groups()
    pages.append({"file": page, "title": title, "number": "" if unnumbered else str(len(pages) + 1)})
    labels[name] = pages[-1]["number"], page
    for name in re.findall(r"\]\((?:plot|graph):([\w-]+)\)", text):
        labels["fig:" + name] = name if re.fullmatch(r"\d[ab]?", name) else next(letters), page
    labels.update((name, (f"[{next(cited)}]", page)) for name in re.findall(r"{#(ref:\w+)}", text))
    page_of_step.update((name, page) for name in re.findall(r"\n<<step (\w+)>>", text))


def link(text, name):
    """What is referred to has its number after it."""
    number, page = the("reference", labels, name)
    text += ("\u00a0" if text and number else "") + number
    return f"[{text}]({page}#{name})" if web else rf"\hyperref[{name}]{{{text}}}"


# ---- Markdown ----


def formula(tex):
    return f"${tex.rstrip()}$"


def scientific(text):
    """In mathematics: 1.2e-03 has a power of ten."""
    digits, _, exponent = text.partition("e")
    return digits + (rf"\times 10^{{{int(exponent)}}}" if int(exponent or 0) else "")


def decimal(value, form):
    """So many significant digits: "3", or "3*SCALE"."""
    digits, _, scale = form.partition("*")
    value = float(value) * float(scale or 1)
    return scientific(f"{value:.{int(digits) - 1}e}" if abs(value) < 1e-3 else f"{value:#.{digits}g}".rstrip("."))


# A text of the sheet, of a step or of the program: its signs and powers that are numbers become mathematics, and names as one is told.
# What the program typeset has all of that between dollars.
SIGNS = {"<=": "le", ">=": "ge", "<<": "ll", "->": "to", "+-": "pm", "-+": "mp", "*": "cdot"}
MARKS = {
    r"\$[^$]*\$": lambda text: formula(text[1:-1]),
    r"-?\d+(?:\.\d+)?e[+-]?\d+": lambda text: formula(scientific(text)),
    r"\^-?\d+": lambda text: f"$^{{{text[1:]}}}$",
    r"\d[A-Za-z]|a(?= [A-Za-z])": str,
    r"[A-Za-z](?:\w|'(?=[A-Za-z]))*": None,
    r"(?:[<>]=|<<|->|\+-|-\+|\*)[\d.]*": lambda text: formula(re.sub(r"^[^\d.]+", lambda sign: f"\\{SIGNS[sign[0]]} ", text)),
    r"(?<![^ (])-(?:\d+(?:\.\d+)?|(?=[A-Za-z ]))": formula,
    r'[`*_{}[\]<>#|^@"]': r"\{}".format,
}
MARKED = re.compile("|".join(f"({pattern})" for pattern in MARKS), re.ASCII)


def plain(name):
    return name.replace("_", r"\_").replace("uC", "µC")


def symbolic(name):
    """A symbol of the sheet, or a letter with a digit or an index."""
    letter = re.fullmatch(r"([A-Za-z])(?:(\d?)|_([A-Za-z\d]+))", name)
    if name in symbol and name != "stable":
        return formula(symbol[name])
    return formula(letter[1] + (rf"_{{\mathrm{{{letter[2] or letter[3]}}}}}" if name[1:] else "")) if letter else plain(name)


def typeset(text, named=plain):
    makers = [make or named for make in MARKS.values()]
    return MARKED.sub(lambda mark: makers[mark.lastindex - 1](mark[0]), text).replace("$$", " ")


def raw(text, form="latex"):
    """What one of the two formats has alone; the other leaves it out."""
    return f"\n\n```{{={form}}}\n{text}\n```\n\n"


def raw_inline(text):
    return f"`{text}`{{=latex}}"


def box(kind, text, name=None):
    """Blocks of a class: what LaTeX calls an environment."""
    if web:
        return f"\n\n::: {{.{kind}{f' #{name}' if name else ''}}}\n{text}\n:::\n\n"
    return raw(rf"\begin{{{kind.split()[0]}}}") + text + raw(rf"\end{{{kind.split()[0]}}}")


def details(summary, text):
    """What a reader opens on demand."""
    return raw(f"<details><summary>{summary}</summary>", "html") + text + raw("</details>", "html")


# ---- equations ----

ASIDE = {"let": r"\text{with}\quad ", "domain": r"\text{for}\quad "}


def group(kind, texts):
    """Rows that share a number, side by side where they are short, or as many in a line as it holds."""
    longest = max(map(len, texts))
    if len(texts) == 1 and kind not in ASIDE:
        return texts[0]
    if len(texts) == 1 or longest < 32 and kind in ("relation", "domain"):
        return ASIDE.get(kind, "") + r",\quad ".join(texts).replace("&", "")
    columns = 1 if len(texts) < 6 else max(138 // longest, 1)
    lines = [r" &\qquad ".join(texts[k : k + columns]) for k in range(0, len(texts), columns)]
    return ASIDE.get(kind, "") + "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}"


def display(s, named, suffix, place="", kinds=("relation", "output", "let", "domain")):
    """A display of a section's rows of these kinds, of several formulas those named. Each line has its number, but for what stands
    aside. Lines that stand alone are aligned at their signs; groups have their own alignment and are centred."""
    defined = {row["defines"]: row for row in s["display"]}
    only = [the("output or named subexpression", defined, name) for name in named.split()]
    taken = [row["equation"] for row in s["display"] if row["kind"] == "relation"]
    free = span_of([number for number in s["equations"] if number not in taken])

    def kind_and_number(row):
        return row["kind"], "" if row["kind"] in ASIDE else row["equation"] or free

    rows = [row for row in s["display"] if row["kind"] in kinds and (not only or row in only or row["kind"] == "relation")]
    lines = [(number, group(kind, [row["tex"] for row in same])) for (kind, number), same in itertools.groupby(rows, kind_and_number)]
    out, aligned = [], not web and all(tex.count("&") == 1 for _, tex in lines)
    for number, tex in lines:
        tex = tex if aligned or "{aligned}" in tex else tex.replace("&", "")
        tag = number and number + (suffix and ", " + suffix)
        out.append(box("equation", f"$${tex}$$" + (tag and f"[({tag})]{{.number}}")) if web else
                   tex + (rf"\tag{{{tag.replace('–', '--')}}}" if tag else r"\notag"))
    kind = "align" if aligned else "gather"
    return "".join(out) if web else raw(f"\\joined{place}%\n\\begin{{{kind}}}\n" + " \\\\\n".join(out) + f"\n\\end{{{kind}}}")


LONGEST_KEPT = 26  # code of more lines would leave much of a page empty, and may be torn on paper


def code(text, path=""):
    if web:
        return "\n\n```{." + (f'c title="{path}"' if path else "terminal") + f"}}\n{text}\n```\n\n"
    kind, title = ("code", f"{{{path}}}") if path else ("terminal", "")
    listed = raw(f"\\begin{{{kind}}}{title}\n{text}\\end{{{kind}}}")
    return box("keep", listed) if text.count("\n") < LONGEST_KEPT else listed


def helper(name):
    """A function of ref/ by its name, as it stands there."""
    for path in Path("ref").glob("*.c"):
        if found := re.search(rf"(?ms)^[A-Za-z][^\n;{{}}]*\b{re.escape(name)}\([^;{{}}]*\)\n{{\n.*?\n}}\n", path.read_text()):
            return code(found[0], path)
    return stop(f"unknown function '{name}'")


# ---- steps and verdicts ----


def references(entries):
    """Equation numbers, sections or formulas of them, principles and properties, each once."""
    out = []
    for entry in entries:
        base, _, name = entry.partition(".")
        number = re.match(r"\d+", sections[base]["equations"][0])[0] if base in sections else entry if entry in section_of else None
        formula_there = "\u00a0" + formula(symbol.get(name) or re.sub("_(.*)", r"_{\1}", name)) if name else ""
        out.append(link(f"({number})", f"eq:{number}") + formula_there if number else plain(entry))
    return ", ".join(dict.fromkeys(out))


def algebra(line):
    """Equalities one after the other, and how one comes to them."""
    how, chain, rows = typeset(line["how"], symbolic), " = ".join(line["tex"]), line["tex"][0] + " &= " + r" \\ &= ".join(line["tex"][1:])
    return (f"{how}: {formula(chain)}" if web else raw_inline(r"\derive{") + how + raw_inline(f"}}{{{chain}}}{{{rows}}}")) + "\n\n"


def name_of(v):
    return f"[{v['id']}](verdicts.html#{v['id']}){{.id}}" if web else raw_inline(rf"\claim{{{v['id']}}}")


def verdict_box(v, name=None):
    """On paper the evidence follows at once; on the web a reader opens it, and the reason stands before it."""
    proof = typeset(v["evidence_tex"]) + "."
    text = f"**{v['verdict']}:** {typeset(v['claim_tex'])} ({typeset(v['where'])}) {name_of(v)}\n\n"
    why = typeset(v.get("why_tex", "")) + details(f"evidence, {v['how']}", proof)
    return box("verdict ." + v["verdict"].split()[0], text + (why if web else box("evidence", f"*Evidence ({v['how']}):* {proof}")), name)


# ---- directives ----


def number(file, key, column, form):
    path = next((folder / file for folder in (DATA, BUILD) if (folder / file).exists()), None) or stop(f"no file '{file}'")
    found = [row for row in csv.DictReader(path.read_text().splitlines()) if (",".join(row.values()) + ",").startswith(key + ",")]
    if len(found) != 1:
        stop(f"'{file}' has {len(found)} rows '{key}'")
    text = the(f"column of '{file}'", found[0], column)
    return decimal(text, form) if re.match(r"-?\d", text) else stop(f"'{text}' is no number")


def value(name, form, arguments):
    found = re.search(rf"\b{name} += +(\S+)", output_of(arguments))
    return decimal(found[1], form) if found else stop(f"coulomb-tether {arguments} gives no '{name}'")


def quote(name, reading):
    before, text, after = (reading + "||").split("|")[:3]
    if not text:
        stop("expected <<quote ID before|text|after>>")
    if before + text + after not in the("verdict", claims, name)["evidence"]:
        stop(f"the evidence of '{name}' does not read '{before + text + after}'")
    return scientific(text) if re.fullmatch(r"-?[\d.]+(e[+-]?\d+)?", text) else typeset(text)


def count(what):
    return str(the("count", counts, what))


def equation(name, named=""):
    s = the("equation", sections, name)
    return display(s, named, s["which"], s["targets"]) if s["display"] else stop(f"'{name}' has no formula in the sheet")


def printed(name, named=""):
    s = the("equation", sections, name)
    reason = s.get("reason") or stop(f"'{name}' is printed as the sheet has it")
    return "\n\n**As printed.** " + typeset(reason, symbolic) + display(s, named, "as printed", kinds=["printed"])


def function(name):
    s = the("equation", sections, name)
    return ("" if s["display"] else raw(s["targets"])) + helper(gate[name]["function"])


def step(name):
    s = the("derivation step", steps, name)
    if s["step"]["finding"] != "holds":
        stop(f"step '{name}' does not hold: {s['step']['evidence']}")
    leads = references(s["from"]) + (r" $\;\rightarrow\;$ " + references(s["to"]) if s["to"] else "")
    how = f"to order {s['order']}" if "order" in s else "exactly"
    text = rf"$\vdash$ `{name}`: {typeset(s['title'], symbolic)}. {leads}. *Proved {how}, for {typeset(s['domain'], symbolic)}.*"
    text += details("the algebra, line by line", "".join(map(algebra, s["lines"])))
    if "printed" in s:
        text += f"\n\nAs printed the sides differ: {typeset(s['printed']['evidence'].split('; ', 1)[1], symbolic)}."
    if "dropped" in s:
        bounds = re.sub(r"(\w+) -(\S+) \.\.\. \2", r"|\1| <= \2", s["dropped"])  # its units are letters, too
        text += f"\n\nCertified: {typeset(bounds, lambda name: symbolic(name) if len(name) > 1 and name in symbol else plain(name))}."
    return box("step", text, f"step-{name}")


def verdict(name):
    return verdict_box(the("verdict", claims, name))


def verdicts():
    return "".join(verdict_box(v, name) for name, v in claims.items())


def run(arguments):
    return code(f"$ coulomb-tether {arguments}\n" + (output_of(arguments) or stop(f"coulomb-tether {arguments} failed")))


def findings(kind):
    the("verdict", counts, kind)
    rows = [f"| {typeset(v['claim_tex'])} {name_of(v)} | {typeset(v['where'])} | {typeset(v.get('why_tex', ''))} |"
            for v in claims.values() if v["verdict"] == kind]
    head = ["| claim | where | why |", f"|{'-' * 37}|{'-' * 19}|{'-' * 44}|"]
    return box("findings", "\n".join(head + rows)) if rows else "None."


def symbols():
    """The heads of this table and the next stand in their chapters. In the sheet: "  NAME ...: {unit: U, ..., meaning: M}"."""
    rows, sheet = "", re.search(r"\nquantities:\n(.*?)\n[a-z]", Path("paper/equations.yaml").read_text(), re.DOTALL)[1]
    for names, unit, meaning in re.findall(r'  ([^:\n]+): {unit: "?([^,"]*).*meaning: "?(.*?)"?}', sheet):
        # A rate may be computed nowhere.
        tex = [symbol.get(name) or r"\dot " + symbol[name.replace("_dot", "", 1)] for name in re.findall(r"\w+", names)]
        rows += f"| {', '.join(map(formula, tex))} | {typeset(unit.strip('-'))} | {typeset(meaning, symbolic)} |\n"
    return rows[:-1]


def error_of(g):
    return formula(decimal(g["error"], "2")) if g["error"][0].isdigit() else g["error"]


def index():
    rows = ""
    for name, g in gate.items():
        place = f"[¶](equations.html#{name})" if web else raw_inline(rf"\pageref{{place:{name}}}")
        numbers = span_of([link(f"({number})", f"eq:{number}") for number in sections[name]["equations"]])
        cells = [f"{numbers} {sections[name]['which']}", place, f"`{g['function']}`", g["tests"], error_of(g), g["vectors"], g["verdict"]]
        rows += f"| {' | '.join(cells)} |\n"
    return rows[:-1]


def places():
    return "".join(map(place_of, sections.values()))


def place_of(s):
    """An equation with all that belongs to it."""
    name, g, q = s["id"], gate[s["id"]], s["which"]
    out = f"\n\n## [¶](#{name}){{.permalink}} ({span_of(s['equations'])}) {typeset(s['title'], symbolic)}{q and ', ' + q} {{#{name}}}\n\n"
    out += raw("".join(f'<a id="eq:{number}"></a>' for number in s["names"]), "html")
    out += display(s, "", q) + typeset(s.get("note", ""), symbolic) + (printed(name) if "reason" in s else "")
    said = [claims["equation-" + number] for number in s["names"] if "equation-" + number in claims]
    for _, same in itertools.groupby(said, lambda v: (v["claim"], v["evidence"])):  # once where (2a), (2b) and (2c) have the same
        out += verdict_box(next(same))

    def named_in(key):
        return [step for step in steps.values() if any(section_of.get(entry, entry.split(".")[0]) == name for entry in step[key])]

    if proofs := named_in("to"):
        by = ", ".join(f"[`{step['id']}`]({page_of_step[step['id']]}#step-{step['id']})" for step in proofs)
        out += f"\n\n**Comes from** {references(entry for step in proofs for entry in step['from'])}, by {by}"
    if to := references(entry for step in named_in("from") for entry in step["to"]):
        out += f"\n\n**Leads to** {to}"
    if g["vectors"] != "-":
        measured = f"The largest backward error of the function is {error_of(g).replace('$', '$E=', 1)} on {counts['inputs']} random inputs;"
        out += details(f"C: <code>{g['function']}</code>", helper(g["function"]))
        out += f"\n\n**Error and vectors.** {'Judged by correct digits;' if g['error'] == 'digits' else measured} {g['tests']} tests, "
        out += f"[{g['vectors']} golden vectors](data/{name}.csv.gz). How to check yours:"
        out += code(f"coulomb-tether conform --only {name} -- ./my-client")
    return out


# ---- figures ----


def graph_of(chapter):
    """What a chapter's steps lead from and to. Steps are filled boxes, equations ellipses and where they are definitions octagons,
    what steps lead to besides notes, what none leads to houses."""
    reached = {entry.split(".")[0] for step in steps.values() for entry in step["to"]}
    lines = []

    def node(entry):
        name = re.sub(r"^(?:eq)?0*(\d+).*|\..*", r"\1", entry)  # "6a", "eq06" and "eq06.x1" are the node 6
        shape, url = "note" if name in reached else "house", ""
        if name.isdigit():
            shape, url = "doubleoctagon" if gate[section_of[name]]["function"] == "(definition)" else "ellipse", "equations.html#eq:" + name
        lines.append(f'"{name}" [style=solid, shape={shape}, URL="{url}"]')
        return name

    for step in (step for step in steps.values() if page_of_step[step["id"]] == chapter + ".html"):
        lines.append('"{0}" [label="{1}", URL="#step-{0}"]'.format(step["id"], step["id"].replace("_", " ")))
        lines.extend(f'"{node(entry)}" -> "{step["id"]}" [arrowhead=none]' for entry in step["from"])
        lines.extend(f'"{step["id"]}" -> "{node(entry)}"' for entry in step["to"])
    return ("strict digraph { bgcolor=transparent; ranksep=0.3; nodesep=0.06; margin=0; node [fontname=Helvetica, fontsize=10, "
            'height=0.1, width=0.1, margin="0.03,0.02", shape=box, style=filled, fillcolor="#eeeeee"];' + ";".join(lines) + "}")


def figure(caption, kind, name):
    if not Path(the("picture", {"plot": f"paper/figures/plot-{name}.gp", "graph": f"paper/{name}.md"}, kind)).exists():
        stop(f"unknown picture '{kind}:{name}'")
    if not caption:
        stop(f"'{kind}:{name}' has no caption")
    number, _ = labels.get("fig:" + name, ("", ""))  # pages between the chapters have none
    named = number and f"Figure {number}"
    drawn = f'<img src="plot-{name}.svg" alt="{named}">'
    if kind == "graph":
        form = ["-Tsvg"] if web else ["-Tpdf", "-o", f"{BUILD}/paper/graph-{name}.pdf"]
        drawn = subprocess.run(["dot", *form], input=graph_of(name), capture_output=True, text=True, check=True).stdout
    if web:
        begin = raw(f'<figure id="fig:{name}">{drawn[drawn.find("<svg"):] if kind == "graph" else drawn}<figcaption>', "html")
        return begin + (named and f"**{named}.** ") + caption + raw("</figcaption></figure>", "html")
    begin = raw_inline(rf"\begin{{figure}}[tbp]\centering\{kind}{{{name}}}\def\thefigure{{{number}}}\caption{{")
    return begin + caption + raw_inline(rf"}}\label{{fig:{name}}}\end{{figure}}")


# ---- the document ----

WITHIN = {make.__name__: make for make in (number, value, quote, count)}
BY_ITSELF = {make.__name__: make for make in (
    equation, printed, function, helper, step, verdict, findings, run, symbols, index, places, verdicts)}


def put(kind, directives, name, rest):
    """What stands for a directive: its function of its words, of which the last one has all the rest."""
    make = the(kind, directives, name)
    most, least = make.__code__.co_argcount, make.__code__.co_argcount - len(make.__defaults__ or ())
    words = rest.split(" ", most - 1) if most else []
    return make(*words) if len(words) >= least else stop("expected " + re.search(f"<<{name} .*?>>", __doc__)[0])


def woven(line):
    if rows := re.match(r"<<rows ([^>]*)>> *(.*)$", line):
        return "\n".join(woven(re.sub(r"@(\d?)", lambda at: [key, *key.split(",")][int(at[1] or 0)], rows[2])) for key in rows[1].split())
    whole = re.fullmatch(r"<<([a-z]*) *(.*)>>", line)
    if whole and whole[1] not in WITHIN:
        return put("directive", BY_ITSELF, *whole.groups())

    def within(found):
        text, name, rest = found.groups()
        if name in ("number", "value") and line[: found.start()].count("$") % 2 == 0:
            stop(f"'{text}' is mathematics, expected dollars around it")
        return put("directive within a line", WITHIN, name, rest)

    line = re.sub(r"<<(([a-z]*) *(.*?))>>", within, line)
    if "<<" in line:
        stop("'<<' without its '>>' on the same line")
    line = re.sub(r"\[([^][]*)\]\(#([^\s()]+)\)", lambda found: link(*found.groups()), line)
    if web:
        line = re.sub(r"^# (.*) {#(\S+)}$", lambda head: f"# {labels[head[2]][0]} {head[1]} {{#{head[2]}}}", line)
    else:
        line = re.sub(r"\[\]{#(ref:\w+)}", r"\\phantomsection\\label{\1}", line)
    picture = re.fullmatch(r"!\[(.*)\]\(([^():]*):([^()]*)\)", line)
    return figure(*picture.groups()) if picture else line


out, problems = [], []
for path in sys.argv[1:]:
    for at, line in enumerate(Path(path).read_text().split("\n"), 1):
        try:
            out.append(woven(line))
        except Stop as problem:
            problems.append(f"{path}:{at}: {problem}")
if problems:
    sys.exit("\n".join(problems))
text, meta = "\n".join(out), {"title": "The Coulomb tether, checked by machine", "pages": pages}
if web:
    # In MathML upright letters are text, or each would be one of its own; and a product has its space anyway.
    text = re.sub(r"\\mathrm({[^{}]*})", r"{\\text\1}", text).replace(r"\,", " ")
    for before, page, after in zip([None, *pages], pages, [*pages[1:], None]):
        if page["file"] == web:
            meta |= {"title": page["title"], "before": before, "after": after}
else:
    text = re.sub(r"(?ms)^::: (\w+)$(.*?)^:::$", lambda found: box(found[1], found[2]), text)
print(f"---\n{json.dumps(meta)}\n---\n\n{text}")
