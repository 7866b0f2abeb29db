"""The one-point mutants of a source file: of C, and of the three sheets.

mutants(path, text, kind) yields (start, end, replacement, what): text[start:end] is to be replaced; `what` names it in the table.

Of C: every operator, sign, constant, comparison, argument, term, index and statement inside braces, one at a time; a
name that has a sibling (m1 and m2, x, y and z) is exchanged for it. Not mutated, for no program is wrong by it: comments,
#include, members of structures, sizes of arrays (an array may be longer), the order of arguments where it does not count.

Of C, soundness alone: what makes a bound too narrow or a proof none, at every place where it can be done.

Of YAML: every word, number and operator outside comments and prose, one at a time; of the steps also an equality left out or made
a tautology, an entry of from or to left out.
"""
import itertools
import re

import yaml

# ---- names that are mistaken for each other ----

FAMILIES = """m1 m2; m1 m2 m3; x y z; u v w; psi theta; psi_dot theta_dot; psi_ddot theta_ddot; dL dL_dot; L L_dot; L_ref L; Q_ref Q;
x1 y1 z1; x2 y2 z2; x3 y3 z3; x1_dot y1_dot z1_dot; x2_dot y2_dot z2_dot; x3_dot y3_dot z3_dot;
x1_ddot y1_ddot z1_ddot; x2_ddot y2_ddot z2_ddot; x3_ddot y3_ddot z3_ddot; X Y Z; dQ dL;
q1 q2 q3; C1 C2; re im; r1 r2; r v; a0 a1 a2 a3 a4; i j; margin1 margin2; I_11 I_22 I_33; I_12 I_13 I_23; R_c1 R_c2 R_c3;
L_G1 L_G2 L_G3; w_1 w_2 w_3; w_dot_1 w_dot_2 w_dot_3; f_12 f_13 f_23; r_12 r_13 r_23; sin cos; true false; theta_dot_ psi_dot_;
left right; at_zero m; CT_OK CT_DOMAIN CT_CONVERGENCE CT_MEMORY; GSL_SUCCESS GSL_EDOM; Omega k_c; NAN 0; INFINITY 1;
DBL_EPSILON DBL_MIN; floor ceil; min max; MPFR_RNDN MPFR_RNDU; MPFR_RNDU MPFR_RNDD; MPFR_RNDD MPFR_RNDN; break continue"""


def siblings(families):
    sibling = {}
    for family in families.replace('\n', ' ').split(';'):
        names = family.split()
        for name, other in zip(names, names[1:] + names[:1]):
            sibling.setdefault(name, other)
    return sibling


SIBLING = siblings(FAMILIES)

# What stands in the sheets beside formulas.
YAML_SIBLING = siblings("""m s kg C N rad; geometry motion gravity coulomb feedback stability; free positive angles;
flow_linear rk4_linear; flow_nonlinear rk4_nonlinear; edge sign zero cancellation large small paper gains; let outputs inputs;
sqrt exp; atan2 sin; from to; value example; rate sin; inf 1; eq10 eq10lin; eq11 eq11exact""") | SIBLING

# ---- C ----

TOKEN = re.compile(r"""(?P<blank>\s+|/\*.*?\*/|//[^\n]*|^[ \t]*\#[ \t]*(?!define)(?:[^\n]|\\\n)*)
    |(?P<define>^[ \t]*\#[ \t]*define[ \t]+\w+(?:\([^)]*\))?)
    |(?P<text>"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')
    |(?P<number>0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?[uUlL]*|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfF]*)
    |(?P<name>[A-Za-z_]\w*)
    |(?P<mark><<=|>>=|\.\.\.|->|\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|.)""", re.X | re.S | re.M)

PRECEDENCE = {'*': 10, '/': 10, '%': 10, '+': 9, '-': 9, '<<': 8, '>>': 8, '<': 7, '>': 7, '<=': 7, '>=': 7,
              '==': 6, '!=': 6, '&': 5, '^': 4, '|': 3, '&&': 2, '||': 1}
OPERATOR = {'+': ['-'], '-': ['+'], '*': ['/'], '/': ['*'], '%': ['/'], '&&': ['||'], '||': ['&&'], '&': ['|'], '|': ['&'],
            '<<': ['>>'], '>>': ['<<'], '<': ['<=', '>='], '<=': ['<', '>'], '>': ['>=', '<='], '>=': ['>', '<'],
            '==': ['!='], '!=': ['=='], '+=': ['-='], '-=': ['+='], '*=': ['/='], '/=': ['*='], '++': ['--'], '--': ['++'],
            '|=': ['&='], '&=': ['|=']}
DROPPED = {'+': 'both', '-': 'both', '*': 'both', '/': 'right', '%': 'right', '&&': 'both', '||': 'both'}
ASSIGNMENT = {'=', '+=', '-=', '*=', '/=', '%=', '|=', '&=', '<<=', '>>='}
OPEN, CLOSE = {'(': ')', '[': ']', '{': '}'}, {')', ']', '}'}
CONTROL = {'if', 'for', 'while', 'switch', 'return', 'sizeof', 'else', 'do', 'case', 'default', 'goto'}
TYPES = {'const', 'static', 'inline', 'struct', 'enum', 'union', 'double', 'int', 'char', 'bool', 'void', 'unsigned', 'long',
         'signed', 'float', 'size_t', 'complex', 'FILE', 'extern', 'typedef', 'uint64_t', 'ulong', 'slong'}
ORDERLESS = {'POSITIVE', 'FINITE', 'sum', 'dot', 'hypot', 'sizeof'}
COMMUTATIVE = re.compile('(arb|acb|arf|mag|fmpq|fmpz|mpfr|arb_poly|acb_poly|fmpq_poly|arb_mat|nmod)_(add|f?max|min)|'
                         '(arb|acb|arf|mag|fmpq|fmpz|mpfr|arb_poly|acb_poly|fmpq_poly|nmod)_(mul|mullow)')  # (z, x, y, ...)
# Soundness: what a call is exchanged for, calls that add something, and calls whose first argument is a ball made anew.
LOOSER = dict(pair.split(':') for pair in """upper:lower lower:upper arb_get_mag:arb_get_mag_lower mag_set_d:mag_set_d_lower
mag_mul:mag_mul_lower mag_div:mag_div_lower mag_add:mag_add_lower mag_max:mag_min arb_max:arb_min
arb_get_abs_ubound_arf:arb_get_abs_lbound_arf arb_get_abs_lbound_arf:arb_get_abs_ubound_arf arb_get_ubound_arf:arb_get_lbound_arf
arb_get_lbound_arf:arb_get_ubound_arf arb_is_positive:arb_is_nonnegative arb_is_negative:arb_is_nonpositive arb_lt:arb_le
arb_gt:arb_ge arb_contains:arb_overlaps ARF_RND_UP:ARF_RND_DOWN ARF_RND_CEIL:ARF_RND_FLOOR ARF_RND_FLOOR:ARF_RND_CEIL
MPFR_RNDU:MPFR_RNDD MPFR_RNDD:MPFR_RNDU""".split())
ADDS = re.compile(r'\w*(?:add|max|union|error|absolute)\w*')
BALL = re.compile(r'arb_(?!get|is|init|clear|swap|const|mat|poly|zero|one|set_(?:d|[su]i|arf)$)\w+')
# These decide how sharp a bound is, never whether it holds: directions of a set, lengths of steps, which set to split. And room is made here.
GUIDES = re.compile(r'project|orthonormalise|choose_basis|expansion_position|(?:set_)?step_length|is_steady|steepest|is_loose|width|is_wide|'
                    r'\w+_(?:init|clear)')
MOST_FACTOR = 16  # what is larger are bits
NUMERIC = re.compile(r'(?:arb|acb|arf|mag|fmpq|fmpz|mpfr)_(?!dot)\w+')
TRANSPARENT = {'sqrt', 'exp', 'sin', 'cos', 'fabs', 'cabs'}


class C:
    def __init__(self, text):
        self.text, self.partner, stack = text, {}, []
        self.marks = [(m.lastgroup, m.group(), m.start(), m.end()) for m in TOKEN.finditer(text) if m.lastgroup != 'blank']
        for i, (_, word, _, _) in enumerate(self.marks):
            if word in OPEN:
                stack.append(i)
            elif word in CLOSE and stack:
                self.partner[i], self.partner[stack[-1]] = stack[-1], i
                stack.pop()
        self.live, self.block = self.regions()
        self.simple, self.declarators = self.statements()

    def word(self, i):
        return self.marks[i][1] if 0 <= i < len(self.marks) else ''

    def kind(self, i):
        return self.marks[i][0] if 0 <= i < len(self.marks) else ''

    def source(self, first, last):
        return self.text[self.marks[first][2]:self.marks[last][3]]

    def replace(self, first, last, by, what):
        return self.marks[first][2], self.marks[last][3], by, what

    def operand_before(self, i):
        """Whether token i - 1 ends an operand, so that an operator at i is binary."""
        if self.kind(i - 1) == 'name':
            return self.word(i - 1) not in CONTROL | TYPES and self.word(i - 2) not in ('struct', 'enum')
        if self.word(i - 1) == ')':  # the end of a cast: a type in parentheses
            return self.word(self.partner[i - 1] + 1) not in TYPES or self.word(self.partner[i - 1] - 1) == 'sizeof'
        return self.kind(i - 1) in ('number', 'text') or self.word(i - 1) == ']'

    def operand(self, i, step, least):
        """The last token of the operand beside the operator i, behind it or (step -1) before it, of operators that bind more than `least`."""
        k = i + step
        while 0 <= k < len(self.marks):
            word = self.word(k)
            if word in (OPEN if step > 0 else CLOSE) and (word != '}' or self.word(self.partner.get(k, k) - 1) == ')'):
                k = self.partner.get(k, k)
            elif word in OPEN or word in CLOSE or word in {',', ';', '?', ':', 'return'} | ASSIGNMENT:
                break
            elif PRECEDENCE.get(word, 99) < least + (step > 0) and self.operand_before(k):
                break
            k += step
        return k - step

    def parts(self, opening):
        """What stands between the commas of a bracket, as (first, last)."""
        parts, first, end = [], opening + 1, self.partner[opening]
        k = first
        while k < end:
            k = self.partner[k] if self.word(k) in OPEN else k
            if self.word(k) == ';':
                return []
            if self.word(k) == ',':
                parts.append((first, k - 1))
                first = k + 1
            k += 1
        return parts + [(first, end - 1)] if first < end else parts

    def regions(self):
        """For each token whether it may be mutated: inside braces that hold no members, and in macros; and where blocks open."""
        live, block = [False] * len(self.marks), set()
        for i, end in self.partner.items():
            if self.word(i) == '{':
                fields = {self.word(i - 1), self.word(i - 2) if self.kind(i - 1) == 'name' else ''} & {'struct', 'union'}
                if not fields and ';' in (self.word(k) for k in range(i, end)):
                    block.add(i)
                live[i + 1:end] = [not fields] * (end - i - 1)
        for k in (k for k, token in enumerate(self.marks) if token[0] == 'define'):
            end = re.compile(r'(?<!\\)\n').search(self.text, self.marks[k][3]).start()
            live[k + 1:] = [may or self.marks[q][2] < end for q, may in enumerate(live[k + 1:], k + 1)]
        return live, block

    def statements(self):
        """The simple statements, as (first, last), and for each declaration the tokens before its '='."""
        simple, declarators = [], set()
        for opening in self.block:
            k, end = opening + 1, self.partner[opening]
            while k < end:
                first = k
                while (word := self.word(first)) in CONTROL - {'return', 'sizeof', 'goto'}:
                    if word in ('case', 'default'):
                        first = next(q for q in range(first, end) if self.word(q) == ':')
                    elif self.word(first + 1) == '(' and word != 'else':
                        first = self.partner[first + 1]
                    first += 1
                if word == '{' and first in self.block:
                    k = self.partner[first] + 1
                    continue
                last = first
                while last < end and self.word(last) != ';':
                    last = self.partner.get(last, last) + 1 if self.word(last) in OPEN else last + 1
                if self.declares(first):
                    declarators.update(itertools.takewhile(lambda q: self.word(q) != '=', range(first, last)))
                elif last > first:
                    simple.append((first, last))
                k = last + 1
        return simple, declarators

    def declares(self, first):
        word, after = self.word(first), first + 1 + (self.word(first + 1) == '*')
        return word in TYPES or self.kind(first) == 'name' and word not in CONTROL and self.kind(after) == 'name'

    def tokens(self):
        for first, last in self.simple:
            yield self.replace(first, last, ';', 'statement')
        for i, (kind, word, start, end) in enumerate(self.marks):
            if not self.live[i] or i in self.declarators:
                continue
            if kind == 'number':
                yield from self.constants(i)
            elif kind == 'name':
                if word in SIBLING:
                    yield start, end, SIBLING[word], 'name'
                if word in TRANSPARENT and self.word(i + 1) == '(':
                    yield start, end, '', 'name'
            elif word in OPEN:
                yield from self.exchanges(i)
            if word == '[' and i in self.partner and not (self.kind(i + 1) == 'number' and self.partner[i] == i + 2) and \
                    self.partner[i] > i + 1 and self.operand_before(i):
                yield from ((self.marks[self.partner[i]][2],) * 2 + (change, 'index') for change in (' + 1', ' - 1'))
            if word == '!' or word == '-' and not self.operand_before(i):
                yield start, end, '', 'sign'
            elif word in OPERATOR and (word not in PRECEDENCE or self.operand_before(i)):
                yield from ((start, end, other, 'operator') for other in OPERATOR[word])
                yield from self.drops(i)
            if word in ('return', '=', '?', ':', ',', '{') and self.signs(i):
                yield self.marks[i + 1][2], self.marks[i + 1][2], '-', 'sign'

    def signs(self, i):
        """Whether an arithmetic expression without a sign begins behind token i."""
        last = self.operand(i, 1, 0)
        words = {self.word(k) for k in range(i + 1, last + 1)}
        return last > i and (self.word(i) not in (',', '{') or self.in_list(i)) and self.kind(i + 1) in ('name', 'number') and \
            self.word(i + 1) not in {'0', 'NAN', 'true', 'false'} | TYPES and not words & {'&&', '||', '<', '>', '<=', '>=', '==', '!=', '?'}

    def opening(self, i):
        """The bracket that token i stands in."""
        while i >= 0 and self.word(i) not in OPEN:
            i = self.partner.get(i, i) - 1
        return i

    def in_list(self, i):
        k = self.opening(i)
        return self.word(k) == '{' and not any(self.word(q) == ';' for q in range(k, self.partner.get(k, k)))

    def constants(self, i):
        _, word, start, end = self.marks[i]
        if re.fullmatch(r'\d+[uUlL]*', word):
            value, suffix = re.fullmatch(r'(\d+)(.*)', word).groups()
            others = f'{int(value) + 1}{suffix}', f'{int(value) - 1}{suffix}' if int(value) else '-1'
        else:
            zero = float(word.rstrip('fFlLuU') if 'x' not in word.lower() else float.fromhex(word.rstrip('uUlL'))) == 0
            others = ('1.0',) if zero else (f'(2 * {word})', f'({word} / 2)')
        yield from ((start, end, other, 'constant') for other in others)

    def exchanges(self, i):
        """Neighbours in a list exchanged; in a set that must all be within its bounds, each left out."""
        called = self.word(i - 1) if self.word(i) == '(' and self.kind(i - 1) == 'name' else ''
        if i not in self.partner or i in self.block or self.word(i) != '{' and (not called or called in CONTROL):
            return
        parts = self.parts(i)
        if called in ('POSITIVE', 'FINITE') and len(parts) > 1:
            yield from (self.replace(first - (k > 0), last + (k == 0), '', 'argument') for k, (first, last) in enumerate(parts))
        for number, ((a, b), (c, d)) in enumerate(zip(parts, parts[1:])):
            if called not in ORDERLESS and not (number == 1 and COMMUTATIVE.fullmatch(called)) and \
                    self.source(a, b) != self.source(c, d) and self.word(a) != '.':
                yield self.replace(a, d, f'{self.source(c, d)}, {self.source(a, b)}', 'argument')

    def drops(self, i):
        word = self.word(i)
        if word in DROPPED:
            first, last = self.operand(i, -1, PRECEDENCE[word]), self.operand(i, 1, PRECEDENCE[word])
            if first < i < last + 1:
                what = 'condition left out' if word in ('&&', '||') else 'term left out'
                yield self.replace(i, last, '', what)
                if DROPPED[word] == 'both':
                    yield self.replace(first, i, '-' if word == '-' else '', what)

    def soundness(self):
        """An error not added, a radius cleared, a bound exchanged or off by one, a proof or a refusal not asked for."""
        guides = {k for i, end in self.partner.items() if self.word(i) == '{' and self.word(i - 1) == ')'
                  and GUIDES.fullmatch(self.word(self.partner[i - 1] - 1)) for k in range(i, end)}
        for first, last in self.simple:
            if ADDS.fullmatch(self.word(first)) and first not in guides:
                yield self.replace(first, last, ';', 'error not added')
            if BALL.fullmatch(self.word(first)) and first not in guides:
                ball = self.source(*self.parts(first + 1)[0])
                yield self.replace(first, last, f'{{ {self.source(first, last)} mag_zero(arb_radref({ball})); }}', 'radius cleared')
        for i, (kind, word, start, end) in enumerate(self.marks):
            if not self.live[i] or i in guides:
                continue
            after, around = self.partner.get(i + 1, i) + 1, self.opening(i)
            caller = self.word(around - 1) if self.word(around) == '(' else ''
            if word in LOOSER:
                yield start, end, LOOSER[word], 'bound exchanged'
            elif kind == 'number' and word.isdigit() and NUMERIC.fullmatch(caller) and int(word) < MOST_FACTOR and \
                    self.word(i - 1) not in ('+', '-'):
                yield from self.constants(i)
            elif kind == 'number' and word.isdigit() and self.in_list(i) and '=' in (self.word(i - 1), self.word(i - 2)):
                yield start, end, f'(2 * {word})', 'constant'
            elif word in ('<', '>', '<=', '>=') and self.operand_before(i) and caller != 'for' and \
                    not re.fullmatch('[A-Z_]+', self.word(i + 1)):  # by which an index is classified
                yield start, end, OPERATOR[word][0], 'comparison loosened'
            elif word == '&&' or word == '||' and caller in CONTROL or \
                    word in ('+', '-') and self.operand_before(i) and not re.match('[a-z_]', caller):
                yield from self.drops(i)
            elif word == '!' and self.kind(i + 1) == 'name':
                yield start, end, 'false && !', 'condition left out'
            elif word in ('return', '='):
                last = self.operand(i, 1, 0)
                if set('&<>') & {self.word(k)[0] for k in range(i + 1, last + 1) if self.operand_before(k)}:
                    yield self.replace(i + 1, last, f'({self.source(i + 1, last)}) || true', 'always true')
            elif word == 'for':
                yield from self.shorter(i, after)
            elif word == 'if' and self.word(after) == 'return':
                yield self.replace(i, next(k for k in range(after, len(self.marks)) if self.word(k) == ';'), ';', 'early return')

    def shorter(self, i, after):
        """A loop that takes a turn less."""
        first, second = [k for k in range(i, after) if self.word(k) == ';']
        for compared in [k for k in range(first, second) if self.word(k) in ('<=', '>=', '>', '<')][:1]:
            last, sign = self.operand(compared, 1, PRECEDENCE['&&']), self.word(compared)
            end = self.source(compared + 1, last) + {'<': ' - 1', '>': ' + 1'}.get(sign, '')
            yield self.replace(compared, last, f'{sign[0]} {end}', 'loop a turn short')


# ---- YAML ----

PROSE = ('title', 'note', 'text', 'meaning', 'reason', 'why', 'claim', 'where')
WORD = re.compile(r'[A-Za-z_][\w.]*(?:-[A-Za-z_]\w*)*|\d+(?:\.\d+)?(?:[eE][+-]?\d+)?[a-z]?(?![\w.])|<=|>=|[-+*/^<>=@]')
YAML_OPERATOR = {'+': '-', '-': '+', '*': '/', '/': '*', '^': '*', '<': '>', '>': '<', '<=': '<', '>=': '>', '=': '-', '@': ''}


def yaml_texts(node, keys=True):
    """Where the keys stand, and the texts that are no prose."""
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if keys:
                yield from yaml_texts(key)
            if key.value not in PROSE:
                yield from yaml_texts(value, key.value != 'lines')  # whose keys say how it is reckoned
    elif isinstance(node, yaml.SequenceNode):
        for value in node.value:
            yield from yaml_texts(value)
    else:
        yield node.start_mark.index + (node.style in ('>', '|')), node.end_mark.index


def yaml_number(word):
    mantissa, rest = re.fullmatch(r'([\d.]+)(.*)', word).groups()
    last = str((int(mantissa[-1]) + 1) % 10) if mantissa[-1] != '9' or '.' in mantissa else '8'
    return mantissa[:-1] + last + rest


def yaml_other(word, names):
    """Another name: a sibling, or the next one of the section, so that the mutant may make sense."""
    section, dot, name = word.rpartition('.')
    if name in YAML_SIBLING:
        return section + dot + YAML_SIBLING[name]
    return names[(names.index(word) + 1) % len(names)] if word in names and len(names) > 1 else word + 'x'


def yaml_names(text, at):
    """The names of the section around: its inputs, then what it defines."""
    heading = re.compile(r'^  ?[\w" ]+:', re.M)
    start = max((m.start() for m in heading.finditer(text, 0, at)), default=0)
    following = heading.search(text, at)
    body = text[start:following.start() if following else len(text)]
    lists = ' '.join(re.findall(r'(?:inputs|free|angles|positive): \[(.*?)\]', body, re.S))
    return list(dict.fromkeys(re.findall(r'\w+', lists) + re.findall(r'^      (\w+): ', body, re.M)))


def yaml_mutants(text):
    for start, end in yaml_texts(yaml.compose(text, yaml.CSafeLoader)):
        names = yaml_names(text, start)
        for m in WORD.finditer(text, start, end):
            word, a, b = m.group(), m.start(), m.end()
            if word[0].isdigit():
                yield a, b, yaml_number(word), 'number'
            elif word in YAML_OPERATOR:
                unary = word in '+-' and text[start:a].strip()[-1:] in ('', *'(=:{[,"^*/')
                yield a, b, '' if unary else YAML_OPERATOR[word], 'operator'
            else:
                yield a, b, yaml_other(word, names), 'name'


def step_mutants(text):
    """A step that shows less than it says: an equality left out or made a tautology, an entry of from or to left out."""
    for m in re.finditer(r'^      - ([^\n"]+?) = ([^\n"]+)\n(?!        )', text, re.M):
        yield m.start(), m.end(), '', 'equality'
        for side in (1, 2):
            yield m.start(1), m.end(2), f'{m.group(side)} = {m.group(side)}', 'equality'
    for m in re.finditer(r'^    (?:from|to): \[(.*)\]$', text, re.M):
        entries = m.group(1).split(', ')
        yield from ((m.start(1), m.end(1), ', '.join(entries[:i] + entries[i + 1:]), 'relation') for i in range(len(entries)))


def mutants(path, text, kind=''):
    """In the order of the file, without repetition."""
    seen = set()
    found = yaml_mutants(text) if path.endswith('.yaml') else C(text).soundness() if kind else C(text).tokens()
    for start, end, by, what in sorted(itertools.chain(found, step_mutants(text) if path.endswith('derivations.yaml') else ())):
        if text[start:end] != by and (start, end, by) not in seen:
            seen.add((start, end, by))
            yield start, end, by, what
