"""Mutants: wrong programs, one point away from the right one, and whether the tests notice.

    python3 coverage/mutants.py BUILD [--kind tokens|soundness] [--sample N] [--seed S] [--only FILE, or how its name begins]
                                      [--budget SECONDS] [--workers N] [--readme]
    python3 coverage/mutants.py --self-test

All mutants of C are in one program: a function that has some is there once for each, beside the right one, and the environment
says which of them is called (mutants.c). So they are compiled and linked once, in a copy of the tree, and no more is
done for a mutant than to run tests. Only what a macro or a table has wrong is compiled by itself; a sheet that is wrong is read
instead of the one in the program.
Every test of the suites, and every command that makes data, is a check. The right program passes each first, which tells how long it
takes and which functions it reaches. A mutant is put before those that reach it, first those that have noticed others of
its function and its file, the quick ones before the slow, until one notices it or its processor time is spent.
Verdicts are kept in BUILD/results.csv by the mutant's content: a run that was cut short goes on, a kill stands, a survivor is
asked again once anything in the project has changed. coverage/survivors.csv lists the mutants that no check can kill, each with its
reason. Run by `make mutants`.
"""
import argparse
import collections
import concurrent.futures
import contextlib
import csv
import functools
import hashlib
import itertools
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import threading

from mutants_of import C, mutants

ROOT = pathlib.Path.cwd()
LISTED, README = ROOT / 'coverage/survivors.csv', ROOT / 'coverage/README.md'
KINDS = ('tokens', 'soundness')
SHEETS = ('paper/equations.yaml', 'paper/derivations.yaml', 'paper/claims.yaml')
PROVES = {SHEETS[1]: 'derivations', SHEETS[2]: '--csv'}  # what verify proves of a sheet as a whole
VERIFY_SAMPLE, VERIFY_SEED, VERIFY_LEAST = 250, 1, 0.9  # of the tokens of verify/, which are too many; and how many must be noticed
SAMPLE_LEAST = 0.5  # a sample is so small that it may show 60 % where 80 % are noticed
COUNTED = ('verify/', *SHEETS[1:])  # in a sample: not all that is equivalent there is listed
FILES = [str(file.relative_to(ROOT)) for folder in ('', 'coverage', 'data', 'paper', 'ref', 'tests', 'verify')
         for file in sorted((ROOT / folder).glob('**/*' if folder else '*')) if file.is_file()]


class Mutant:
    """text[start:end] of a file replaced."""

    def __init__(self, file, text, start, end, by, what, kind):
        self.file, self.right, self.start, self.end, self.by, self.what, self.kind = file, text, start, end, by, what, kind
        self.number = self.function = 0

    @property
    def text(self):
        return self.right[:self.start] + self.by + self.right[self.end:]

    @property
    def line(self):
        return self.right.count('\n', 0, self.start) + 1

    @functools.cached_property
    def shown(self):
        """The changed line as a word diff, on one line."""
        first, last = self.right.rfind('\n', 0, self.start) + 1, self.right.find('\n', self.end)
        line = f'{self.right[first:self.start]}[-{self.right[self.start:self.end]}-]{{+{self.by}+}}{self.right[self.end:last]}'
        return ' '.join(line.split())

    @functools.cached_property
    def key(self):
        return hashlib.sha256(f'{self.file}\0{self.text}'.encode()).hexdigest()[:20]

    @property
    def part(self):
        return self.file if self.file in SHEETS else 'ref/' if self.file.startswith('ref/') else '/'.join(self.file.split('/')[:2]) + '/'


def all_mutants(only):
    """Headers of verify/ and the public one declare, and compute nothing; the examples are built by their own test."""
    return [Mutant(file, text, *change, kind) for file in FILES if file.startswith(only) and 'examples' not in file
            if file in (*SHEETS, 'ref/internal.h') or file.startswith(('ref/', 'verify/')) and file.endswith('.c')
            for text in [(ROOT / file).read_text()] for kind in KINDS if kind == 'tokens' or file.startswith('verify/')
            for change in mutants(file, text, kind if kind == 'soundness' else '')]


# ---- one program of them all ----

FUNCTION = re.compile(r'^(?P<sign>[a-z_][^\n;{}#=]*(?:\n[ \t][^\n;{}=]*)*\))\n\{\n(?P<body>(?:(?!\}).*\n)*)^\}\n', re.M)


def signature(sign):
    """Where a function's name stands in its signature, and the names of its parameters; None where their number varies."""
    c = C(sign)
    opening = min(i for i in c.partner if c.word(i) == '(' and c.kind(i - 1) == 'name' and c.word(i - 1) != '__attribute__')
    parameters = [c.source(*part) for part in c.parts(opening)]
    if '...' in parameters:
        return None
    names = [re.search(r'\(\s*\*\s*(?:const\s+)?(\w+)', p) or re.search(r'(\w+)\s*(?:\[[^\]]*\]\s*)*$', p) for p in parameters]
    return c.marks[opening - 1][2:], [m.group(1) for m in names if m.group(1) != 'void']


def schemata(file, text, chosen, functions):
    """The text of a file in which each function that has mutants calls the one that is chosen."""
    pieces, at = [f'extern int mutant_; extern unsigned char *mutant_reached_;\n#line 1 "{file}"\n'], 0
    for f in FUNCTION.finditer(text):
        begin, end, sign = *f.span('body'), f.group('sign')
        (first, last), names = signature(sign) or ((0, len(sign)), None)
        name = sign[first:last]
        number = functions.setdefault(f'{file}:{name}', len(functions) + 1)
        mine = [m for m in chosen if begin <= m.start and m.end <= end]
        if not mine or names is None:
            continue

        def copy(tag, body):
            renamed = re.sub(r'\b(static|extern|inline)\b\s*', '', f'{sign[:last]}__{tag}{sign[last:]}')
            return f'#line 1 "{tag}"\nstatic {renamed}\n{{\n{body}}}\n'

        def call(tag):
            called = f'{name}__{tag}({", ".join(names)});'
            return f'{called} return;' if re.search(r'\bvoid\s*$', sign[:first]) else f'return {called}'
        pieces += [text[at:f.start()], sign, ';\n', copy('right', text[begin:end])]
        for m in mine:
            m.function = number
            pieces.append(copy(f'm{m.number}', text[begin:m.start] + m.by + text[m.end:end]))
        cases = ''.join(f'    case {m.number}: {call(f"m{m.number}")}\n' for m in mine)
        line = text.count('\n', 0, f.end()) + 1
        pieces.append(f'{sign}\n{{\n    mutant_reached_[{number}] = 1;\n    switch (mutant_) {{\n{cases}    default: {call("right")}\n    }}\n}}\n'
                      f'#line {line} "{file}"\n')
        at = f.end()
    return ''.join([*pieces, text[at:]])


def put(path, content):
    content = content.encode() if isinstance(content, str) else content
    if not path.is_file() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


WRAPS = ' '.join(f'-Wl,--wrap={name}' for name in ('_ck_assert_failed', 'kill', 'embedded_sources'))


class Tree:
    """A copy of the project with all that is chosen in its program."""

    def __init__(self, base):
        self.root, self.build, self.functions = base / 'tree', base / 'tree/build', {}
        for folder in ('ref', 'tests', 'verify'):
            for file in (self.root / folder).glob('**/*.*'):
                if str(file.relative_to(self.root)) not in FILES:
                    file.unlink()  # of an earlier run
        for file in FILES:
            if not file.endswith(('.c', 'internal.h')):
                put(self.root / file, (ROOT / file).read_bytes())
                shutil.copymode(ROOT / file, self.root / file)
        put(self.root / 'ref/mutants.c', (ROOT / 'coverage/mutants.c').read_text())

    def make(self):
        """What the compiler says; and whether it made everything."""
        environment = {name: value for name, value in os.environ.items() if name not in ('MAKEFLAGS', 'MAKELEVEL', 'MFLAGS', 'CT_MAKE', 'BUILD')}
        made = subprocess.run(['make', '-s', '-k', 'all', 'suites', 'build/derivations.json', 'build/errors.json', 'BUILD=build',
                               'CPPFLAGS=-Iverify -I.', 'LDFLAGS=' + WRAPS,
                               'CFLAGS=-O1 -fno-inline ' + os.environ.get('MUTANT_CFLAGS', '')],
                              cwd=self.root, env=environment, capture_output=True, text=True)
        return made.stderr, made.returncode == 0

    def compile(self, chosen):
        """Those that the compiler refuses, or warns of, by number."""
        of, dead = collections.defaultdict(list), set()
        for number, mutant in enumerate(chosen, 1):
            mutant.number = number
            of[mutant.file].append(mutant)
        while True:
            self.functions.clear()
            for file in FILES:
                if file.endswith(('.c', 'internal.h')):
                    text = (ROOT / file).read_text()
                    live = [m for m in of[file] if m.number not in dead]
                    put(self.root / file, schemata(file, text, live, self.functions) if file.startswith(('ref/', 'verify/')) else text)
            said, made = self.make()
            idle = set(re.findall(r'^right:.* warning: .*\[(-W.*)\]$', said, re.M))  # so it warns of what is right, too
            warned = {int(n) for n, what, option in re.findall(r'^m(\d+):\d+:\d+: (error|warning): .*?(?:\[(-W.*)\])?$', said, re.M)
                      if what == 'error' or option not in idle}
            if made:
                return dead | warned
            if warned <= dead:
                sys.exit(f'mutants: the tree cannot be made:\n{said}')
            dead |= warned

    def same_code(self):
        """Those of which the compiler makes what it makes of the right function."""
        same = set()
        for file in self.build.glob('[rv]e*/**/*.o'):
            code = {}
            shown = subprocess.run(['objdump', '-dr', '--no-addresses', '--no-show-raw-insn', file], stdout=subprocess.PIPE, text=True, check=True)
            for name, tag, body in re.findall(r'^<(\w+)__(m\d+|right)>:\n((?:.+\n)*)', shown.stdout, re.M):
                code[name, tag] = body.replace(f'{name}__{tag}', name)
            same |= {int(tag[1:]) for (name, tag), body in code.items() if body == code.get((name, 'right')) and tag != 'right'}
        return same


# ---- the checks ----

class Place:
    """The tree as one process at a time sees it: its own folder of what was built, its own sheets, all else links."""

    def __init__(self, tree, name):
        self.root = tree.root.parent / 'places' / name
        shutil.rmtree(self.root, ignore_errors=True)
        for folder in ('', 'paper', 'build', 'build/tests'):
            (self.root / folder).mkdir(parents=True)
            for entry in (tree.root / folder).iterdir():
                if entry.name not in ('paper', 'build') and str(entry) != f'{tree.build}/tests':
                    sources = entry.name in ('ref', 'verify') and not folder  # as people have them
                    (self.root / folder / entry.name).symlink_to(ROOT / entry.name if sources else entry)
        (self.root / 'reached').write_bytes(bytes(8192))
        self.environment = dict(os.environ, BUILD='build', CT_BUILD=f'{self.root}/build', CT_PROGRAM=f'{self.root}/build/coulomb-tether',
                                MUTANT_SHEETS=str(self.root), LC_ALL='C', LDFLAGS=WRAPS)

    def run(self, check, limit, mutant=0, reached=False):
        """What it printed, how it ended, and its processor time."""
        options = {'MUTANT_REACHED': f'{self.root}/reached'} if reached else {}
        with open(self.root / 'printed', 'w+b') as output, subprocess.Popen(
                check.command, cwd=self.root, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
                env=dict(self.environment, CK_FORK=check.fork, MUTANT=str(mutant), MUTANT_SECONDS=str(math.ceil(limit)), **options)) as process:
            late = threading.Timer(30 + 30 * limit, os.killpg, (process.pid, signal.SIGKILL))
            late.start()
            _, status, used = os.wait4(process.pid, 0)
            late.cancel()
            process.returncode = os.waitstatus_to_exitcode(status)
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            output.seek(0)
            printed = hashlib.sha256(output.read()).hexdigest() if check.prints else ''
        return printed, process.returncode, used.ru_utime + used.ru_stime

    @contextlib.contextmanager
    def sheet(self, file, text):
        (self.root / file).unlink()
        (self.root / file).write_text(text)
        yield
        (self.root / file).unlink()
        (self.root / file).symlink_to(ROOT / file)


class Check:
    """A test by its name, or a command of which every byte counts."""

    def __init__(self, name, command, room='', prints=False):
        self.name, self.command, self.room, self.prints, self.fork = name, command, room, prints, 'no'
        self.right, self.cost, self.reached = ('', 0), 0, set()

    def learn(self, place):
        """What the right program makes of it."""
        for self.fork in ('no', 'yes'):  # what ends its process on purpose needs one of its own
            (place.root / 'reached').write_bytes(bytes(8192))
            printed, status, self.cost = place.run(self, 300, reached=True)
            self.right = printed, status
            self.reached = {number for number, hit in enumerate((place.root / 'reached').read_bytes()) if hit}
            if status == 0:
                break

    def notices(self, place, mutant):
        """'' or how."""
        printed, status, _ = place.run(self, 2 + 5 * self.cost, mutant.number)
        late = status in (-signal.SIGXCPU, -signal.SIGKILL)
        return '' if (printed, status) == self.right else self.name + ' (time)' * late


def all_checks():
    program, golden = 'build/coulomb-tether', sorted(file.stem for file in (ROOT / 'data/golden').glob('*.csv'))
    commands = [*(f'vectors {g} --golden' for g in golden), *(f'conform --kills --only {g}' for g in golden),
                *(f'figure {f} --rk4 100' for f in ('5a', '5b', '6', '7a', '7b')), 'figure 4', 'table1', 'verify derivations',
                'verify claims --json', 'verify errors', *(f'study {s}' for s in ('balance', 'basin', 'convergence', 'forced', 'pitch', 'sampling', 'saturation', 'tolerance'))]
    yield from (Check(command, [program, *command.split()], prints=True) for command in commands)
    yield Check('sheet-check', ['build/sheet-check', *SHEETS])
    for script in ('command/test_wrong.sh', 'conform/test_clients.sh', 'project/test_gate.sh'):
        yield Check(script, [f'tests/{script}'])
    for file in sorted((ROOT / 'tests').glob('*/test_*.c')):
        alone = file.stem in ('test_ref_gsl', 'test_corpora')
        names = [file.stem] if alone else re.findall(r'^(?:TEST|EACH|RANGE)\((\w+)[,)]', file.read_text(), re.M)
        for name in names:
            yield Check(name, [f'build/tests/{file.stem}'] if alone else ['build/tests/run', name], file.parent.name)


class Judge:
    def __init__(self, tree, arguments, world, traced):
        self.tree, self.budget, self.noticed, self.lock = tree, arguments.budget, collections.Counter(), threading.Lock()
        self.places = [Place(tree, str(n)) for n in range(arguments.workers)]
        self.pool = concurrent.futures.ThreadPoolExecutor(arguments.workers)
        self.checks, known = list(all_checks()), tree.root.parent / 'checks.json'
        kept = json.loads(known.read_text()) if known.exists() else {}
        if kept.get('world') != world or not set(traced) <= set(kept['traced']):
            list(self.each(Check.learn, self.checks))
            kept = {'world': world, 'traced': traced, 'checks': [[c.name, c.fork, c.right, c.cost, sorted(c.reached)] for c in self.checks]}
            known.write_text(json.dumps(kept))
        for check, (check.name, check.fork, check.right, check.cost, reached) in zip(self.checks, kept['checks']):
            check.right, check.reached = tuple(check.right), set(reached)
        for check in [c for c in self.checks if c.right[1] != 0]:
            print(f'mutants: {check.name} does not pass the program as it is, and is left out', file=sys.stderr)
            self.checks.remove(check)

    def each(self, work, tasks):
        def in_a_place(task):
            with self.lock:
                place = self.places.pop()
            try:
                return work(task, place)
            finally:
                self.places.append(place)
        return self.pool.map(in_a_place, tasks)

    def order(self, mutant):
        """The checks that reach a mutant, those first that are likely to notice it soon."""
        near, function = mutant.file.split('/')[-2], mutant.function or section_at(mutant)

        def worth(check):
            met = 30 * self.noticed[mutant.file, function, check.name] + 6 * self.noticed[mutant.file, check.name]
            named = 4 * (check.room == near) + 1000 * (mutant.file in SHEETS and bool({function, PROVES.get(mutant.file)} & set(check.name.split())))
            return (1 + met + 0.5 * self.noticed[check.name] + named) / (check.cost + 0.03)
        with self.lock:
            return sorted((c for c in self.checks if not mutant.function or mutant.function in c.reached), key=worth, reverse=True)

    def ask(self, mutant, place):
        spent = 0
        for check in self.order(mutant):
            if spent and spent + check.cost > self.budget:
                continue
            by = check.notices(place, mutant)
            if by:
                with self.lock:
                    for key in ((mutant.file, mutant.function or section_at(mutant), check.name), (mutant.file, check.name), check.name):
                        self.noticed[key] += 1
                return 'killed', by
            spent += check.cost
        return 'survived', f'{spent:.1f} s'

    def verdict(self, mutant, place):
        if mutant.file in SHEETS:
            with place.sheet(mutant.file, mutant.text):
                return mutant, *self.ask(mutant, place)
        if mutant.function:
            return mutant, *self.ask(mutant, place)
        put(self.tree.root / mutant.file, mutant.text)  # by itself, with nobody beside it
        said, made = self.tree.make()
        refused = not made or re.search(rf'^{mutant.file}:\d+:\d+: (?:error|warning)', said, re.M)
        return mutant, *(('not viable', 'compiler') if refused else self.ask(mutant, place))

    def verdicts(self, chosen):
        alone = [m for m in chosen if not m.function and m.file not in SHEETS]
        yield from self.each(self.verdict, [m for m in chosen if m.function or m.file in SHEETS])
        for file, mutants_of_it in itertools.groupby(alone, key=lambda m: m.file):
            yield from (self.verdict(mutant, self.places[0]) for mutant in mutants_of_it)
            put(self.tree.root / file, (ROOT / file).read_text())


def section_at(mutant):
    """The section of a sheet that a mutant lies in."""
    return ''.join(re.findall(r'^  (\w+):', mutant.right[:mutant.end], re.M)[-1:]) if mutant.file in SHEETS else ''


# ---- many of them ----

class Results:
    """What is known, in BUILD/results.csv; a survivor only so long as the project is what it was."""

    def __init__(self, path):
        world = hashlib.sha256(b''.join((ROOT / file).read_bytes() for file in FILES if not file.startswith('coverage/')))
        self.path, self.known, self.world = path, {}, world.hexdigest()[:20]
        for row in csv.reader(path.open(newline='')) if path.exists() else ():
            if row[1] != 'survived' or row[3] == self.world:
                self.known[row[0]] = (row[1], row[2])

    def add(self, mutant, verdict, by):
        self.known[mutant.key] = (verdict, by)
        with self.path.open('a', newline='') as file:
            csv.writer(file).writerow([mutant.key, verdict, by, self.world])


def listed():
    """How often each mutant is listed, and why; the line number is for the reader, for lines move."""
    with LISTED.open(newline='') as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        if not row['reason']:
            sys.exit(f"mutants: {LISTED.name}: no reason for {row['file']}:{row['line']}")
    return collections.Counter((row['file'], row['mutant']) for row in rows)


def table(title, rows):
    """A row of Markdown for each name, and their sum."""
    lines = [f'| {title} | made | viable | killed | of these by time | equivalent | survived | score |', '|---|' + '---|' * 7]
    for name, c in [*rows.items(), *([('all', sum(rows.values(), collections.Counter()))] if len(rows) > 1 else [])]:
        judged = c['killed'] + c['survived']
        lines.append(f"| {name} | {c['made']} | {c['made'] - c['not viable']} | {c['killed']} | {c['time']} | {c['listed'] + c['same code']} | "
                     f"{c['survived']} | {math.floor(1000 * c['killed'] / judged) / 10 if judged else 100.0} % |")
    return '\n'.join(lines) + '\n'


def summary(chosen, known, listing, everything):
    """The tables, what is wrong, and the status; of a sample `everything` is empty."""
    complete = bool(everything)
    stale, by_part, by_what, judged = collections.Counter(listing), {}, {}, collections.defaultdict(list)
    for mutant in chosen:
        verdict, by = known.get(mutant.key, ('unknown', ''))
        name = (mutant.file, mutant.shown)
        if verdict == 'survived' and stale[name] > 0:
            stale[name] -= 1
            verdict = 'listed'
        of = '' if mutant.file in SHEETS else f', {mutant.kind}'
        for rows, row in ((by_part, f'`{mutant.part}`{of}'), (by_what, f'{mutant.what}{of}')):
            rows.setdefault(row, collections.Counter()).update(['made', verdict] + ['time'] * by.endswith('(time)'))
        group = mutant.file if mutant.file in SHEETS else mutant.file.split('/')[0] + '/'
        if verdict in ('survived', 'killed'):
            judged[group, mutant.kind == 'tokens' or not complete].append(mutant if verdict == 'survived' else None)
    tables = table('part', by_part) + '\n' + table('what is changed', by_what)
    print(tables)
    status = 0
    for (group, tokens), those in judged.items():
        survivors = [mutant for mutant in those if mutant]
        least = VERIFY_LEAST if complete and group == 'verify/' and tokens else SAMPLE_LEAST if not complete and group in COUNTED else 1
        enough = len(survivors) <= (1 - least) * len(those)
        for mutant in survivors:
            print(f"survives{'' if enough else ', and is not in coverage/survivors.csv'}: {mutant.file}:{mutant.line}: {mutant.shown}")
        status |= not enough
    asked, there = ({(mutant.file, mutant.shown) for mutant in of} for of in (chosen, everything))
    for name, number in stale.items():
        if complete and number > 0 and (name in asked or name not in there and name[0] in {file for file, _ in asked}):
            print(f'is in coverage/survivors.csv, and does not survive: {name[0]}: {name[1]}')
            status = 1
    return status, tables


def draw(chosen, number, seed):
    """So many of the mutants, by lot. A change elsewhere leaves them drawn: the lot of each is its own."""
    return sorted(chosen, key=lambda m: hashlib.sha256(f'{seed}\0{m.file}\0{m.shown}'.encode()).digest())[:number]


def choose(everything, sample, seed, listing):
    """All but of the tokens of verify/, which are sampled; or of each part a share of a sample of what is not listed."""
    groups = collections.defaultdict(list)
    for m in everything:
        groups[m.file if m.file in SHEETS else (m.file.split('/')[0], m.kind)].append(m)
    if not sample:
        return [m for group, of in groups.items() for m in (draw(of, VERIFY_SAMPLE, VERIFY_SEED) if group == ('verify', 'tokens') else of)]
    return [m for group, of in groups.items() for m in draw([m for m in of if (m.file, m.shown) not in listing], math.ceil(
        sample * (0.3 if group in (('ref', 'tokens'), *SHEETS[:2]) else 0.1)), seed)]


def self_test():
    """The points of a line of C are those written here; a survivor that is not listed is found, and a line without one."""
    text = 'double f(double m1, double m2) { return m1 * sin(m2) - 2; }\n'
    found = {text[:start] + by + text[end:] for start, end, by, _ in mutants('f.c', text)}
    assert {'double f(double m1, double m2) { ' + statement + ' }\n' for statement in (
        ';', 'return -m1 * sin(m2) - 2;', 'return m2 * sin(m2) - 2;', 'return m1 / sin(m2) - 2;', 'return m1  - 2;', 'return  sin(m2) - 2;',
        'return m1 * cos(m2) - 2;', 'return m1 * (m2) - 2;', 'return m1 * sin(m1) - 2;', 'return m1 * sin(m2) + 2;', 'return m1 * sin(m2) ;',
        'return - 2;', 'return m1 * sin(m2) - 1;', 'return m1 * sin(m2) - 3;')} == found, found
    text = 'steps:\n  a:\n    title: b + c\n    show: [x1 = -2*y1]  # d\n'
    found = {text[:start] + by + text[end:] for start, end, by, _ in mutants('f.yaml', text)}
    assert all('title: b + c' in mutant and '# d' in mutant for mutant in found - {text.replace('title', 'titlex')}), found
    assert {text.replace('-2', '2'), text.replace('*', '/'), text.replace('-2', '-3'), text.replace('x1', 'y1')} <= found, found
    text = 'int f(int a, int (*g)(int), double c[2])\n{\n    return a + 1;\n}\n'
    mutant = Mutant('ref/f.c', text, 49 + text[49:].index('+'), 50 + text[49:].index('+'), '-', 'operator', 'tokens')
    mutant.number = 7
    made = schemata('ref/f.c', text, [mutant], {})
    assert mutant.function == 1 and 'return a - 1;' in made and 'case 7: return f__m7(a, g, c);' in made, made

    chosen = [Mutant('ref/f.c', 'a + b\n', 2, 3, by, 'operator', 'tokens') for by in '-*/']
    planted, killed, other = chosen
    results = {planted.key: ('survived', ''), killed.key: ('killed', 'x'), other.key: ('killed', 'y (time)')}
    with contextlib.redirect_stdout(None):
        status = [summary(chosen, results, collections.Counter((m.file, m.shown) for m in known), everything)[0] for known, everything
                  in (([], chosen), ([], []), ([planted], chosen), ([planted, killed], chosen), ([planted, killed], []))]
    assert status == [1, 1, 0, 1, 0], status
    print('the runner finds a planted survivor and a stale line')
    return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('build', type=pathlib.Path, nargs='?')
    parser.add_argument('--self-test', action='store_true')
    parser.add_argument('--readme', action='store_true')
    parser.add_argument('--kind', choices=KINDS)
    parser.add_argument('--sample', type=int, default=0)
    parser.add_argument('--seed', default='1')
    parser.add_argument('--only', default='')
    parser.add_argument('--budget', type=float, default=60)
    parser.add_argument('--workers', type=int, default=os.cpu_count() or 1)
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    base, listing = arguments.build.resolve(), listed()
    everything = all_mutants(arguments.only)
    chosen = choose([m for m in everything if arguments.kind in (None, m.kind)], arguments.sample, arguments.seed, listing)
    tree, results = Tree(base), Results(base / 'results.csv')
    asked = [m for m in chosen if m.key not in results.known]
    if asked:
        dead, same = tree.compile([m for m in asked if m.file not in SHEETS]), tree.same_code()
        for m in asked:
            if m.number and m.number in dead | same:
                results.add(m, 'not viable' if m.number in dead else 'same code', 'compiler')
        judge = Judge(tree, arguments, results.world, sorted({m.function for m in asked}))
        for m, verdict, by in judge.verdicts([m for m in asked if m.key not in results.known]):
            results.add(m, verdict, by)
            if verdict == 'survived' and (m.file, m.shown) not in listing:
                print(f'survived {by}: {m.file}:{m.line}: {m.shown}', flush=True)
    status, tables = summary(chosen, results.known, listing, [] if arguments.sample else everything)
    if arguments.readme:
        put(README, re.sub(r'(?<=<!-- mutants -->\n).*(?=<!-- end -->)', lambda _: tables, README.read_text(), flags=re.S))
    return status


if __name__ == '__main__':
    sys.exit(main())
