"""Mutants: wrong programs, one point away from the right one, and whether the tests notice.

    python3 coverage/mutants.py BUILD [--kind tokens|soundness] [--sample N] [--seed S] [--only FILE, or how its name begins]
                                      [--budget SECONDS] [--workers N] [--readme]

All mutants of C are in one program: a function that has some is there once for each, beside the right one, and the environment
says which of them is called (mutants.c). Only what a macro or a table has wrong is compiled by itself; a sheet that is wrong is
read instead of the one in the program. Verdicts are kept in BUILD/results.csv by the mutant's content: a run that was cut short
goes on, a kill stands, a survivor is asked again once anything in the project has changed. coverage/README.md tells the rest.
"""
import argparse
import collections
import concurrent.futures
import csv
import hashlib
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import threading

from mutants_of import mutants

ROOT = pathlib.Path.cwd()
LISTED, README = ROOT / 'coverage/survivors.csv', ROOT / 'coverage/README.md'
KINDS = ('tokens', 'soundness')
PROGRAM, SHEETS = 'build/coulomb-tether', ('paper/equations.yaml', 'paper/derivations.yaml', 'paper/claims.yaml')
STRICT = ('ref/', SHEETS[0])  # all that is equivalent there is listed, so that of a sample too nothing may survive
TOO_MANY, OF_THEM = ('verify/', 'tokens'), 250  # are sampled always
FILES = [str(file.relative_to(ROOT)) for folder in ('', 'coverage', 'data', 'paper', 'ref', 'tests', 'verify')
         for file in sorted((ROOT / folder).glob('**/*' if folder else '*')) if file.is_file()]
WORLD = hashlib.sha256(b''.join((ROOT / file).read_bytes() for file in FILES if not file.startswith('coverage/'))).hexdigest()[:20]


class Mutant:
    """text[start:end] of a file replaced; `number` is that in the program of all, `function` that of the first in its function."""

    def __init__(self, file, kind, right, start, end, by, what):
        self.file, self.kind, self.right, self.start, self.end, self.by, self.what = file, kind, right, start, end, by, what
        self.number = self.function = 0
        first, last = right.rfind('\n', 0, start) + 1, right.find('\n', end)
        self.shown = ' '.join(f'{right[first:start]}[-{right[start:end]}-]{{+{by}+}}{right[end:last]}'.split())
        self.name, self.group = (file, self.shown), (file if file in SHEETS else file.split('/')[0] + '/', kind)

    def __str__(self):
        line = self.right.count('\n', 0, self.start) + 1
        return f'{self.file}:{line}: {self.shown}'

    @property
    def text(self):
        return self.right[:self.start] + self.by + self.right[self.end:]

    @property
    def key(self):
        return hashlib.sha256(f'{self.file}\0{self.text}'.encode()).hexdigest()[:20]


def all_mutants(only):
    """Headers of verify/ and the public one declare, and compute nothing; the examples are built by their own test."""
    return [Mutant(file, kind, text, *change) for file in FILES if file.startswith(only) and 'examples' not in file
            if file in (*SHEETS, 'ref/internal.h') or file.startswith(('ref/', 'verify/')) and file.endswith('.c')
            for text in [(ROOT / file).read_text()] for kind in KINDS if kind == 'tokens' or file.startswith('verify/')
            for change in mutants(file, text, kind)]


# ---- one program of them all ----

FUNCTION = re.compile(r'^(?P<type>[a-z_][^\n;{}#=(]*?)(?P<name>\w+)\((?P<parameters>[^\n;{}#=]*(?:\n[ \t][^\n;{}=]*)*)\)\n\{\n'
                      r'(?P<body>(?:(?!\}).*\n)*)^\}\n', re.M)


def schemata(file, text, chosen):
    """The text of a file in which each function that has mutants calls the one that is chosen."""
    def of_all(f):
        name, parameters, body, begin = f['name'], f['parameters'], f['body'], f.start('body')
        mine = [m for m in chosen if begin <= m.start and m.end <= f.end('body')]
        if not mine or '...' in parameters:
            return f[0]
        plain = re.sub(r'\(\s*\*\s*(?:const\s+)?(\w+)\)(?:\([^()]*\))?', r'\1', parameters)  # without those of a parameter
        arguments = ', '.join(p for p in re.findall(r'(\w+)\s*(?:\[[^\]]*\]\s*)*(?:,|$)', plain) if p != 'void')
        kept, result = re.sub(r'\b(static|extern|inline)\b\s*', '', f['type']), '' if f['type'].endswith('void ') else 'return '
        copies = cases = ''
        for m in [*mine, None]:
            tag, label = (f'm{m.number}', f'case {m.number}') if m else ('right', 'default')
            changed = body[:m.start - begin] + m.by + body[m.end - begin:] if m else body
            copies += f'#line 1 "{tag}"\nstatic {kept}{name}__{tag}({parameters})\n{{\n{changed}}}\n'
            cases += f'    {label}: {result}{name}__{tag}({arguments}); {"" if result else "return;"}\n'
        for m in mine:
            m.function = mine[0].number
        sign, following = f'{f["type"]}{name}({parameters})', text.count('\n', 0, f.end()) + 1
        chooser = f'{sign}\n{{\n    mutant_reached_[{mine[0].number}] = 1;\n    switch (mutant_) {{\n{cases}    }}\n}}\n'
        return f'{sign};\n{copies}{chooser}#line {following} "{file}"\n'
    return f'extern int mutant_; extern unsigned char *mutant_reached_;\n#line 1 "{file}"\n' + FUNCTION.sub(of_all, text)


def make(place):
    """What the compiler says; and whether it made everything."""
    command = 'make -sk all suites build/derivations.json build/errors.json build/equations.json'
    made = subprocess.run(command.split(), cwd=place, capture_output=True, text=True)
    return made.stderr, made.returncode == 0


def all_in_one(place, chosen):
    """Makes them in a copy of the project. Which of them the compiler refuses, or warns of alone; and which are the same code."""
    for file in FILES:
        (place / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / file, place / file)
    shutil.copy2(ROOT / 'coverage/mutants.c', place / 'ref/')
    verdicts, made, files = {}, False, {m.file: m.right for m in chosen}
    while not made:
        for file, right in files.items():
            text = schemata(file, right, [m for m in chosen if m.file == file and m.number not in verdicts])
            if text != (place / file).read_text():
                (place / file).write_text(text)
        said, made = make(place)
        idle = set(re.findall(r'^right:.* warning: .*\[(-W.*)\]$', said, re.M))
        told = re.findall(r'^m(\d+):\d+:\d+: (?:error|warning): .*?(?:\[(-W.*)\])?$', said, re.M)
        refused = {int(number): 'not viable' for number, option in told if option not in idle}
        if not made and refused.keys() <= verdicts.keys():
            sys.exit(f'mutants: the tree cannot be made:\n{said}')
        verdicts |= refused
    for file in place.glob('build/[rv]e*/**/*.o'):
        command = ['objdump', '-dr', '--no-addresses', '--no-show-raw-insn', file]
        shown = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True).stdout
        found = re.findall(r'^<(\w+)__(?:m(\d+)|right)>:\n((?:.+\n)*)', shown, re.M)
        code = {(name, number): re.sub(rf'{name}__(m\d+|right)', name, body) for name, number, body in found}
        verdicts |= {int(n): 'same code' for (name, n), body in code.items() if n and body == code.get((name, ''))}
    for file in files:  # as people have them, and older than what is made of them
        shutil.copy2(ROOT / file, place / file)
    return verdicts


# ---- the checks ----

# What a mutant leaves behind ends with it; and one that lost the process it asks for ends no other than its own.
APART = ['unshare', '--pid', '--fork', '--kill-child', '--mount-proc', *(['--map-root-user'] if os.getuid() else [])]
WORKER = threading.local()  # its place: a copy of what was made


class Check:
    """A test by its name, or a command of which every byte counts."""

    def __init__(self, command, room=''):
        self.name, self.command, self.room, self.prints = command, command.split(), room, command.startswith(PROGRAM)

    def run(self, seconds, **environment):
        """What it printed and how it ended; and its processor time."""
        bounds = f'timeout -s KILL {30 + 30 * seconds} prlimit --cpu={seconds} --as={3 << 30} --core=0'.split()
        with open(WORKER.place / 'printed', 'w+b') as output:
            process = subprocess.Popen(
                [*APART, *bounds, *self.command], cwd=WORKER.place, env=os.environ | environment, stdin=subprocess.DEVNULL,
                stdout=output if self.prints else subprocess.DEVNULL, stderr=subprocess.STDOUT)
            _, process.returncode, used = os.wait4(process.pid, 0)
            output.seek(0)
            return (output.read(), process.returncode), used.ru_utime + used.ru_stime

    def learn(self):
        """What the right program makes of it, what it costs, and what it reaches."""
        reached = WORKER.place / 'reached'
        for _ in range(2):  # on a machine that is busy one may end before its time
            reached.write_bytes(bytes(1 << 17))
            self.right, self.cost = self.run(300, MUTANT_REACHED=str(reached))
            if self.right[1] == 0:
                break
        self.reached = {number for number, hit in enumerate(reached.read_bytes()) if hit}
        if self.right[1] != 0:
            print(f'mutants: {self.name} does not pass the program as it is, and is left out', file=sys.stderr)
        return self.right[1] == 0


def all_checks():
    golden = sorted(file.stem for file in (ROOT / 'data/golden').glob('*.csv'))
    studies = 'balance basin convergence forced pitch sampling saturation tolerance'.split()
    prints = ['table1', 'figure 4', *(f'figure {f} --rk4 100' for f in ('5a', '5b', '6', '7a', '7b')),
              *(f'study {s}' for s in studies), *(f'vectors {g} --golden' for g in golden),
              *(f'conform --kills --only {g}' for g in golden), 'verify errors', 'verify derivations', 'verify claims --json']
    scripts = ['tests/command/test_wrong.sh', 'tests/conform/test_clients.sh', 'tests/project/test_gate.sh']
    alone = ['build/tests/test_ref_gsl', 'build/tests/test_corpora']
    yield from (Check(f'{PROGRAM} {arguments}') for arguments in prints)
    yield from map(Check, [f"build/sheet-check {' '.join(SHEETS)}", *scripts, *alone])
    for file in sorted((ROOT / 'tests').glob('*/test_*.c')):
        names = re.findall(r'^(?:TEST|EACH|RANGE)\((\w+)[,)]', file.read_text(), re.M)
        yield from (Check(f'build/tests/run {name}', file.parent.name) for name in names if f'build/tests/{file.stem}' not in alone)


class Judge:
    def __init__(self, checks, budget):
        self.checks, self.budget, self.noticed = checks, budget, collections.Counter()

    def ask(self, mutant):
        """Of the checks that reach it those first that are likely to notice it soon, until one does or its time is spent."""
        section = ''.join(re.findall(r'^  (\w+):', mutant.right[:mutant.end], re.M)[-1:])
        function = section if mutant.file in SHEETS else mutant.function
        spent, (*_, room, stem, _) = 0, re.split('[/.]', mutant.file)

        def dear(check):
            met = 30 * self.noticed[mutant.file, function, check] + 6 * self.noticed[mutant.file, check]
            named = mutant.file in SHEETS and not {function, stem}.isdisjoint(check.command)
            return (check.cost + 0.03) / (1 + met + 4 * (check.room == room) + 1000 * named)
        for check in sorted((c for c in self.checks if not mutant.function or function in c.reached), key=dear):
            if spent and spent + check.cost > self.budget:
                continue
            found, _ = check.run(math.ceil(2 + 5 * check.cost), MUTANT=str(mutant.number))
            if found != check.right:
                self.noticed.update([(mutant.file, function, check), (mutant.file, check)])
                return 'killed', check.name
            spent += check.cost
        return 'survived', f'{spent:.1f} s'

    def verdict(self, mutant):
        """Of what is in no function, or in a sheet, the wrong file stands there for the time."""
        if mutant.function:
            return mutant, *self.ask(mutant)
        path = WORKER.place / mutant.file
        path.write_text(mutant.text)
        said, made = make(WORKER.place) if mutant.number else ('', True)
        refused = not made or re.search(rf'^{mutant.file}:\d+:\d+: (?:error|warning)', said, re.M)
        verdict = ('not viable', 'compiler') if refused else self.ask(mutant)
        shutil.copy(ROOT / mutant.file, path)
        return mutant, *verdict


def judged(asked, base, workers, budget):
    """Mutants with their verdicts, and by what."""
    of_c, places = [m for m in asked if m.file not in SHEETS], [base / str(n) for n in range(workers)]
    for number, m in enumerate(of_c, 1):
        m.number = number
    subprocess.run([*APART, 'true'], check=True)  # or it says why not, before the long work
    shutil.rmtree(base, ignore_errors=True)
    verdicts = all_in_one(places[0], of_c)
    yield from ((m, verdicts[m.number], 'compiler') for m in of_c if m.number in verdicts)
    for place in places[1:]:
        shutil.copytree(places[0], place)
    pool = concurrent.futures.ThreadPoolExecutor(workers, initializer=lambda: setattr(WORKER, 'place', places.pop()))
    checks = list(all_checks())
    judge = Judge([check for check, passes in zip(checks, pool.map(Check.learn, checks)) if passes], budget)
    left = sorted((m for m in asked if m.number not in verdicts), key=lambda m: m.number and not m.function)
    yield from pool.map(judge.verdict, left)  # what is compiled by itself comes last


# ---- many of them ----

def choose(everything, sample, seed, listing):
    """All, but of too many; or a sample of what is not listed, as much of each part."""
    groups, chosen = collections.defaultdict(list), []
    for m in everything:
        if not sample or m.name not in listing:
            groups[m.group].append(m)
    for group, of in groups.items():
        count = math.ceil(sample / len(groups)) or (OF_THEM if group == TOO_MANY else len(of))
        # A change elsewhere leaves them drawn: the lot of each is its own.
        of.sort(key=lambda m: hashlib.sha256(f'{seed}\0{m.file}\0{m.shown}'.encode()).digest())
        chosen += sorted(of[:count], key=lambda m: (m.file, m.start))
    return chosen


def table(title, rows):
    """A row of Markdown for each name, and their sum."""
    lines = [f'| {title} | made | viable | killed | equivalent | survived | score |', '|---|' + '---|' * 6]
    for name, c in [*rows.items(), *([('all', sum(rows.values(), collections.Counter()))] if len(rows) > 1 else [])]:
        judged = c['killed'] + c['survived']
        score = math.floor(1000 * c['killed'] / judged) / 10 if judged else 100.0
        cells = name, c['made'], c['made'] - c['not viable'], c['killed'], c['listed'] + c['same code'], c['survived'], f'{score} %'
        lines.append(f"| {' | '.join(map(str, cells))} |")
    return '\n'.join(lines) + '\n'


def summary(chosen, known, listing, everything):
    """The tables, and what is wrong, a line each; of a sample `everything` is empty."""
    stale, by_part, by_what, verdicts, wrong = collections.Counter(listing), {}, {}, collections.defaultdict(list), []
    for m in chosen:
        verdict = known[m.key]
        if verdict == 'survived' and stale[m.name] > 0:
            stale[m.name] -= 1
            verdict = 'listed'
        part, of = (m.file, '') if m.file in SHEETS else (m.file.rpartition('/')[0] + '/', f', {m.kind}')
        for rows, row in (by_part, f'`{part}`{of}'), (by_what, m.what + of):
            rows.setdefault(row, collections.Counter()).update(['made', verdict])
        verdicts[m.group].append((verdict, m))
    for group, those in verdicts.items():
        survivors = [m for verdict, m in those if verdict == 'survived']
        strict = group[0] in STRICT or everything and group != TOO_MANY
        if len(survivors) > (0 if strict else 2 + 0.1 * len(those)):
            wrong += [f'survives, and is not in coverage/survivors.csv: {m}' for m in survivors]
    asked, there, files = {m.name for m in chosen}, {m.name for m in everything}, {m.file for m in chosen}
    wrong += [f'is in coverage/survivors.csv, and does not survive: {file}: {shown}' for (file, shown), left in stale.items()
              if everything and left > 0 and ((file, shown) in asked or (file, shown) not in there and file in files)]
    return table('part', by_part) + '\n' + table('what is changed', by_what), wrong


def self_test():
    """A survivor that is not listed is wrong, and so is a listed one that does not survive."""
    one, other = chosen = [Mutant('ref/f.c', 'tokens', 'a + b\n', 2, 3, by, 'operator') for by in '-*']
    known = {one.key: 'survived', other.key: 'killed'}
    counts = [len(summary(chosen, known, names, chosen)[1]) for names in ([], [one.name], [one.name, other.name])]
    assert counts == [1, 0, 1], counts


def main():
    self_test()
    parser = argparse.ArgumentParser()
    parser.add_argument('build', type=pathlib.Path)
    parser.add_argument('--readme', action='store_true')
    parser.add_argument('--kind', choices=KINDS)
    for name, default in {'sample': 0, 'seed': '1', 'only': '', 'budget': 60.0, 'workers': os.cpu_count() or 1}.items():
        parser.add_argument(f'--{name}', type=type(default), default=default)
    arguments = parser.parse_args()
    os.environ.update(BUILD='build', CPPFLAGS='-Iverify -I.', CFLAGS='-O1 -fno-inline', LDFLAGS='-Wl,--wrap=embedded_sources',
                      CK_FORK='no', LC_ALL='C')

    with LISTED.open(newline='') as file:  # line numbers there are for the reader: lines move
        listing = [(row['file'], row['mutant']) for row in csv.DictReader(file) if row['reason']]
    everything = all_mutants(arguments.only)
    chosen = choose([m for m in everything if arguments.kind in (None, m.kind)], arguments.sample, arguments.seed, set(listing))
    base = arguments.build.resolve()
    base.mkdir(parents=True, exist_ok=True)
    with (base / 'results.csv').open('a+', newline='') as file:
        file.seek(0)
        known = {key: verdict for key, verdict, by, world in csv.reader(file) if verdict != 'survived' or world == WORLD}
        asked = [m for m in chosen if m.key not in known]
        for m, verdict, by in judged(asked, base / 'places', arguments.workers, arguments.budget) if asked else ():
            known[m.key] = verdict
            csv.writer(file).writerow([m.key, verdict, by, WORLD])
            file.flush()
            if verdict == 'survived' and m.name not in listing:
                print(f'survived {by}: {m}', flush=True)
    tables, wrong = summary(chosen, known, listing, [] if arguments.sample else everything)
    print(tables, *wrong, sep='\n')
    if arguments.readme:
        written = re.sub(r'(?<=<!-- mutants -->\n).*(?=<!-- end -->)', lambda _: tables, README.read_text(), flags=re.S)
        README.write_text(written)
    return len(wrong) > 0


if __name__ == '__main__':
    sys.exit(main())
