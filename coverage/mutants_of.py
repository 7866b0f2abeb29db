"""The one-point mutants of a source file: of C, and of the three sheets.

mutants(path, text, kind) yields (start, end, replacement, what): text[start:end] is to be replaced; `what` names it in the table.

Of C: every operator, sign, constant, comparison, argument, term, index and statement inside braces, one at a time; a
name that has a sibling (m1 and m2, x, y and z) is exchanged for it. Not mutated, for no program is wrong by it: comments,
#include, members of structures, sizes of arrays (an array may be longer), the order of arguments where it does not count.
Of C, soundness alone: what makes a bound too narrow or a proof none, at every place where it can be done, but for the functions
of spared.csv.
Of YAML: every word, number and operator outside comments and prose, one at a time; of the steps also an equality left out or made
a tautology, an entry of from or to left out.
"""
import csv
import pathlib
import re


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

# What is no code: texts, comments, of a #define its head, other directives. Then brackets that hold none, and what stands for them.
HIDDEN = re.compile(r'''"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|/\*.*?\*/|//[^\n]*|\\\n
    |(?<=^\#)define[ ]\w+(?:\([^)]*\))?|^\#(?!define)(?:[^\n]|\\\n)*''', re.X | re.S | re.M)
INNERMOST, OUTSIDE = re.compile(r'\([^][(){}]*\)|\[[^][(){}]*\]|\{[^][(){}]*\}'), str.maketrans('()[]{}', '⟨⟩⟦⟧⦃⦄')
NUMBER = r'(?<![\w.])(?:0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?[uUlL]*|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfF]*)'
# In the project's style an operator between two operands has blanks on either side, another none behind it.
BETWEEN = r'(?<=\s)(?:&&|\|\||<<|>>|[<>=!]=|[-+*/%&|^<>])(?=\s)'
DECLARATION = r'''(?:const|static|inline|struct|enum|union|double|int|char|bool|void|unsigned|long|signed|float|size_t|complex|FILE
    |extern|typedef|uint64_t|ulong|slong)\b[^=;]*|(?!(?:return|goto)\b)[A-Za-z_]\w*\s+\*?\s*[A-Za-z_][^=;]*'''
STATEMENT = re.compile(rf'''(?:\b(?:else|do)\b|\bdefault:|\bcase\b[^:]*:|\b(?:if|for|while|switch)[ ]⟨·*⟩|⦃·*⦄|\s)*+
    (?:(?P<declared>{DECLARATION})[^;]*;|(?P<simple>[^;]+;)|;)''', re.X)
LEVELS = [words.split() for words in '* / %; + -; << >>; < > <= >=; == !=; &; ^; |; &&; ||'.split(';')]
LEVEL = {word: level for level, words in enumerate(LEVELS) for word in words}
# Where an operand ends: at what is in no expression, or at an operator of this level, or one that binds less.
ENDS = [re.compile(rf'[,;?:]|\breturn\b|(?<=\s)(?:{"|".join(["(?:<<|>>|[-+*/%&|])?=", *map(re.escape, sum(LEVELS[level:], []))])})(?=\s)')
        for level in range(len(LEVELS) + 1)]
OPERATOR = {words.split()[0]: words.split()[1:] for words in """+ -; - +; * /; / *; % /; && ||; || &&; & |; | &; << >>; >> <<;
< <= >=; <= < >; > >= <=; >= > <; == !=; != ==; += -=; -= +=; *= /=; /= *=; ++ --; -- ++; |= &=; &= |=""".split(';')}
# What may have a sign; what is no arithmetic, and what may be made true.
VALUE = re.compile(r'(?:\breturn\b|(?<=\s)=(?=\s)|[?:{,])\s*(?!(?:0|NAN|true|false|return)\b(?!\.))(?=\w|\.\d)')
COMPARED, BOUNDED = re.compile(r'\s(?:[<>]=?|[=!]=|&&|\|\||\?)\s'), re.compile(r'\s(?:[<>]=?|&&?|<<|>>)\s')
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
with pathlib.Path(__file__).with_name('spared.csv').open(newline='') as spared:
    SPARED = [(row['file'], re.compile('|'.join(row['functions'].split()))) for row in csv.DictReader(spared)]


def constants(word):
    whole = re.fullmatch(r'(\d+)([uUlL]*)', word)
    if whole:
        value, suffix = int(whole[1]), whole[2]
        return f'{value + 1}{suffix}', f'{value - 1}{suffix}' if value else '-1'
    return (f'(2 * {word})', f'({word} / 2)') if re.match('[0xX.]*[1-9a-fA-F]', word) else ('1.0',)


# What is found, what stands there instead, and what that is called.
TOKENS = [
    (NUMBER, constants, 'constant'),
    (rf"\b(?!\d)(?:{'|'.join(SIBLING)})\b", lambda word: [SIBLING[word]], 'name'),
    (r'\b(?:sqrt|exp|sin|cos|fabs|cabs)(?=⟨)', lambda word: [''], 'name'),
    (r'!(?!=)|(?<!-)(?<!\d[eEpP])-(?![-=>\s])', lambda word: [''], 'sign'),
    (rf'{BETWEEN}|\+\+|--|[-+*/|&]=', lambda word: OPERATOR.get(word, []), 'operator'),
]
SOUNDNESS = [
    (rf"\b(?:{'|'.join(LOOSER)})\b", lambda word: [LOOSER[word]], 'bound exchanged'),
    (r'!(?=[A-Za-z_])', lambda word: ['false && !'], 'condition left out'),
    (r'\bif ⟨·*⟩\s*return\b[^;]*;', lambda word: [';'], 'early return'),
]
COMPARISON = re.compile(r'(?<=\s)[<>]=?(?=\s)')
# Elsewhere than in the head of a loop, and not by which an index is classified; in a list of values; as an argument in a calculation.
COMPARISONS = [(r'(?<=\s)[<>]=?(?=\s)(?!\s+[A-Z_]+\b)', lambda word: OPERATOR[word][:1], 'comparison loosened')]
LISTED = [(r'(?:(?<=[^=!<>]= )|(?<== [-{]))[1-9]\d*\b(?!\.)', lambda word: [f'(2 * {word})'], 'constant')]
FACTORS = [(r'(?<![\w.+-])(?<![+-]\s)(?:\d|1[0-5])\b(?!\.)', constants, 'constant')]  # what is larger are bits


class Bracket:
    """level[start:end], what stands between two brackets or in a macro, all that is deeper being filled; and who calls it."""

    def __init__(self, source, code, level, start, end):
        self.source, self.code, self.level, self.start, self.end, self.opening = source, code, level, start, end, level[start - 1]
        self.caller = re.search(r'(\w*)\s*$', level[max(0, start - 80):start - 1])[1] if self.opening == '(' else ''
        self.is_list = self.opening == '{' and ';' not in code[start:end]

    def found(self, pattern):
        return re.compile(pattern).finditer(self.level, self.start, self.end)

    def rewritten(self, rows):
        return ((*m.span(), other, what) for pattern, others, what in rows for m in self.found(pattern) for other in others(m[0]))

    def after(self, at, level=-1):
        """Where the operand ends that begins at `at`, of an operator of this level; or the expression."""
        end = next((m.start() for m in ENDS[level].finditer(self.level, at, self.end)), self.end)
        return len(self.level[:end].rstrip())

    def drops(self, words):
        """An operator left out with its right operand, or with its left one."""
        for m in self.found(BETWEEN):
            word, what = m[0], 'condition left out' if m[0] in ('&&', '||') else 'term left out'
            if word in words:
                yield m.start(), self.after(m.end(), LEVEL[word]), '', what
            if word in words and word not in '/%':
                ends = ENDS[LEVEL[word] + 1].finditer(self.level, self.start, m.start())
                begin = max((end.end() for end in ends), default=self.start)
                yield m.end() - len(self.level[begin:m.end()].lstrip()), m.end(), '-' if word == '-' else '', what

    def signs(self, begin):
        """An arithmetic expression that has no sign gets one."""
        for m in VALUE.finditer(self.level, begin, self.end):
            if (m[0][0] not in '{,' or self.is_list) and not COMPARED.search(self.code, m.end(), self.after(m.end())):
                yield m.end(), m.end(), '-', 'sign'

    def exchanges(self):
        """Neighbours in a list exchanged; in a set that must all be within its bounds, each left out."""
        parts = [m.span() for m in self.found(r'[^\s,](?:[^,]*[^\s,])?')]
        if self.caller in ('POSITIVE', 'FINITE') and len(parts) > 1:
            yield parts[0][0], self.level.index(',', parts[0][1]) + 1, '', 'argument'
            yield from ((self.level.rindex(',', 0, first), last, '', 'argument') for first, last in parts[1:])
        for k, ((a, b), (c, d)) in enumerate(zip(parts, parts[1:])):
            one, other = self.source[a:b], self.source[c:d]
            orderless = ORDERLESS.fullmatch(self.caller) or k == 1 and COMMUTATIVE.fullmatch(self.caller)
            if one != other and one[0] != '.' and not orderless:
                yield a, d, f'{other}, {one}', 'argument'

    def tokens(self, live):
        """Each token that may be changed, one at a time; what is added before or after a value; what is left out."""
        inside = self.start - 1 in live
        yield from self.rewritten(TOKENS)
        yield from self.drops(['+', '-', '*', '/', '%', '&&', '||'])
        yield from self.signs(self.start - 1 if inside and self.is_list else self.start)
        inner = self.level[self.start:self.end]
        if inside and self.opening in '({' and ';' not in inner:
            yield from self.exchanges()
        if self.opening == '[' and self.level[self.start - 2] not in ' \n({' and not re.fullmatch(r'\d*', inner):
            yield from ((self.end, self.end, change, 'index') for change in (' + 1', ' - 1'))

    def soundness(self, live):
        """A bound exchanged or off by one, a proof or a refusal not asked for."""
        loop, asked = self.caller == 'for', self.caller in ('if', 'while', 'for', 'switch', 'return', 'sizeof')
        factors = FACTORS if NUMERIC.fullmatch(self.caller) else []
        yield from self.rewritten(SOUNDNESS + (not loop) * COMPARISONS + self.is_list * LISTED + factors)
        yield from self.drops(['&&', *asked * ['||'], *(not re.match('[a-z_]', self.caller)) * ['+', '-']])
        if loop and self.start in live:
            first = self.level.index(';', self.start)
            for m in [*COMPARISON.finditer(self.level, first, self.level.index(';', first + 1))][:1]:
                end = self.after(m.end(), LEVEL['&&'])
                less = {'<': ' - 1', '>': ' + 1'}.get(m[0], '')
                yield m.start(), end, f'{m[0][0]}{self.source[m.end():end]}{less}', 'loop a turn short'
        for m in self.found(r'(?:\breturn|(?<=\s)=)\s+'):
            end = self.after(m.end())
            if BOUNDED.search(self.code, m.end(), end):
                yield m.end(), end, f'({self.source[m.end():end]}) || true', 'always true'


def c_mutants(path, source, kind):
    """Of its brackets, from the innermost on; and of its simple statements."""
    level = code = HIDDEN.sub(lambda m: f'"{(len(m[0]) - 2) * "·"}"' if m[0][0] in '"\'' else len(m[0]) * ' ', source)
    brackets = []
    while spans := [m.span() for m in INNERMOST.finditer(level)]:
        brackets += [Bracket(source, code, level, start + 1, end - 1) for start, end in spans]
        level = INNERMOST.sub(lambda m: (m[0][0] + (len(m[0]) - 2) * '·' + m[0][-1]).translate(OUTSIDE), level)
    macros = [m.span() for m in re.finditer('(?<=^#).*', level, re.M)]
    brackets += [Bracket(source, code, level, *span) for span in macros]
    structure = re.compile(r'\b(?:struct|union)(?: \w+)?\s$')
    bodies = [m.span() for m in re.finditer('⦃·*⦄', level) if not structure.search(level[:m.start()])]
    live = {k for first, last in macros + bodies for k in range(first + 1, last)}  # where something may be changed
    for m in re.finditer(r'(\w+)⟨·*⟩\n(⦃·*⦄)', level) if kind == 'soundness' else ():
        if any(path.startswith(file) and functions.fullmatch(m[1]) for file, functions in SPARED):
            live -= set(range(*m.span(2)))
    statements = [m for b in brackets if b.opening == '{' and not b.is_list and b.start in live for m in b.found(STATEMENT)]
    for m in statements if kind == 'tokens' else ():
        if m['declared']:
            declarator = re.compile('[^=]*').match(code, m.start('declared'), m.end() - 1)
            live -= set(range(*declarator.span()))

    for b in brackets:
        yield from (found for found in getattr(b, kind)(live) if found[0] in live)
    for span, text in ((m.span('simple'), m['simple']) for m in statements if m['simple']):
        word = re.match(r'\w*', text)[0]
        if kind == 'tokens':
            yield *span, ';', 'statement'
        elif ADDS.fullmatch(word):
            yield *span, ';', 'error not added'
        if kind == 'soundness' and BALL.fullmatch(word):
            call = next(b for b in brackets if b.start == span[0] + len(word) + 1)
            ball = source[call.start:next(call.found('[^,]*')).end()]
            yield *span, f'{{ {source[slice(*span)]} mag_zero(arb_radref({ball})); }}', 'radius cleared'


# ---- YAML ----

# What is no formula: comments, the marks of lists and texts; prose, in a block and in a line; in lines, how one comes to them.
PROSE = '(?:title|note|text|meaning|reason|why|claim|where)'
HIDDEN_YAML = re.compile(rf"""(?<!\S)\#.*|^[ ]*(?:-[ ])+|[>|]$|(?P<block>^(?P<indent>[ ]*){PROSE}:).*(?:\n(?P=indent)[ ]+\S.*)*
    |(?P<flow>(?<=[{{ ]){PROSE}:[ ])(?:"(?:[^"\\]|\\.)*"|\[[^]]*\]|[^,}}\n]*)""", re.X | re.M)
LINES = re.compile(r'^    lines:\n(?:      .*\n)+', re.M)
WORD = re.compile(r'[A-Za-z_][\w.]*(?:-[A-Za-z_]\w*)*|\d+(?:\.\d+)?(?:[eE][+-]?\d+)?[a-z]?(?![\w.])|<=|>=|[-+*/^<>=@]')
YAML_OPERATOR = {'+': '-', '-': '+', '*': '/', '/': '*', '^': '*', '<': '>', '>': '<', '<=': '<', '>=': '>', '=': '-', '@': ''}


def yaml_mutants(text):
    headings = [0, *(m.start() for m in re.finditer(r'^  ?[\w" ]+:', text, re.M))]
    shown = HIDDEN_YAML.sub(lambda m: (m['block'] or m['flow'] or '').ljust(len(m[0])), text)
    shown = LINES.sub(lambda m: re.sub(r'^      (?:"[^"\n]*"|[^:\n]*)', lambda key: ' ' * len(key[0]), m[0], flags=re.M), shown)
    for before, begin, end in zip([0, *headings], headings, [*headings[1:], len(text)]):
        for m in WORD.finditer(shown, begin, end):
            section = text[before if m.end() <= text.index(':', begin) else begin:end]
            lists = ' '.join(re.findall(r'(?:inputs|free|angles|positive): \[(.*?)\]', section, re.S))
            names = list(dict.fromkeys(re.findall(r'\w+', lists) + re.findall(r'^      (\w+): ', section, re.M)))
            word, (of, dot, name) = m[0], m[0].rpartition('.')
            if word[0].isdigit():  # another last digit
                whole, last, rest = re.fullmatch(r'([\d.]*)(\d)(\D.*)?', word).groups('')
                yield *m.span(), whole + (str((int(last) + 1) % 10) if last != '9' or '.' in whole else '8') + rest, 'number'
            elif word in YAML_OPERATOR:
                unary = word in '+-' and shown[shown.rfind('\n', 0, m.start()) + 1:m.start()].strip()[-1:] in ('', *'(=:{[,"^*/')
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
        found = c_mutants(path, text, kind)
    once = {mutant[:3]: mutant for mutant in sorted(found, reverse=True)}
    return [mutant for mutant in reversed(once.values()) if text[mutant[0]:mutant[1]] != mutant[2]]
