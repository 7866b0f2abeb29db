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


def siblings(families):
    """For each name one that is mistaken for it: the next of its family."""
    pairs = [(a, b) for names in map(str.split, families.split(';')) for a, b in zip(names, names[1:] + names[:1])]
    return dict(reversed(pairs))  # the first family of a name counts


SIBLING = siblings("""m1 m2; m1 m2 m3; x y z; u v w; psi theta; psi_dot theta_dot; psi_ddot theta_ddot; dL dL_dot; L L_dot;
L_ref L; Q_ref Q; x1 y1 z1; x2 y2 z2; x3 y3 z3; x1_dot y1_dot z1_dot; x2_dot y2_dot z2_dot; x3_dot y3_dot z3_dot;
x1_ddot y1_ddot z1_ddot; x2_ddot y2_ddot z2_ddot; x3_ddot y3_ddot z3_ddot; X Y Z; dQ dL; q1 q2 q3; C1 C2; re im; r1 r2; r v;
a0 a1 a2 a3 a4; i j; margin1 margin2; I_11 I_22 I_33; I_12 I_13 I_23; R_c1 R_c2 R_c3; L_G1 L_G2 L_G3; w_1 w_2 w_3;
w_dot_1 w_dot_2 w_dot_3; f_12 f_13 f_23; r_12 r_13 r_23; sin cos; true false; theta_dot_ psi_dot_; left right; at_zero m;
CT_OK CT_DOMAIN CT_CONVERGENCE CT_MEMORY; GSL_SUCCESS GSL_EDOM; Omega k_c; NAN 0; INFINITY 1; DBL_EPSILON DBL_MIN; floor ceil;
min max; MPFR_RNDN MPFR_RNDU; MPFR_RNDU MPFR_RNDD; MPFR_RNDD MPFR_RNDN; break continue""")
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
LEVELS = '* / %; + -; << >>; < > <= >=; == !=; &; ^; |; &&; ||'.split(';')
PRECEDENCE = {word: 10 - level for level, words in enumerate(LEVELS) for word in words.split()}
OPERATOR = {words.split()[0]: words.split()[1:] for words in """+ -; - +; * /; / *; % /; && ||; || &&; & |; | &; << >>; >> <<;
< <= >=; <= < >; > >= <=; >= > <; == !=; != ==; += -=; -= +=; *= /=; /= *=; ++ --; -- ++; |= &=; &= |=""".split(';')}
COMPARISONS, LOGICAL, DROPPED = {'<', '>', '<=', '>='}, {'&&', '||'}, {'+', '-', '*', '/', '%', '&&', '||'}
ENDS = {'=', '+=', '-=', '*=', '/=', '%=', '|=', '&=', '<<=', '>>=', ',', ';', '?', ':', 'return'}  # an expression
OPEN, CLOSE = {'(', '[', '{'}, {')', ']', '}'}
LEADING = {'if', 'for', 'while', 'switch', 'else', 'do', 'case', 'default'}
CONTROL = LEADING | {'return', 'sizeof', 'goto'}
TYPES = {'const', 'static', 'inline', 'struct', 'enum', 'union', 'double', 'int', 'char', 'bool', 'void', 'unsigned', 'long',
         'signed', 'float', 'size_t', 'complex', 'FILE', 'extern', 'typedef', 'uint64_t', 'ulong', 'slong'}
TRANSPARENT = {'sqrt', 'exp', 'sin', 'cos', 'fabs', 'cabs'}
ORDERLESS = re.compile('POSITIVE|FINITE|sum|dot|hypot|sizeof')
COMMUTATIVE = re.compile('(arb|acb|arf|mag|fmpq|fmpz|mpfr|nmod)(_poly|_mat)?_(add|f?max|min|(?<!mat_)mul(low)?)')  # (z, x, y, ...)

# Soundness: what a call is exchanged for, calls that add something, and calls whose first argument is a ball made anew.
LOOSER = dict(pair.split(':') for pair in """upper:lower lower:upper arb_get_mag:arb_get_mag_lower mag_set_d:mag_set_d_lower
mag_max:mag_min mag_mul:mag_mul_lower mag_div:mag_div_lower mag_add:mag_add_lower arb_max:arb_min
arb_get_abs_ubound_arf:arb_get_abs_lbound_arf arb_get_abs_lbound_arf:arb_get_abs_ubound_arf
arb_get_ubound_arf:arb_get_lbound_arf arb_get_lbound_arf:arb_get_ubound_arf arb_is_positive:arb_is_nonnegative
arb_is_negative:arb_is_nonpositive arb_lt:arb_le arb_gt:arb_ge arb_contains:arb_overlaps ARF_RND_UP:ARF_RND_DOWN
ARF_RND_CEIL:ARF_RND_FLOOR ARF_RND_FLOOR:ARF_RND_CEIL MPFR_RNDU:MPFR_RNDD MPFR_RNDD:MPFR_RNDU""".split())
ADDS = re.compile(r'\w*(?:add|max|union|error|absolute)\w*')
BALL = re.compile(r'arb_(?!get|is|init|clear|swap|const|mat|poly|zero|one|set_(?:d|[su]i|arf)$)\w+')
NUMERIC = re.compile(r'(?:arb|acb|arf|mag|fmpq|fmpz|mpfr)_(?!dot)\w+')
MOST_FACTOR = 16  # what is larger are bits
# Functions that decide how sharp a bound is, never whether it holds: directions of a set, lengths of steps, which set to split.
# And such as make room.
GUIDES = re.compile(r'project|orthonormalise|choose_basis|expansion_position|(?:set_)?step_length|is_steady|steepest|is_loose|'
                    r'width|is_wide|\w+_(?:init|clear)')
# Those that choose what is said about a failure, never whether it is one: outcomes, counts and exit status are settled before.
WORDS = re.compile(r"""verify/conform/(?:(?:hints|kinds|kinds_of_motion)\.c:\w+|conform\.c:(?:ease_of|keep_record)|
    diagnosis\.c:(?:failures|is_domain_alone|explains_all|try_\w+|gather|diagnose_kind|diagnose)|
    report\.c:(?:\w+_text|hint_of|summary_digits|first_wrong_digit|root_distance|match_roots|is_judged|digits_by_time|put_xml|
        write_failure))""", re.X)


class C:
    """The tokens of a text, their brackets, which of them may be mutated, and the simple statements as (first, last)."""

    def __init__(self, text):
        marks = [m for m in TOKEN.finditer(text) if m.lastgroup != 'blank']
        self.text, self.count, outside = text, len(marks), [''] * 3
        self.words, self.kinds = [m.group() for m in marks] + outside, [m.lastgroup for m in marks] + outside
        self.starts, self.ends = [m.start() for m in marks], [m.end() for m in marks]
        self.partner, self.around, self.live, stack, macro_end = {}, [], [], [-1], 0
        self.blocks, self.structures = set(), set()  # braces around statements, and around members
        for i, word in enumerate(self.words[:-3]):
            if word in CLOSE and len(stack) > 1:
                self.partner[i] = stack.pop()
                self.partner[self.partner[i]] = i
            braces = [k for k in stack[1:] if self.words[k] == '{']
            self.around.append(stack[-1])
            self.live.append(self.starts[i] < macro_end or braces != [] and braces[0] not in self.structures)
            if word in OPEN:
                stack.append(i)
                if {'struct', 'union'} & set(self.words[i - 2:i]):
                    self.structures.add(i)
            elif word == ';':
                self.blocks.update(set(braces) - self.structures)
            elif self.kinds[i] == 'define':
                macro_end = re.compile(r'(?<!\\)\n').search(text, self.ends[i]).start()
        self.simple = [statement for statement in self.statements() if not self.declares(*statement)]

    def statements(self):
        """Simple statements and declarations, as (first, last)."""
        label = False
        for i, word in enumerate(self.words[:-3]):
            before, opening = self.words[i - 1], self.partner.get(i - 1)
            begins = before in ('{', ';', 'else', 'do') or before == ':' and label or before == '}' and opening in self.blocks or \
                before == ')' and self.words[opening - 1] in LEADING
            label = word in ('case', 'default') or label and before != ':'
            if begins and self.around[i] in self.blocks and word not in LEADING | CLOSE | {'{', ';'}:
                yield i, next(k for k in range(i, self.count) if self.words[k] == ';' and self.around[k] == self.around[i])

    def declares(self, first, last):
        """Whether it is a declaration: what stands before its '=' is no expression."""
        word, following = self.words[first], first + 1 + (self.words[first + 1] == '*')
        if word in TYPES or self.kinds[first] == 'name' and word not in CONTROL and self.kinds[following] == 'name':
            for k in itertools.takewhile(lambda k: self.words[k] != '=', range(first, last)):
                self.live[k] = 'soundness'
            return True
        return False

    def is_list(self, i):
        """Whether the bracket i is a brace around a list of values."""
        return self.words[i] == '{' and i not in self.blocks | self.structures

    def source(self, first, last):
        return self.text[self.starts[first]:self.ends[last]]

    def replace(self, first, last, by, what):
        return self.starts[first], self.ends[last], by, what

    def operand_before(self, i):
        """Whether token i - 1 ends an operand, so that an operator at i is binary."""
        if self.kinds[i - 1] == 'name':
            return self.words[i - 1] not in CONTROL | TYPES and self.words[i - 2] not in ('struct', 'enum')
        if self.words[i - 1] == ')':  # the end of a cast: a type in parentheses
            return self.words[self.partner[i - 1] + 1] not in TYPES
        return self.kinds[i - 1] in ('number', 'text') or self.words[i - 1] == ']'

    def operand(self, i, step, least=0):
        """The last token of the operand behind operator i or (step -1) before it; what is in it binds more than `least`."""
        k = i + step
        while 0 <= k < self.count:
            word = self.words[k]
            if word in (OPEN if step > 0 else CLOSE):
                k = self.partner.get(k, k)
            elif word in OPEN | CLOSE | ENDS or PRECEDENCE.get(word, 99) < least + (step > 0) and self.operand_before(k):
                break
            k += step
        return k - step

    def parts(self, opening):
        """What stands between the commas of a bracket, as (first, last); nothing where it is no list."""
        inside = [k for k in range(opening + 1, self.partner[opening]) if self.around[k] == opening and self.words[k] in ',;']
        commas = [opening, *inside, self.partner[opening]]
        if ';' in [self.words[k] for k in inside]:
            return []
        return [(a + 1, b - 1) for a, b in zip(commas, commas[1:]) if a + 1 < commas[-1]]

    def tokens(self):
        for first, last in self.simple:
            yield self.replace(first, last, ';', 'statement')
        for i in (i for i in range(self.count) if self.live[i] is True):
            word, start, end = self.words[i], self.starts[i], self.ends[i]
            if self.kinds[i] == 'number':
                yield from self.constants(i)
            elif word in SIBLING:
                yield start, end, SIBLING[word], 'name'
            if word in TRANSPARENT and self.words[i + 1] == '(':
                yield start, end, '', 'name'
            if word in ('(', '{'):
                yield from self.exchanges(i)
            if word == '[' and self.operand_before(i) and self.partner[i] - i > 1 + (self.kinds[i + 1] == 'number'):
                closing = self.starts[self.partner[i]]
                yield from ((closing, closing, change, 'index') for change in (' + 1', ' - 1'))
            if word == '!' or word == '-' and not self.operand_before(i):
                yield start, end, '', 'sign'
            elif word in OPERATOR and (word not in PRECEDENCE or self.operand_before(i)):
                yield from ((start, end, other, 'operator') for other in OPERATOR[word])
                yield from self.drops(i)
            if word in ('return', '=', '?', ':') or word in '{,' and self.is_list(i if word == '{' else self.around[i]):
                yield from self.signs(i + 1)

    def signs(self, i):
        """An arithmetic expression that has no sign gets one."""
        words = {self.words[k] for k in range(i, self.operand(i - 1, 1) + 1)}
        if self.kinds[i] in ('name', 'number') and self.words[i] not in ('0', 'NAN', 'true', 'false') and \
                words and not words & (COMPARISONS | LOGICAL | {'==', '!=', '?'}):
            yield self.starts[i], self.starts[i], '-', 'sign'

    def constants(self, i):
        word, whole = self.words[i], re.fullmatch(r'(\d+)([uUlL]*)', self.words[i])
        if whole:
            value, suffix = int(whole[1]), whole[2]
            others = f'{value + 1}{suffix}', f'{value - 1}{suffix}' if value else '-1'
        else:
            others = (f'(2 * {word})', f'({word} / 2)') if re.match('[0xX.]*[1-9a-fA-F]', word) else ('1.0',)
        yield from (self.replace(i, i, other, 'constant') for other in others)

    def exchanges(self, i):
        """Neighbours in a list exchanged; in a set that must all be within its bounds, each left out."""
        called, parts = self.words[i - 1], self.parts(i)
        if called in ('POSITIVE', 'FINITE') and len(parts) > 1:
            yield from (self.replace(first - (k > 0), last + (k == 0), '', 'argument') for k, (first, last) in enumerate(parts))
        for k, ((a, b), (c, d)) in enumerate(zip(parts, parts[1:])):
            one, other = self.source(a, b), self.source(c, d)
            orderless = ORDERLESS.fullmatch(called) or k == 1 and COMMUTATIVE.fullmatch(called)
            if one != other and self.words[a] != '.' and not orderless:
                yield self.replace(a, d, f'{other}, {one}', 'argument')

    def drops(self, i):
        """An operator left out with its right operand, or with its left one."""
        word = self.words[i]
        if word in DROPPED:
            what = 'condition left out' if word in LOGICAL else 'term left out'
            yield self.replace(i, self.operand(i, 1, PRECEDENCE[word]), '', what)
            if word not in '/%':
                yield self.replace(self.operand(i, -1, PRECEDENCE[word]), i, '-' if word == '-' else '', what)

    def soundness(self, path):
        """An error not added, a radius cleared, a bound exchanged or off by one, a proof or a refusal not asked for."""
        names = {i: self.words[self.partner[i - 1] - 1] for i in self.partner if self.words[i] == '{' and self.words[i - 1] == ')'}
        spared = {k for i, name in names.items() if GUIDES.fullmatch(name) or WORDS.fullmatch(f'{path}:{name}')
                  for k in range(i, self.partner[i])}
        for first, last in self.simple:
            if ADDS.fullmatch(self.words[first]) and first not in spared:
                yield self.replace(first, last, ';', 'error not added')
            if BALL.fullmatch(self.words[first]) and first not in spared:
                ball = self.source(*self.parts(first + 1)[0])
                yield self.replace(first, last, f'{{ {self.source(first, last)} mag_zero(arb_radref({ball})); }}', 'radius cleared')
        for i in (i for i in range(self.count) if self.live[i] and i not in spared):
            word, before, around = self.words[i], self.words[i - 1], self.around[i]
            caller = self.words[around - 1] if self.words[around] == '(' else ''
            if word in LOOSER:
                yield self.replace(i, i, LOOSER[word], 'bound exchanged')
            elif word.isdigit() and NUMERIC.fullmatch(caller) and int(word) < MOST_FACTOR and before not in ('+', '-'):
                yield from self.constants(i)
            elif word.isdigit() and self.is_list(around) and '=' in (before, self.words[i - 2]):
                yield self.replace(i, i, f'(2 * {word})', 'constant')
            elif word in COMPARISONS and self.operand_before(i) and caller != 'for' and \
                    not re.fullmatch('[A-Z_]+', self.words[i + 1]):  # by which an index is classified
                yield self.replace(i, i, OPERATOR[word][0], 'comparison loosened')
            elif word == '&&' or word == '||' and caller in CONTROL or \
                    word in ('+', '-') and self.operand_before(i) and not re.match('[a-z_]', caller):
                yield from self.drops(i)
            elif word == '!' and self.kinds[i + 1] == 'name':
                yield self.replace(i, i, 'false && !', 'condition left out')
            elif word in ('return', '='):
                last = self.operand(i, 1)
                if any(self.words[k][0] in '&<>' and self.operand_before(k) for k in range(i + 1, last + 1)):
                    yield self.replace(i + 1, last, f'({self.source(i + 1, last)}) || true', 'always true')
            elif word == 'for':
                yield from self.shorter(i + 1)
            elif word == 'if' and self.words[self.partner[i + 1] + 1] == 'return':
                yield self.replace(i, self.words.index(';', i), ';', 'early return')

    def shorter(self, opening):
        """A loop that takes a turn less."""
        first = self.words.index(';', opening)
        for i in [k for k in range(first, self.words.index(';', first + 1)) if self.words[k] in COMPARISONS][:1]:
            last, sign = self.operand(i, 1, PRECEDENCE['&&']), self.words[i]
            end = self.source(i + 1, last) + {'<': ' - 1', '>': ' + 1'}.get(sign, '')
            yield self.replace(i, last, f'{sign[0]} {end}', 'loop a turn short')


# ---- YAML ----

PROSE = ('title', 'note', 'text', 'meaning', 'reason', 'why', 'claim', 'where')
WORD = re.compile(r'[A-Za-z_][\w.]*(?:-[A-Za-z_]\w*)*|\d+(?:\.\d+)?(?:[eE][+-]?\d+)?[a-z]?(?![\w.])|<=|>=|[-+*/^<>=@]')
YAML_OPERATOR = {'+': '-', '-': '+', '*': '/', '/': '*', '^': '*', '<': '>', '>': '<', '<=': '<', '>=': '>', '=': '-', '@': ''}


def yaml_texts(node, keys=True):
    """Where the keys stand, and the texts that are no prose."""
    if isinstance(node, yaml.ScalarNode):
        yield node.start_mark.index + (node.style in ('>', '|')), node.end_mark.index
    elif isinstance(node, yaml.SequenceNode):
        for value in node.value:
            yield from yaml_texts(value)
    else:
        for key, value in node.value:
            yield from yaml_texts(key) if keys else ()
            yield from yaml_texts(value, key.value != 'lines') if key.value not in PROSE else ()  # whose keys say how it is reckoned


def yaml_mutants(text):
    headings = [m.span() for m in re.finditer(r'^  ?[\w" ]+:', text, re.M)]
    for start, end in yaml_texts(yaml.compose(text, yaml.CSafeLoader)):
        begin = max((first for first, last in headings if last <= start), default=0)
        section = text[begin:min((first for first, _ in headings if first >= start), default=len(text))]
        lists = ' '.join(re.findall(r'(?:inputs|free|angles|positive): \[(.*?)\]', section, re.S))
        names = list(dict.fromkeys(re.findall(r'\w+', lists) + re.findall(r'^      (\w+): ', section, re.M)))
        for m in WORD.finditer(text, start, end):
            word, (of, dot, name) = m[0], m[0].rpartition('.')
            if word[0].isdigit():  # another last digit
                whole, last, rest = re.fullmatch(r'([\d.]*)(\d)(\D.*)?', word).groups('')
                yield *m.span(), whole + (str((int(last) + 1) % 10) if last != '9' or '.' in whole else '8') + rest, 'number'
            elif word in YAML_OPERATOR:
                unary = word in '+-' and text[start:m.start()].strip()[-1:] in ('', *'(=:{[,"^*/')
                yield *m.span(), '' if unary else YAML_OPERATOR[word], 'operator'
            elif name in YAML_SIBLING:
                yield *m.span(), of + dot + YAML_SIBLING[name], 'name'
            else:  # the next one of the section, so that the mutant may make sense
                other = names[(names.index(word) + 1) % len(names)] if word in names and len(names) > 1 else word + 'x'
                yield *m.span(), other, 'name'


def step_mutants(text):
    """A step that shows less than it says: an equality left out or made a tautology, an entry of from or to left out."""
    for m in re.finditer(r'^      - ([^\n"]+?) = ([^\n"]+)\n(?!        )', text, re.M):
        yield *m.span(), '', 'equality'
        yield from ((m.start(1), m.end(2), f'{side} = {side}', 'equality') for side in m.groups())
    for m in re.finditer(r'^    (?:from|to): \[(.*)\]$', text, re.M):
        entries = m[1].split(', ')
        yield from ((*m.span(1), ', '.join(entries[:i] + entries[i + 1:]), 'relation') for i in range(len(entries)))


def mutants(path, text, kind):
    """In the order of the file, without repetition."""
    if path.endswith('.yaml'):
        found = [*yaml_mutants(text), *(step_mutants(text) if 'derivations' in path else ())]
    else:
        found = C(text).soundness(path) if kind == 'soundness' else C(text).tokens()
    once = {mutant[:3]: mutant for mutant in sorted(found, reverse=True)}
    return [mutant for mutant in reversed(once.values()) if text[mutant[0]:mutant[1]] != mutant[2]]
