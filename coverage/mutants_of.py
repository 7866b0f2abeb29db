"""The one-point mutants of a source file: of C, and of the formula sheet and the derivation steps.

mutants(path, text, kind) yields (start, end, replacement): text[start:end] is to be replaced.

Of C: every operator, sign, constant, comparison, argument, term, index and statement inside braces, one at a time; a
name that has a sibling (m1 and m2, x, y and z) is exchanged for it. Not mutated, for no program is wrong by it: comments,
#include, members of structures, sizes of arrays (an array may be longer), the order of arguments where it does not count.

Of C, soundness alone: what makes a bound too narrow or a proof none, at every place where it can be done.

Of YAML: every word, number and operator outside comments and prose, one at a time; of the steps also an equality left out or made
a tautology, an entry of from or to left out.
"""
import itertools
import re

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

# What stands in the two sheets beside formulas.
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
# These decide how sharp a bound is, never whether it holds: directions of a set, lengths of steps. And room is made here.
GUIDES = re.compile(r'project|orthonormalise|choose_basis|position_size|step_length|steady|\w+_(?:init|clear)')
MOST_FACTOR = 16  # what is larger are bits
NUMERIC = re.compile(r'(?:arb|acb|arf|mag|fmpq|fmpz|mpfr)_(?!dot)\w+')
TRANSPARENT = {'sqrt', 'exp', 'sin', 'cos', 'fabs', 'cabs'}


class C:
    def __init__(self, text):
        self.text = text
        self.tokens = [(m.lastgroup, m.group(), m.start(), m.end()) for m in TOKEN.finditer(text) if m.lastgroup != 'blank']
        self.partner, stack = {}, []
        for i, (_, word, _, _) in enumerate(self.tokens):
            if word in OPEN:
                stack.append(i)
            elif word in CLOSE and stack:
                self.partner[i], self.partner[stack[-1]] = stack[-1], i
                stack.pop()

    def word(self, i):
        return self.tokens[i][1] if 0 <= i < len(self.tokens) else ''

    def kind(self, i):
        return self.tokens[i][0] if 0 <= i < len(self.tokens) else ''

    def source(self, first, last):
        return self.text[self.tokens[first][2]:self.tokens[last][3]]

    def replace(self, first, last, by):
        return self.tokens[first][2], self.tokens[last][3], by

    def operand_before(self, i):
        """Whether token i - 1 ends an operand, so that an operator at i is binary."""
        if self.kind(i - 1) == 'name':
            return self.word(i - 1) not in CONTROL | TYPES and self.word(i - 2) not in ('struct', 'enum')
        if self.word(i - 1) == ')':  # the end of a cast: a type in parentheses
            return self.word(self.partner[i - 1] + 1) not in TYPES or self.word(self.partner[i - 1] - 1) == 'sizeof'
        return self.kind(i - 1) in ('number', 'text') or self.word(i - 1) == ']'

    def right(self, i, least):
        """The last token of the operand that begins behind the operator i, of operators above `least`."""
        k = i + 1
        while k < len(self.tokens):
            word = self.word(k)
            if word in OPEN:
                k = self.partner.get(k, k)
            elif word in CLOSE or word in (',', ';', '?', ':') or word in ASSIGNMENT:
                break
            elif PRECEDENCE.get(word, 99) <= least and self.operand_before(k):
                break
            k += 1
        return k - 1

    def left(self, i, least):
        k = i - 1
        while k >= 0:
            word = self.word(k)
            if word in (')', ']') or word == '}' and self.word(self.partner.get(k, k) - 1) == ')':
                k = self.partner.get(k, k)
            elif word in OPEN or word in CLOSE or word in (',', ';', '?', ':', 'return') or word in ASSIGNMENT:
                break
            elif PRECEDENCE.get(word, 99) < least and self.operand_before(k):
                break
            k -= 1
        return k + 1

    def parts(self, opening):
        """What stands between the commas of a bracket, as (first, last)."""
        parts, first, k = [], opening + 1, opening + 1
        end = self.partner[opening]
        while k < end:
            if self.word(k) in OPEN:
                k = self.partner[k]
            elif self.word(k) == ',':
                parts.append((first, k - 1))
                first = k + 1
            elif self.word(k) == ';':
                return []
            k += 1
        return parts + [(first, end - 1)] if first < end else parts

    def declares(self, first):
        words = [self.word(first + k) for k in range(3)]
        return words[0] in TYPES or self.kind(first) == 'name' and words[0] not in CONTROL and (
            self.kind(first + 1) == 'name' or words[1] == '*' and self.kind(first + 2) == 'name')

    def regions(self):
        """For each token whether it may be mutated: inside braces that hold no members, and in macros; and where blocks open."""
        live, block = [False] * len(self.tokens), set()
        for i, end in self.partner.items():
            if self.word(i) != '{':
                continue
            fields = {self.word(i - 1), self.word(i - 2) if self.kind(i - 1) == 'name' else ''} & {'struct', 'union'}
            if not fields and ';' in (self.word(k) for k in range(i, end)):
                block.add(i)
            for k in range(i + 1, end):
                live[k] = not fields
        for k in (k for k, token in enumerate(self.tokens) if token[0] == 'define'):
            end = re.compile(r'(?<!\\)\n').search(self.text, self.tokens[k][3]).start()
            for q in range(k + 1, len(self.tokens)):
                live[q] |= self.tokens[q][2] < end
        return live, block

    def statements(self, block):
        """The simple statements, as (first, last), and for each declaration the tokens before its '='."""
        simple, declarators = [], set()
        for opening in block:
            k, end = opening + 1, self.partner[opening]
            while k < end:
                first = k
                while self.word(first) in ('if', 'for', 'while', 'switch', 'else', 'do', 'case', 'default'):
                    if self.word(first) in ('case', 'default'):
                        while self.word(first) != ':':
                            first += 1
                    elif self.word(first + 1) == '(' and self.word(first) != 'else':
                        first = self.partner[first + 1]
                    first += 1
                if self.word(first) == '{' and first in block:
                    k = self.partner[first] + 1
                    continue
                last = first
                while last < end and self.word(last) != ';':
                    last = self.partner[last] + 1 if self.word(last) in OPEN else last + 1
                if self.declares(first):
                    q = first
                    while q < last and self.word(q) != '=':
                        declarators.add(q)
                        q += 1
                elif last > first:
                    simple.append((first, last))
                k = last + 1
        return simple, declarators

    def mutants(self):
        live, block = self.regions()
        simple, declarators = self.statements(block)
        for first, last in simple:
            yield self.replace(first, last, ';')
        for i, (kind, word, start, end) in enumerate(self.tokens):
            if not live[i] or i in declarators:
                continue
            if kind == 'number':
                yield from self.constants(i)
            elif kind == 'name':
                yield from self.names(i)
            elif word in '([{':
                yield from self.exchanges(i, block)
            if word == '[' and i in self.partner and not (self.kind(i + 1) == 'number' and self.partner[i] == i + 2) and \
                    self.partner[i] > i + 1 and self.operand_before(i):
                for change in (' + 1', ' - 1'):
                    yield self.tokens[self.partner[i]][2], self.tokens[self.partner[i]][2], change
            if word == '!' and self.word(i + 1) != '=':
                yield start, end, ''
            if word in PRECEDENCE and not self.operand_before(i):
                if word == '-':
                    yield start, end, ''
            elif word in OPERATOR:
                yield from ((start, end, other) for other in OPERATOR[word])
                yield from self.drops(i)
            if word in ('return', '=', '?', ':', ',', '{') and self.signs(i):
                yield self.tokens[i + 1][2], self.tokens[i + 1][2], '-'

    def signs(self, i):
        """Whether an arithmetic expression without a sign begins behind token i."""
        last = self.right(i, 0)
        words = {self.word(k) for k in range(i + 1, last + 1)}
        if last == i or self.word(i) in (',', '{') and not self.in_list(i):
            return False
        return self.word(i + 1) not in {'-', '!', '&', '(', '.', '*', '0', 'NAN', 'true', 'false', '~'} | TYPES and \
            self.kind(i + 1) in ('name', 'number') and not words & {'&&', '||', '<', '>', '<=', '>=', '==', '!=', '?'}

    def opening(self, i):
        """The bracket that token i stands in."""
        while i >= 0 and self.word(i) not in OPEN:
            i = self.partner.get(i, i) - 1
        return i

    def in_list(self, i):
        k = self.opening(i)
        return self.word(k) == '{' and not any(self.word(q) == ';' for q in range(k, self.partner.get(k, k)))

    def constants(self, i):
        _, word, start, end = self.tokens[i]
        if re.fullmatch(r'\d+[uUlL]*', word):
            value, suffix = re.fullmatch(r'(\d+)(.*)', word).groups()
            yield start, end, f'{int(value) + 1}{suffix}'
            yield start, end, f'{int(value) - 1}{suffix}' if int(value) else '-1'
        elif float(word.rstrip('fFlLuU') if 'x' not in word.lower() else float.fromhex(word.rstrip('uUlL'))) == 0:
            yield start, end, '1.0'
        else:
            yield start, end, f'(2 * {word})'
            yield start, end, f'({word} / 2)'

    def names(self, i):
        _, word, start, end = self.tokens[i]
        if word in SIBLING:
            yield start, end, SIBLING[word]
        if word in TRANSPARENT and self.word(i + 1) == '(':
            yield start, end, ''

    def exchanges(self, i, block):
        """Neighbours in a list exchanged; in a set that must all be within its bounds, each left out."""
        if i not in self.partner or i in block:
            return
        called = self.word(i - 1) if self.word(i) == '(' and self.kind(i - 1) == 'name' else ''
        if self.word(i) == '[' or self.word(i) == '(' and (not called or called in CONTROL):
            return
        parts = self.parts(i)
        if called in ('POSITIVE', 'FINITE'):
            for k, (first, last) in enumerate(parts):
                if len(parts) > 1:
                    first, last = (first - 1, last) if k else (first, last + 1)
                    yield self.replace(first, last, '')
        elif called not in ORDERLESS:
            for number, ((a, b), (c, d)) in enumerate(zip(parts, parts[1:])):
                if number == 1 and COMMUTATIVE.fullmatch(called):
                    continue
                if self.source(a, b) != self.source(c, d) and self.word(a) != '.':
                    yield self.replace(a, d, f'{self.source(c, d)}, {self.source(a, b)}')

    def drops(self, i):
        word = self.word(i)
        if word not in DROPPED:
            return
        first, last = self.left(i, PRECEDENCE[word]), self.right(i, PRECEDENCE[word])
        if first < i <= last - 1:
            yield self.replace(i, last, '')
            if DROPPED[word] == 'both':
                yield self.replace(first, i, '-' if word == '-' else '')


    def guides(self):
        """The tokens of functions that guide, and bound nothing."""
        return {k for i, end in self.partner.items() if self.word(i) == '{' and self.word(i - 1) == ')'
                and GUIDES.fullmatch(self.word(self.partner[i - 1] - 1)) for k in range(i, end)}

    def soundness(self):
        """An error not added, a radius cleared, a bound exchanged or off by one, a proof or a refusal not asked for."""
        (live, block), guides = self.regions(), self.guides()
        for first, last in self.statements(block)[0]:
            if ADDS.fullmatch(self.word(first)) and first not in guides:
                yield self.replace(first, last, ';')
            if BALL.fullmatch(self.word(first)) and first not in guides:
                ball = self.source(*self.parts(first + 1)[0])
                yield self.replace(first, last, f'{{ {self.source(first, last)} mag_zero(arb_radref({ball})); }}')
        for i, (kind, word, start, end) in enumerate(self.tokens):
            if not live[i] or i in guides:
                continue
            after, around = self.partner.get(i + 1, i) + 1, self.opening(i)
            caller = self.word(around - 1) if self.word(around) == '(' else ''
            if word in LOOSER:
                yield start, end, LOOSER[word]
            elif kind == 'number' and word.isdigit() and NUMERIC.fullmatch(caller) and int(word) < MOST_FACTOR and \
                    self.word(i - 1) not in ('+', '-'):
                yield from self.constants(i)
            elif kind == 'number' and word.isdigit() and self.in_list(i) and '=' in (self.word(i - 1), self.word(i - 2)):
                yield start, end, f'(2 * {word})'
            elif word in ('<', '>', '<=', '>=') and self.operand_before(i) and caller != 'for' and \
                    not re.fullmatch('[A-Z_]+', self.word(i + 1)):  # by which an index is classified
                yield start, end, OPERATOR[word][0]
            elif word == '&&' or word == '||' and caller in CONTROL or word in ('+', '-') and self.operand_before(i) and not re.match('[a-z_]', caller):
                yield from self.drops(i)
            elif word == '!' and self.kind(i + 1) == 'name':
                yield start, end, 'false && !'
            elif word in ('return', '=') and set('&<>') & {self.word(k)[0] for k in range(i + 1, self.right(i, 0) + 1)
                                                           if self.operand_before(k)}:
                yield self.replace(i + 1, self.right(i, 0), f'({self.source(i + 1, self.right(i, 0))}) || true')
            elif word == 'for':
                first, second = [k for k in range(i, after) if self.word(k) == ';']
                compared = next((k for k in range(first, second) if self.word(k) in ('<=', '>=', '>', '<')), 0)
                last = self.right(compared, PRECEDENCE['&&'])
                if compared:
                    strict = self.word(compared)[0] if '=' in self.word(compared) else self.word(compared)
                    shorter = {'<': f'{self.source(compared + 1, last)} - 1', '>': f'{self.source(compared + 1, last)} + 1'}
                    yield self.replace(compared, last, f'{strict} ' + (
                        self.source(compared + 1, last) if strict != self.word(compared) else shorter[strict]))
            elif word == 'if' and self.word(after) == 'return':
                yield self.replace(i, next(k for k in range(after, len(self.tokens)) if self.word(k) == ';'), ';')


# ---- YAML ----

PROSE = ('title', 'note', 'meaning', 'reason', 'why', 'claim', 'where')
WORD = re.compile(r'[A-Za-z_][\w.]*(?:-[A-Za-z_]\w*)*|\d+(?:\.\d+)?(?:[eE][+-]?\d+)?[a-z]?(?![\w.])|<=|>=|[-+*/^<>=@]')


def yaml_spans(text):
    """The stretches of the file that are neither comment nor prose."""
    at, prose_indent, lines_indent, principles = 0, None, None, False
    for line in text.splitlines(keepends=True):
        indent = len(line) - len(line.lstrip())
        if prose_indent is not None and line.strip() and indent <= prose_indent:
            prose_indent = None
        if lines_indent is not None and line.strip() and indent <= lines_indent:
            lines_indent = None
        if indent == 0 and line.strip() and not line.startswith('#'):
            principles = line.startswith('principles:')
        end = at + len(line.rstrip('\n'))
        comment = re.search(r'(?:^|\s)#.*', line)
        if comment and not line.strip().startswith('"'):
            end = min(end, at + comment.start())
        key = re.match(r'\s*(?:- )?(\w+): ', line)
        if prose_indent is None and end > at:
            if key and key.group(1) in PROSE or principles and key:
                yield at + key.start(1), at + key.end(1)
                prose_indent = indent
            elif lines_indent is not None:  # how: the algebra by hand
                yield at + re.match(r'\s*(?:"[^"]*"|[^"]*?): ', line).end(), end
            else:
                inline = re.search(r'[{,] (?:meaning|reason|note): |\{(?:meaning|reason): ', line)
                inline = re.search(r', meaning: ', line) or inline
                yield at, min(end, at + inline.end() if inline else end)
        if key is None and line.strip() == 'lines:':
            lines_indent = indent
        at += len(line)


def yaml_number(word):
    value, suffix = re.fullmatch(r'(.*?)([a-z]?)', word).groups()
    mantissa, _, exponent = re.sub('[eE]', 'e', value).partition('e')
    last = str((int(mantissa[-1]) + 1) % 10) if mantissa[-1] != '9' or '.' in mantissa else '8'
    return mantissa[:-1] + last + ('e' + exponent if exponent else '') + suffix


def yaml_other(word, names):
    """Another name: a sibling, or the next one of the section, so that the mutant may make sense."""
    section, dot, name = word.rpartition('.')
    if name in YAML_SIBLING:
        return section + dot + YAML_SIBLING[name]
    if word in names and len(names) > 1:
        return names[(names.index(word) + 1) % len(names)]
    return word + 'x'


YAML_OPERATOR = {'+': '-', '-': '+', '*': '/', '/': '*', '^': '*', '<': '>', '>': '<', '<=': '<', '>=': '>', '=': '-', '@': ''}


def yaml_names(text, at):
    """The names of the section around: its inputs, then what it defines."""
    start = max((m.start() for m in re.finditer(r'^  ?[\w" ]+:', text[:at], re.M)), default=0)
    following = re.compile(r'^  ?[\w" ]+:', re.M).search(text, at)
    body = text[start:following.start() if following else len(text)]
    lists = ' '.join(re.findall(r'(?:inputs|free|angles|positive): \[(.*?)\]', body, re.S))
    return list(dict.fromkeys(re.findall(r'\w+', lists) + re.findall(r'^      (\w+): ', body, re.M)))


def yaml_mutants(text):
    for start, end in yaml_spans(text):
        names = yaml_names(text, start)
        for m in WORD.finditer(text, start, end):
            word, a, b = m.group(), m.start(), m.end()
            before = text[start:a].strip()
            if word == '-' and not before and text[b] == ' ':
                continue  # the mark of a list's item
            if word[0].isdigit():
                yield a, b, yaml_number(word)
            elif word in YAML_OPERATOR:
                yield a, b, '' if word in '+-' and before[-1:] in '(=:{[,"^*/' else YAML_OPERATOR[word]
            else:
                yield a, b, yaml_other(word, names)


def step_mutants(text):
    """A step that shows less than it says: an equality left out or made a tautology, an entry of from or to left out."""
    for m in re.finditer(r'^      - ([^\n"]+?) = ([^\n"]+)\n(?!        )', text, re.M):
        yield m.start(), m.end(), ''
        yield m.start(1), m.end(2), f'{m.group(1)} = {m.group(1)}'
        yield m.start(1), m.end(2), f'{m.group(2)} = {m.group(2)}'
    for m in re.finditer(r'^    (?:from|to): \[(.*)\]$', text, re.M):
        entries = m.group(1).split(', ')
        yield from ((m.start(1), m.end(1), ', '.join(entries[:i] + entries[i + 1:])) for i in range(len(entries)))


def mutants(path, text, kind=''):
    """In the order of the file, without repetition."""
    seen = set()
    found = yaml_mutants(text) if path.endswith('.yaml') else C(text).soundness() if kind else C(text).mutants()
    for mutant in sorted(itertools.chain(found, step_mutants(text) if path.endswith('derivations.yaml') else ())):
        start, end, by = mutant
        if text[start:end] != by and mutant not in seen:
            seen.add(mutant)
            yield mutant
