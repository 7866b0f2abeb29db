"""Mutants: wrong programs, one point away from the right one, and whether the tests notice.

    python3 coverage/mutants.py BUILD    in the environment KIND=tokens|soundness SAMPLE=number SEED=any BUDGET=seconds WORKERS=number
                                         ONLY=how a file's name begins, each where it is wanted

The project is made in a copy, where each function says that it was reached. There the wrong file takes the place of the right
one for the time that it is asked, and make makes anew what comes of it. Verdicts are kept in BUILD/results.csv by the mutant's
content: a run that was cut short goes on, a kill stands, a survivor is asked again once anything in the project has changed.
coverage/README.md tells the rest.
"""
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
KINDS = ('tokens', 'soundness')
PROGRAM, SHEETS = 'build/coulomb-tether', ('paper/equations.yaml', 'paper/derivations.yaml', 'paper/claims.yaml')
STRICT = ('ref/', SHEETS[0])  # all that is equivalent there is listed, so that of a sample too nothing may survive
TOO_MANY, OF_THEM = ('verify/', 'tokens'), 250  # are sampled always
FILES = [str(file.relative_to(ROOT)) for folder in ('', 'coverage', 'data', 'paper', 'ref', 'tests', 'verify')
         for file in sorted((ROOT / folder).glob('**/*' if folder else '*')) if file.is_file()]
# Headers of verify/ and the public one declare, and compute nothing; the examples are built by their own test.
SOURCES = [file for file in FILES if file in (*SHEETS, 'ref/internal.h') or re.fullmatch(r'(ref|verify/\w+)/\w+\.c', file)]
WORLD = hashlib.sha256(b''.join((ROOT / file).read_bytes() for file in FILES if not file.startswith('coverage/'))).hexdigest()[:20]


class Mutant:
    """text[start:end] of a file replaced."""

    def __init__(self, file, kind, right, start, end, by):
        self.file, self.kind, self.right, self.start, self.end, self.by = file, kind, right, start, end, by
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


WORKER = threading.local()  # its place: a copy of what was made
FUNCTION = re.compile(r'^[a-z_][^\n;{}#=(]*\w\([^\n;{}#=]*(?:\n[ \t][^\n;{}=]*)*\)\n\{(?P<body>\n(?:(?!\}).*\n)*)^\}\n', re.M)


def functions(file, text):
    """Each with its number among those of all files."""
    return enumerate(FUNCTION.finditer(text), 128 * SOURCES.index(file))


def put(file, text):
    """Into the copy, each function with a mark in its first line."""
    for number, f in reversed([*functions(file, text)]):
        mark = f' extern unsigned char *mutant_reached_; mutant_reached_[{number}] = 1;'
        text = text[:f.start('body')] + mark + text[f.start('body'):]
    (WORKER.place / file).write_text(text)


def make(*goals):
    """The compiler's code; nothing where it refuses. What is wrong in a sheet is for the checks."""
    command = ['make', '-s', '-o', 'build/sheet.checked', 'all', 'suites', 'build/sheet-check', *goals]
    made = subprocess.run(command, cwd=WORKER.place, stderr=subprocess.DEVNULL).returncode == 0
    return [file.read_bytes() for file in sorted(WORKER.place.glob('build/[rv]e*/**/*.o')) if made]


# What a mutant leaves behind ends with it; and one that lost the process it asks for ends no other than its own.
APART = ['unshare', '--pid', '--fork', '--kill-child', '--mount-proc', *(['--map-root-user'] if os.getuid() else [])]


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
    """Asks them, each worker in a copy of the project."""

    def __init__(self, places, budget):
        self.places, self.budget, self.noticed = places, budget, collections.Counter()
        self.workers = concurrent.futures.ThreadPoolExecutor(len(places), initializer=self.begin)
        checks = list(all_checks())
        self.checks = [check for check, passes in zip(checks, self.workers.map(Check.learn, checks)) if passes]

    def begin(self):
        WORKER.place = self.places.pop()
        for file in FILES:
            (WORKER.place / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / file, WORKER.place / file)
        for file in SOURCES:
            put(file, (ROOT / file).read_text())
        shutil.copy2(ROOT / 'coverage/mutants.c', WORKER.place / 'ref/')
        self.right = make(*(f'build/{name}.json' for name in ('derivations', 'errors', 'equations')))  # as make check has them
        if not self.right:
            raise RuntimeError(f'mutants: make fails in {WORKER.place}')

    def ask(self, mutant):
        """Of the checks that reach it those first that are likely to notice it soon, until one does or its time is spent."""
        section = ''.join(re.findall(r'^  (\w+):', mutant.right[:mutant.end], re.M)[-1:])
        reached = (number for number, f in functions(mutant.file, mutant.right) if f.start() < mutant.start < f.end())
        function = section if mutant.file in SHEETS else next(reached, None)
        spent, (*_, room, stem, _) = 0, re.split('[/.]', mutant.file)

        def dear(check):
            met = 30 * self.noticed[mutant.file, function, check] + 6 * self.noticed[mutant.file, check]
            named = mutant.file in SHEETS and not {function, stem}.isdisjoint(check.command)
            return (check.cost + 0.03) / (1 + met + 4 * (check.room == room) + 1000 * named)
        for check in sorted((c for c in self.checks if function in (section, None, *c.reached)), key=dear):
            if spent and spent + check.cost > self.budget:
                continue
            found, _ = check.run(math.ceil(2 + 5 * check.cost))
            if found != check.right:
                self.noticed.update([(mutant.file, function, check), (mutant.file, check)])
                return mutant, 'killed', check.name
            spent += check.cost
        return mutant, 'survived', f'{spent:.1f} s'

    def verdict(self, mutant):
        """With by what; the wrong file stands in the place of the right one for the time."""
        put(mutant.file, mutant.text)
        made = make()
        verdict = 'not viable' if not made else 'same code' if made == self.right else ''
        result = (mutant, verdict, 'compiler') if verdict else self.ask(mutant)
        put(mutant.file, mutant.right)
        return result


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


def summary(chosen, known, listing, everything):
    """How many have which verdict, and what is wrong, in lines; of a sample `everything` is empty."""
    stale, counts, groups, wrong = collections.Counter(listing), collections.Counter(), collections.defaultdict(list), []
    for m in chosen:
        verdict = known[m.key]
        if verdict in ('survived', 'same code') and stale[m.name] > 0:  # one compiler sees more than another
            stale[m.name] -= 1
            verdict = 'listed'
        counts[verdict] += 1
        groups[m.group].append((verdict, m))
    for group, those in groups.items():
        survivors = [m for verdict, m in those if verdict == 'survived']
        strict = group[0] in STRICT or everything and group != TOO_MANY
        if len(survivors) > (0 if strict else 2 + 0.1 * len(those)):
            wrong += [f'survives, and is not in coverage/survivors.csv: {m}' for m in survivors]
    of_others = {m.name for m in everything} - {m.name for m in chosen}
    wrong += [f'is in coverage/survivors.csv, and does not survive: {": ".join(name)}' for name, left in stale.items()
              if everything and left > 0 and name not in of_others]
    return counts, wrong


def self_test():
    """A survivor that is not listed is wrong, and so is a listed one that does not survive."""
    one, other = chosen = [Mutant('ref/f.c', 'tokens', 'a + b\n', 2, 3, by) for by in '-*']
    known = {one.key: 'survived', other.key: 'killed'}
    wrong = [len(summary(chosen, known, names, chosen)[1]) for names in ([], [one.name], [one.name, other.name])]
    assert wrong == [1, 0, 1], wrong


def main():
    self_test()
    defaults = {'KIND': '', 'SAMPLE': 0, 'SEED': '1', 'ONLY': '', 'BUDGET': 60.0, 'WORKERS': os.cpu_count() or 1}
    try:
        kind, sample, seed, only, budget, workers = (type(value)(os.environ.get(name) or value) for name, value in defaults.items())
    except ValueError as error:
        sys.exit(f'mutants: SAMPLE, BUDGET and WORKERS are numbers: {error}')
    if len(sys.argv) != 2 or kind not in ('', *KINDS):
        sys.exit(__doc__)
    # What is used no longer is not wrong by that.
    os.environ.update(BUILD='build', CFLAGS='-O1 -fno-inline -Werror -Wno-unused-function -Wno-unused-const-variable',
                      CK_FORK='no', LC_ALL='C')

    with (ROOT / 'coverage/survivors.csv').open(newline='') as file:  # line numbers there are for the reader: lines move
        listing = [(row['file'], row['mutant']) for row in csv.DictReader(file) if row['file'].startswith(only)]
    everything = [Mutant(file, kind, text, *change) for file in SOURCES if file.startswith(only)
                  for text in [(ROOT / file).read_text()] for kind in KINDS if kind == 'tokens' or file.startswith('verify/')
                  for change in mutants(file, text, kind)]
    chosen = choose([m for m in everything if kind in ('', m.kind)], sample, seed, set(listing))
    base = pathlib.Path(sys.argv[1]).resolve()
    base.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(base / 'places', ignore_errors=True)
    subprocess.run([*APART, 'true'], check=True)  # or it says why not, before the long work
    with (base / 'results.csv').open('a+', newline='') as file:
        file.seek(0)
        known = {key: verdict for key, verdict, by, world in csv.reader(file) if verdict != 'survived' or world == WORLD}
        asked = [m for m in chosen if m.key not in known]
        judge = Judge([base / 'places' / str(n) for n in range(workers)], budget) if asked else None
        for m, verdict, by in judge.workers.map(judge.verdict, asked) if asked else ():
            known[m.key] = verdict
            csv.writer(file).writerow([m.key, verdict, by, WORLD])
            file.flush()
            if verdict == 'survived' and m.name not in listing:
                print(f'survived {by}: {m}', flush=True)
    of, wrong = summary(chosen, known, listing, [] if sample else everything)
    print(*wrong, f'{len(chosen)} made, {len(chosen) - of["not viable"]} viable, {of["killed"]} killed, '
          f'{of["listed"] + of["same code"]} equivalent, {of["survived"]} survived', sep='\n')
    return len(wrong) > 0


if __name__ == '__main__':
    sys.exit(main())
