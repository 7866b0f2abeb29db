"""Mutants: wrong programs, one point away from the right one, and whether the tests notice.

    python3 coverage/mutants.py BUILD [--kind soundness] [--sample N] [--seed S] [--only FILE, or how its name begins] [--workers N]
    python3 coverage/mutants.py --self-test

Every mutant of ref/ and of the three sheets, and a sample of verify/, is built and put before the fastest check that should
notice it; what passes of verify/, before the same under the sanitizers; what survives, before all. A mutant is one shared
library made anew, in a shadow of the source tree whose files are links. --kind soundness takes all of verify/ instead, by what makes a bound too narrow or a proof none, and
stops where the checks that should notice do not: no such survivor is let pass. Verdicts are kept in BUILD/results.csv, by the
mutant's content: a run that was cut short goes on, a kill stands, a survivor is asked again once anything in the project
has changed. coverage/survivors.csv lists the mutants that no check can kill, each with its reason. Run by `make mutants`,
which builds BUILD and BUILD/sanitized, and hands the commands over.
"""
import argparse
import atexit
import collections
import concurrent.futures
import contextlib
import csv
import functools
import hashlib
import itertools
import math
import os
import pathlib
import queue
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

from mutants_of import mutants

ROOT = pathlib.Path.cwd()
LISTED = ROOT / 'coverage/survivors.csv'
VERIFY_SAMPLE, VERIFY_SEED, VERIFY_LEAST = 250, 1, 0.9
LIKELY_LEAST = 0.8  # of the mutants of verify/ that the likely checks alone have to notice, in a sample; measured: 0.89
CC = shlex.split(os.environ.get('CC', 'cc'))
FLAGS = shlex.split(os.environ.get('MUTANT_FLAGS', ''))
LIBS = shlex.split(os.environ.get('MUTANT_LIBS', ''))
SANITIZE = shlex.split(os.environ.get('MUTANT_SANITIZE', ''))
STRICT = ['-O2', '-Wall', '-Wextra', '-Wpedantic', '-Werror']
ALONE = {'verify/command/main.c': 'coulomb-tether', 'verify/command/sheet_check.c': 'sheet-check'}
SHEETS = ('paper/equations.yaml', 'paper/derivations.yaml', 'paper/claims.yaml')
COUNTED = ('verify/', *SHEETS[1:])  # what a sample of these survives is counted, not pursued: not all that is equivalent is listed

Check = collections.namedtuple('Check', 'name command expected seconds')  # expected: what it has to print, where that counts


FILES = [str(file.relative_to(ROOT)) for folder in ('', 'coverage', 'data', 'paper', 'ref', 'tests', 'verify')
         for file in sorted((ROOT / folder).glob('**/*' if folder else '*')) if file.is_file()]


class Mutant:
    """text[start:end] of a file replaced."""

    def __init__(self, file, text, start, end, by):
        self.file, self.right, self.change = file, text, (start, end, by)

    @property
    def text(self):
        start, end, by = self.change
        return self.right[:start] + by + self.right[end:]

    @property
    def line(self):
        return self.right.count('\n', 0, self.change[0]) + 1

    @functools.cached_property
    def shown(self):
        """The changed line as a word diff, on one line."""
        start, end, by = self.change
        first, last = self.right.rfind('\n', 0, start) + 1, self.right.find('\n', end)
        line = f'{self.right[first:start]}[-{self.right[start:end]}-]{{+{by}+}}{self.right[end:last]}'
        return ' '.join(line.split())

    @functools.cached_property
    def key(self):
        return hashlib.sha256(f'{self.file}\0{self.text}'.encode()).hexdigest()[:20]


def mutants_of_file(file, kind):
    text = (ROOT / file).read_text()
    return [Mutant(file, text, *change) for change in mutants(file, text, kind)]


def part_of(file):
    return file if file in SHEETS else file.split('/')[0] + '/'


def all_mutants(only, kind):
    """By part: ref/, either sheet, verify/. Headers of verify/ and the public one declare, and compute nothing."""
    parts = collections.defaultdict(list)
    for file in FILES:
        if not file.startswith(only):
            continue
        if (file in SHEETS or file == 'ref/internal.h' or file.startswith(('ref/', 'verify/')) and file.endswith('.c')) and \
                (not kind or file.startswith('verify/')):
            parts[part_of(file)].extend(mutants_of_file(file, kind))
    return dict(parts)


# ---- running ----

def kill_session(session):
    """The tests start processes in groups of their own; what they have in common is the session."""
    for entry in pathlib.Path('/proc').glob('[0-9]*/stat'):
        try:
            if int(entry.read_text().rpartition(')')[2].split()[3]) == session:
                os.kill(int(entry.parent.name), signal.SIGKILL)
        except (OSError, ValueError, IndexError):
            pass  # it has ended by itself


def run(command, limit, output=subprocess.DEVNULL, **options):
    """Exit status, or None where it had to be stopped."""
    with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
                          **options) as process:
        try:
            return process.wait(limit)
        except subprocess.TimeoutExpired:
            kill_session(process.pid)
            return None


def objects(folder, besides=()):
    return sorted(str(o) for o in folder.glob('**/*.o') if o.stem not in besides)


class Place:
    """A shadow of the source tree and of the build, in which one mutant at a time lives."""

    def __init__(self, linked, name):
        self.linked, self.base = linked, linked.parent
        self.flags = FLAGS + SANITIZE * (self.base.name == 'sanitized')
        (self.base / 'places').mkdir(exist_ok=True)
        self.root = pathlib.Path(tempfile.mkdtemp(prefix=f'{name}-', dir=self.base / 'places'))
        self.build = self.root / 'build'
        atexit.register(shutil.rmtree, self.root, ignore_errors=True)
        for file in FILES:
            (self.root / file).parent.mkdir(parents=True, exist_ok=True)
            (self.root / file).symlink_to(ROOT / file)
        (self.build / 'tests').mkdir(parents=True)
        self.right = {}  # the code of files as they are
        self.fresh()
        self.environment = dict(
            os.environ, BUILD='build', CT_BUILD=str(self.build), CT_PROGRAM=str(self.build / 'coulomb-tether'),
            LD_LIBRARY_PATH=f'{self.build}/made:{linked}', LC_ALL='C',
            CK_TIMEOUT_MULTIPLIER='10' if self.base.name == 'sanitized' else '1')

    def fresh(self):
        shutil.rmtree(self.build / 'made', ignore_errors=True)
        (self.build / 'made').mkdir()
        for file in itertools.chain(*(self.linked.glob(part) for part in ('*', 'tests/*'))):
            link = self.build / file.relative_to(self.linked)
            if file.is_file() and file.suffix != '.so':
                link.unlink(missing_ok=True)
                link.symlink_to(file)

    def compiler(self, *arguments):
        return run([*CC, *self.flags, *arguments], 120, cwd=self.root) == 0

    def compiled(self, file, *flags, into='mutant'):
        """The objects of a file, or of all that includes it."""
        files = [file] if file.endswith('.c') else [f for f in FILES if f.startswith('ref/') and f.endswith('.c')]
        fine = all(self.compiler(*flags, '-c', f, '-o', str(self.build / 'made' / f'{pathlib.Path(f).stem}.{into}'))
                   for f in files)
        return [str(self.build / 'made' / f'{pathlib.Path(f).stem}.{into}') for f in files] if fine else None

    def make(self, mutant):
        """Whether the mutant could be built."""
        self.write(mutant)
        made = self.build / 'made'
        if mutant.file in SHEETS:  # the build stops where sheet-check does
            return run(['build/sheet-check', *SHEETS], 60, cwd=self.root, env=self.environment) == 0 and \
                run(['as', str(self.linked / 'embedded.s'), '-o', str(made / 'embedded.o')], 60, cwd=self.root) == 0 and \
                run(['ld', '-shared', str(made / 'embedded.o'), '-o', str(made / 'libembedded.so')], 60) == 0
        changed = self.compiled(mutant.file, '-w', '-Werror=return-type', '-Werror=implicit-function-declaration', '-O1')
        if changed is None:
            return False
        stems = {pathlib.Path(o).stem for o in changed}
        if mutant.file in ALONE:
            program = self.build / ALONE[mutant.file]
            program.unlink()
            return self.compiler(*changed, '-o', str(program), f'-L{self.linked}', *LINKED)
        library = 'libcoulombtether.so' if mutant.file.startswith('ref/') else \
            'libembedded.so' if mutant.file == 'verify/sheet/embedded.c' else 'libverify.so'
        others = {'libcoulombtether.so': objects(self.base / 'ref', stems), 'libembedded.so': [],
                  'libverify.so': objects(self.base / 'verify', stems | NOT_IN_LIBRARY)}[library]
        return self.compiler('-shared', *changed, *others, '-o', str(made / library))

    def same_code(self, mutant):
        """Whether the compiler makes the same of the mutant: then nothing can tell them apart."""
        if mutant.file in SHEETS:
            return False
        if mutant.file not in self.right:
            self.restore(mutant)
            self.right[mutant.file] = [pathlib.Path(o).read_bytes() for o in self.compiled(mutant.file, '-O2', '-w', into='right')]
            self.write(mutant)
        return self.right[mutant.file] == [pathlib.Path(o).read_bytes() for o in self.compiled(mutant.file, '-O2', '-w', into='same')]

    def refused(self, mutant):
        """Whether the compiler refuses it where warnings are errors."""
        return mutant.file not in SHEETS and self.compiled(mutant.file, *STRICT) is None

    def write(self, mutant):
        (self.root / mutant.file).unlink()
        (self.root / mutant.file).write_text(mutant.text)

    def restore(self, mutant):
        (self.root / mutant.file).unlink()
        (self.root / mutant.file).symlink_to(ROOT / mutant.file)

    def passes(self, check):
        """True, False, or None where it took too long."""
        output = self.build / 'printed'
        with open(output, 'wb') as sink:
            status = run(check.command, 6 + 4 * check.seconds, sink, cwd=self.root, env=self.environment)
        if status is None:
            return None
        return status == 0 and (check.expected is None or output.read_bytes() == check.expected)


LINKED = ['-lverify', '-lembedded', '-lcoulombtether', *LIBS]
OTHERWISE_LINKED = {'test_corpora'}  # asks that nothing crashes, not that anything is right
APART = {'test_ref_gsl'}  # has functions in the place of GSL's
NOT_IN_LIBRARY = {'main', 'sheet_check', 'embedded'}


def link_all(base):
    """Everything that make has compiled, linked to shared libraries, so that a mutant is one library."""
    newest = max(file.stat().st_mtime for folder in ('ref', 'verify', 'tests') for file in (base / folder).glob('**/*.o'))
    linked = base / f'linked-{newest}'
    if linked.exists():
        return linked
    final, linked = linked, base / f'linked-{os.getpid()}'
    linked.mkdir()
    flags = FLAGS + SANITIZE * (base.name == 'sanitized')

    def compiler(*arguments):
        subprocess.run([*CC, *flags, *arguments], check=True)

    compiler('-shared', *objects(base / 'ref'), '-o', str(linked / 'libcoulombtether.so'))
    compiler('-shared', *objects(base / 'verify', NOT_IN_LIBRARY), '-o', str(linked / 'libverify.so'))
    compiler('-shared', str(base / 'verify/sheet/embedded.o'), '-o', str(linked / 'libembedded.so'))
    compiler('-S', 'verify/sheet/embedded.c', '-o', str(linked / 'embedded.s'))
    programs = {'coulomb-tether': ['verify/command/main.o'], 'sheet-check': ['verify/command/sheet_check.o'],
                'client': ['tests/clients/client.o'], 'tests/faulty': ['tests/faulty.o']}
    suites = [o.relative_to(base) for o in base.glob('tests/*/test_*.o') if o.stem not in OTHERWISE_LINKED | APART]
    programs['tests/run'] = ['tests/run.o', 'tests/paper.o', *suites]
    for name in APART:
        programs[f'tests/{name}'] = ['tests/run.o', 'tests/paper.o', *(o.relative_to(base) for o in base.glob(f'tests/*/{name}.o'))]
    (linked / 'tests').mkdir(exist_ok=True)
    for name, parts in programs.items():
        compiler(*(str(base / part) for part in parts), '-o', str(linked / name), f'-L{linked}', *LINKED)
    # The gate wants the names of the tests that passed; the suites are checks of their own.
    names = [name for file in sorted((ROOT / 'tests').glob('*/test_*.c'))
             for name in re.findall(r'^(?:TEST|EACH|RANGE)\((\w+)[,)]', file.read_text(), re.M)]
    (linked / 'tests/all.tap').write_text(''.join(f'ok - all:all:{name}: Passed\n' for name in names))
    with open(linked / 'errors.json', 'wb') as file:
        subprocess.run([linked / 'coulomb-tether', 'verify', 'errors', '--json'], stdout=file, check=True,
                       env=dict(os.environ, LD_LIBRARY_PATH=str(linked)))
    try:
        return linked.rename(final)
    except OSError:  # another run was faster
        shutil.rmtree(linked)
        return final


# ---- the checks ----

SCALAR = ','.join(sorted(file.stem for file in (ROOT / 'data/golden').glob('eq*.csv')))

def available_checks():
    program = 'build/coulomb-tether'
    def data(file):
        return (ROOT / 'data' / file).read_bytes()
    checks = {'derivations': ([program, 'verify', 'derivations'], None),
              'oracle': ([program, 'conform', '--', 'build/client'], None),
              'oracle scalar': ([program, 'conform', '--only', SCALAR, '--', 'build/client'], None),
              'gate': (['sh', '-c', 'rm -f build/derivations.json && build/coulomb-tether verify derivations --json '
                                    '>build/derivations.json && tests/project/gate.sh'], None),
              'wrong': (['tests/command/test_wrong.sh'], None),
              'package': (['sh', '-c', 'find data -name "*.csv" | LC_ALL=C sort | xargs sha256sum | build/coulomb-tether datapackage'],
                          data('datapackage.json')),
              'errors': ([program, 'verify', 'errors'], None),
              'verdicts': ([program, 'verify', 'claims', '--csv'], data('verdicts.csv')),
              'table1': ([program, 'table1', '--csv'], data('table1.csv')),
              'figure4': ([program, 'figure', '4'], data('figure4.csv'))}
    for figure in ('5a', '5b', '6', '7a', '7b'):
        checks['figure' + figure] = ([program, 'figure', figure, '--rk4', '100'], data(f'figure{figure}.csv'))
    for study in ('convergence', 'forced', 'pitch'):
        checks['study ' + study] = ([program, 'study', study], data(f'{study}.csv'))
    for golden in sorted((ROOT / 'data/golden').glob('*.csv')):
        checks['golden ' + golden.stem] = ([program, 'vectors', golden.stem, '--golden'], golden.read_bytes())
        kills = [line for line in data('kills.csv').splitlines(keepends=True) if line.startswith((b'id,', f'{golden.stem}-'.encode()))]
        checks['kills ' + golden.stem] = ([program, 'conform', '--kills', '--only', golden.stem], b''.join(kills))
    for suite in sorted((ROOT / 'tests').glob('*/test_*.c')):
        if suite.stem not in OTHERWISE_LINKED:
            checks[suite.stem] = ([f'build/tests/{suite.stem}'] if suite.stem in APART else ['build/tests/run', suite.stem], None)
            for case in re.findall(r'^CASE(?:_ONCE)?\((\w+),', suite.read_text(), re.M):
                checks[f'{suite.stem} {case}'] = (['env', f'CK_RUN_CASE={case}', *checks[suite.stem][0]], None)
    return checks


REF = ('hill', 'perturbation', 'control', 'attitude', 'stability', 'simulation', 'gsl')

# What takes more than a second, and about how many; the order of the checks alone depends on it.
SLOW = {'golden flow_nonlinear': 1.3, 'golden rk4_nonlinear': 1, 'golden rk4_linear': 0.4, 'study convergence': 2.3, 'study pitch': 0.5,
        'kills flow_nonlinear': 8, 'kills rk4_nonlinear': 8, 'kills rk4_linear': 4, 'kills flow_linear': 4,
        'oracle': 3, 'errors': 1.5, 'verdicts': 7, 'wrong': 10, 'test_trajectory': 2, 'test_statement': 1.3,
        'test_command_line': 24, 'test_conform': 18, 'test_convergence': 10, 'test_derivation': 5, 'test_flow': 6, 'test_vectors': 3}


class Checks:
    """The checks by name. Each is first put before the right program: that has to pass, and tells the time."""

    def __init__(self, linked):
        self.linked, self.locks, self.known = linked, collections.defaultdict(threading.Lock), {}
        self.commands = available_checks()
        self.names = sorted(self.commands, key=lambda name: SLOW.get(name, 0))

    def __getitem__(self, name):
        with self.locks[name]:
            if name not in self.known:
                began, place = time.monotonic(), Place(self.linked, 'right-' + name.replace(' ', '-'))
                check = Check(name, *self.commands[name], 120)
                if not place.passes(check):
                    print(f'mutants: {name} does not pass the program as it is', (place.build / 'printed').read_text(), file=sys.stderr)
                    os._exit(2)
                self.known[name] = check._replace(seconds=time.monotonic() - began)
            return self.known[name]


def section_at(mutant):
    """The section of the sheet that a line lies in."""
    for line in reversed(mutant.text.split('\n')[:mutant.line]):
        if line.startswith('  ') and line[2:3] not in (' ', '-', ''):
            return line.strip().split(':')[0]
    return ''


def of_quantity(names):
    """The golden vectors of one section that has an input of these."""
    named = set(names.replace('"', '').split())
    for golden in sorted((ROOT / 'data/golden').glob('eq*.csv'), key=lambda file: file.stat().st_size):
        header = golden.open().readline().strip().split(',')
        outputs = {column[2:] for column in header if column.startswith('S_')}
        if named & set(header) - outputs:
            return ['golden ' + golden.stem]
    return []


# The checks that a part reaches at all, as regular expressions: verify/ calls ref/ in reference.c alone, and reads the steps
# in proof_results.c alone.
REACHED = {'ref/': 'test_ref_|test_units|test_mistakes|test_vectors|test_conform|test_verdicts|test_command|oracle|errors|gate',
           SHEETS[2]: 'verdicts|wrong|test_statement|test_verdicts',
           SHEETS[1]: 'derivations|gate|test_derivation|verdicts|test_trajectory|test_convergence|study|test_command|test_typeset'}

# The checks that should notice a mutant of a file in verify/, the fastest first, by the longest beginning of its name.
NOTICED_BY = dict((line.split()[0], ' '.join(line.split()[1:]).split(', ')) for line in (ROOT / 'coverage/noticed.txt').read_text().splitlines())


def likely(mutant):
    """The checks that should notice a mutant, the fastest first."""
    stem = pathlib.Path(mutant.file).stem
    if mutant.file == SHEETS[0]:
        section = section_at(mutant)
        return ['test_vectors golden', 'golden ' + section, *of_quantity(section), 'test_units', 'test_mistakes', 'derivations', 'test_sheet',
                'test_vectors domains', 'gate', 'table1']
    if mutant.file == SHEETS[1]:
        return ['derivations', 'gate']
    if mutant.file == SHEETS[2]:
        return ['verdicts', 'test_verdicts']
    if mutant.file.startswith('ref/'):
        return [f'test_ref_{stem}', 'oracle scalar', *(f'test_ref_{other}' for other in REF)]
    return NOTICED_BY[max((name for name in NOTICED_BY if stem.startswith(name)), key=len)]


MOST_SANITIZED = 30  # seconds
STAGES = ('', 'passed', 'clean', 'survived')  # what comes of a mutant that nothing notices


def verdict_on(place, mutant, checks, stage):
    """(killed, same code, not viable, or where nothing notices the stage; and by what)."""
    place.fresh()
    first = [name for name in dict.fromkeys(likely(mutant)) if name in checks.commands]
    if stage == 'clean':  # the sanitizers multiply what they look at
        first = [name for name in first if SLOW.get(name, 0) < MOST_SANITIZED]
    try:
        if not place.make(mutant):
            return ('killed', 'sheet-check') if mutant.file in SHEETS else ('not viable', 'compiler')
        reached = re.compile(REACHED.get(part_of(mutant.file), ''))
        others = [n for n in checks.names if n not in first and reached.match(n)]
        for number, name in enumerate(others if stage == 'survived' else first):
            if number == 1 and stage == 'passed' and place.same_code(mutant):
                return 'same code', 'compiler'
            passed = place.passes(checks[name])
            if not passed:
                return 'killed', name + (' (time)' if passed is None else ' (sanitizers)' * (stage == 'clean'))
        if stage == 'passed' and place.refused(mutant):
            return 'not viable', 'compiler, warnings are errors'
        return stage, ''
    finally:
        place.restore(mutant)


# ---- many of them ----

class Results:
    """What is known, in BUILD/results.csv; a survivor only so long as the project is what it was."""

    def __init__(self, path):
        self.path, self.lock, self.known, self.before = path, threading.Lock(), {}, set()
        world = hashlib.sha256()
        for file in FILES:
            if not file.startswith('coverage/') and (ROOT / file).is_file():
                world.update((ROOT / file).read_bytes())
        self.world = world.hexdigest()[:20]
        if path.exists():
            for row in csv.reader(path.open(newline='')):
                if len(row) == 4 and (row[1] not in STAGES or row[3] == self.world):
                    self.known[row[0]] = (row[1], row[2])
                self.before.add(row[0])

    def add(self, mutant, verdict, by):
        with self.lock:
            self.known[mutant.key] = (verdict, by)
            with self.path.open('a', newline='') as file:
                csv.writer(file).writerow([mutant.key, verdict, by, self.world])


def judge(linked, chosen, results, stage, workers):
    """Every processor takes the next mutant of those that the stages before have left."""
    left, checks = queue.SimpleQueue(), Checks(linked)
    before = STAGES[:STAGES.index(stage)]
    asked = [mutant for mutant in chosen if results.known.get(mutant.key, ('', ''))[0] in before]
    for mutant in sorted(asked, key=lambda mutant: mutant.key in results.before):  # the new ones first
        left.put(mutant)
    began, done = time.monotonic(), itertools.count(1)

    def work(name):
        place = Place(linked, name)
        while True:
            try:
                mutant = left.get_nowait()
            except queue.Empty:
                return
            verdict, by = verdict_on(place, mutant, checks, stage)
            results.add(mutant, verdict, by)
            number = next(done)
            if sys.stderr.isatty():
                rest = (time.monotonic() - began) / number * (len(asked) - number)
                print(f'\r{number} of {len(asked)} mutants, {rest / 60:.0f} min left \x1b[K', end='', file=sys.stderr)
            if verdict == stage:
                print(f'{verdict}: {mutant.file}:{mutant.line}: {mutant.shown}', flush=True)

    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        try:
            list(pool.map(work, map(str, range(workers))))
        except BaseException:
            while not left.empty():  # nobody begins another
                left.get()
            raise
    if sys.stderr.isatty() and asked:
        print(file=sys.stderr)


def listed():
    """How often each mutant is listed, and why; the line number is for the reader, for lines move."""
    with LISTED.open(newline='') as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        if not row['reason']:
            sys.exit(f"mutants: {LISTED.name}: no reason for {row['file']}:{row['line']}")
    return collections.Counter((row['file'], row['mutant']) for row in rows)


def most_survivors(made):
    """Of so many, more than these survive with a chance of 1 in 1000 where 1 - LIKELY_LEAST is the share of all."""
    share, rest = 1 - LIKELY_LEAST, 1.0
    for number in range(made + 1):
        rest -= math.comb(made, number) * share**number * (1 - share)**(made - number)
        if rest < 0.001:
            return number
    return made


def summary(parts, results, known, complete, every=False):
    """A line a part, then what is wrong; the status."""
    status, unlisted = 0, []
    stale = collections.Counter(known)
    print(f"{'':24}{'made':>7}{'viable':>8}{'killed':>8}{'by time':>9}{'equivalent':>12}{'survived':>10}{'score':>9}")
    for part, chosen in parts.items():
        count, survivors = collections.Counter(), []
        for mutant in chosen:
            verdict, by = results.known.get(mutant.key, ('unknown', ''))
            count[verdict] += 1
            count['time'] += by.endswith('(time)')
            if verdict in STAGES:
                name = (mutant.file, mutant.shown)
                if stale[name] > 0:
                    stale[name] -= 1
                    count['listed'] += 1
                else:
                    survivors.append(mutant)
        judged = count['killed'] + len(survivors)
        score = count['killed'] / judged if judged else 1
        print(f"{part:24}{len(chosen):7}{len(chosen) - count['not viable']:8}{count['killed']:8}{count['time']:9}"
              f"{count['listed'] + count['same code']:12}{len(survivors):10}{math.floor(1000 * score) / 10:7.1f} %")
        if part not in COUNTED or every or complete and part != 'verify/':
            unlisted += survivors
        elif len(survivors) > (judged * (1 - VERIFY_LEAST) if complete else most_survivors(judged)):
            unlisted += survivors
    for mutant in unlisted:
        print(f'survives, and is not in coverage/survivors.csv: {mutant.file}:{mutant.line}: {mutant.shown}')
        status = 1
    asked = {(mutant.file, mutant.shown) for chosen in parts.values() for mutant in chosen}
    for (file, text), number in stale.items():
        if complete and number > 0 and ((file, text) in asked or part_of(file) in parts and not file.startswith('verify/')):
            print(f'is in coverage/survivors.csv, and does not survive: {file}: {text}')
            status = 1
    return status


def draw(chosen, number, seed):
    """So many of the mutants, by lot. A change elsewhere leaves them drawn: the lot of each is its own."""
    def lot(mutant):
        return hashlib.sha256(f'{seed}\0{mutant.file}\0{mutant.shown}'.encode()).digest()
    return sorted(chosen, key=lot)[:number]


def choose(parts, arguments, known):
    """All of ref/ and the sheets and a sample of verify/; or of each part a sample of what is not listed.

    A mutant of verify/, or of the claims, takes as long as a dozen others, for its checks follow motions, and so a tenth of the
    sample is of each.
    """
    if arguments.kind and not arguments.sample:
        return parts
    if not arguments.sample:
        return {part: draw(chosen, VERIFY_SAMPLE, VERIFY_SEED) if part == 'verify/' else chosen for part, chosen in parts.items()}
    return {part: draw([mutant for mutant in chosen if (mutant.file, mutant.shown) not in known],
                       math.ceil(arguments.sample * (0.1 if part in ('verify/', SHEETS[2]) else 0.3)), arguments.seed)
            for part, chosen in parts.items()}


def self_test():
    """The points of a line of C are those written here; a survivor that is not listed is found, and a line without one."""
    text = 'double f(double m1, double m2) { return m1 * sin(m2) - 2; }\n'
    found = {text[:start] + by + text[end:] for start, end, by in mutants('f.c', text)}
    assert {'double f(double m1, double m2) { ' + statement + ' }\n' for statement in (
        ';', 'return -m1 * sin(m2) - 2;', 'return m2 * sin(m2) - 2;', 'return m1 / sin(m2) - 2;', 'return m1  - 2;', 'return  sin(m2) - 2;',
        'return m1 * cos(m2) - 2;', 'return m1 * (m2) - 2;', 'return m1 * sin(m1) - 2;', 'return m1 * sin(m2) + 2;', 'return m1 * sin(m2) ;',
        'return - 2;', 'return m1 * sin(m2) - 1;', 'return m1 * sin(m2) - 3;')} == found, found
    text = 'steps:\n  a:\n    title: b + c\n    show: [x1 = -2*y1]  # d\n'
    found = {text[:start] + by + text[end:] for start, end, by in mutants('f.yaml', text)}
    assert all('title: b + c' in mutant and '# d' in mutant for mutant in found - {text.replace('title', 'titlex')}), found
    assert {text.replace('-2', '2'), text.replace('*', '/'), text.replace('-2', '-3'), text.replace('x1', 'y1')} <= found, found

    chosen = [Mutant('ref/f.c', 'a + b\n', 2, 3, by) for by in '-*/']
    planted, killed, other = chosen
    results = argparse.Namespace(known={planted.key: ('survived', ''), killed.key: ('killed', 'x'), other.key: ('killed', 'y (time)')})
    with contextlib.redirect_stdout(None):
        status = [summary({'ref/': chosen}, results, collections.Counter((m.file, m.shown) for m in known), complete) for known, complete
                  in (([], True), ([], False), ([planted], True), ([planted, killed], True), ([planted, killed], False))]
    assert status == [1, 1, 0, 1, 0], status
    stems = {pathlib.Path(file).stem for file in FILES if file.startswith('verify/') and file.endswith('.c')}
    without = [stem for stem in sorted(stems) if not any(stem.startswith(name) for name in NOTICED_BY)]
    idle = [name for name in NOTICED_BY if not any(stem.startswith(name) for stem in stems)]
    assert not without and not idle, f'coverage/noticed.txt: no line for {without}, no file for {idle}'
    print('the runner finds a planted survivor and a stale line')
    return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('build', type=pathlib.Path, nargs='?')
    parser.add_argument('--self-test', action='store_true')
    parser.add_argument('--kind', choices=['soundness'], default='')
    parser.add_argument('--sample', type=int, default=0)
    parser.add_argument('--seed', default='1')
    parser.add_argument('--only', default='')
    parser.add_argument('--workers', type=int, default=os.cpu_count() or 1)
    arguments = parser.parse_args()
    if arguments.self_test:
        return self_test()
    base = arguments.build.resolve()
    known = listed()
    parts = choose(all_mutants(arguments.only, arguments.kind), arguments, known)
    results = Results(base / 'results.csv')
    linked = link_all(base)
    chosen = list(itertools.chain(*parts.values()))
    judge(linked, chosen, results, 'passed', arguments.workers)
    if arguments.kind:
        return summary(parts, results, known, not arguments.sample, not arguments.sample)
    # What is listed is equivalent, and so no check will kill it; what a sample of verify/ survives is counted, not pursued.
    chosen = [mutant for mutant in chosen if (mutant.file, mutant.shown) not in known]
    judge(link_all(base / 'sanitized'), [mutant for mutant in chosen if mutant.file.startswith('verify/')], results, 'clean',
          arguments.workers)
    if arguments.sample:
        chosen = [mutant for mutant in chosen if part_of(mutant.file) not in COUNTED]
    judge(linked, chosen, results, 'survived', arguments.workers)
    return summary(parts, results, known, not arguments.sample)


if __name__ == '__main__':
    sys.exit(main())
