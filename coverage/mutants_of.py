"""The one-point mutants of a source file: of C, and of the three sheets.

mutants(path, text, kind) yields (start, end, replacement): text[start:end] is to be replaced.

Of C: every operator, sign, constant, comparison, argument, term, index and statement inside braces, one at a time; a name is
exchanged for its neighbour in names.csv. Not mutated, for no program is wrong by it: comments, #include, members of structures,
sizes of arrays (an array may be longer), the order of arguments where it does not count. For soundness: what makes a bound too
narrow or a proof none, at every place where it can be done, but for the functions of spared.csv.
Of YAML: every word, number and operator outside comments and prose; of the steps also an equality left out or made a tautology,
an entry of from or to left out.
"""
import csv
import pathlib
import re


def rows(table):
    with pathlib.Path(__file__).with_name(table).open(newline='') as file:
        return list(csv.DictReader(file))


def exchanged(where):
    """For each name the one that follows it in names.csv, in the first row that has both."""
    chains = [row['names'].split() for row in rows('names.csv') if row['where'] == where]
    return dict(reversed([pair for names in chains for pair in zip(names, names[1:])]))


SIBLING, LOOSER = exchanged('C'), exchanged('bound')
YAML_SIBLING = exchanged('sheet') | SIBLING

# ---- C ----

# What is no code: texts, comments, of a #define its head, other directives. Then brackets that hold none, and what stands for them.
HIDDEN = re.compile(r'''"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|/\*.*?\*/|//[^\n]*|\\\n
    |(?<=^\#)define[ ]\w+(?:\([^)]*\))?|^\#(?!define)(?:[^\n]|\\\n)*''', re.X | re.S | re.M)
INNERMOST, OUTSIDE = re.compile(r'\([^][(){}]*\)|\[[^][(){}]*\]|\{[^][(){}]*\}'), str.maketrans('()[]{}', '⟨⟩⟦⟧⦃⦄')
NUMBER = r'(?<![\w.])(?:0[xX][0-9a-fA-F.]+(?:[pP][+-]?\d+)?[uUlL]*|(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlLfF]*)'
# In the project's style an operator between two operands has blanks on either side, another none behind it.
BETWEEN = r'(?<=\s)(?:&&|\|\||<<|>>|[<>=!]=|[-+*/%&|^<>])(?=\s)'
DECLARATION = r'(?!(?:return|goto)\b)[A-Za-z_]\w*\s[\s*]*[A-Za-z_⟨][^=;]*|struct\b[^=;]*|enum\s'
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

# Soundness: calls that add something, and calls whose first argument is a ball made anew.
ADDS = re.compile(r'\w*(?:add|max|union|error|absolute)\w*')
BALL = re.compile(r'arb_(?!get|is|init|clear|swap|const|mat|poly|zero|one|set_(?:d|[su]i|arf)$)\w+')
NUMERIC = re.compile(r'(?:arb|acb|arf|mag|fmpq|fmpz|mpfr)_(?!dot)\w+')
SPARED = re.compile('|'.join(f"{row['file']}.*:(?:{row['functions'].replace(' ', '|')})" for row in rows('spared.csv')))


def constants(word):
    whole = re.fullmatch(r'(\d+)([uUlL]*)', word)
    if whole:
        value, suffix = int(whole[1]), whole[2]
        return f'{value + 1}{suffix}', f'{value - 1}{suffix}' if value else '-1'
    return (f'(2 * {word})', f'({word} / 2)') if re.match('[0xX.]*[1-9a-fA-F]', word) else ('1.0',)


# What is found, and what stands there instead
TOKENS = [
    (NUMBER, constants),
    (rf"\b(?!\d)(?:{'|'.join(SIBLING)})\b", lambda word: [SIBLING[word]]),
    (r'\b(?:sqrt|exp|sin|cos|fabs|cabs)(?=⟨)', lambda word: ['']),
    (r'!(?!=)|(?<!-)(?<!\d[eEpP])-(?![-=>\s])', lambda word: ['']),
    (rf'{BETWEEN}|\+\+|--|[-+*/|&]=', lambda word: OPERATOR.get(word, [])),
]
SOUNDNESS = [
    (rf"\b(?:{'|'.join(LOOSER)})\b", lambda word: [LOOSER[word]]),
    (r'!(?=[A-Za-z_])', lambda word: ['false && !']),
    (r'\bif ⟨·*⟩\s*return\b[^;]*;', lambda word: [';']),
]
# Elsewhere than in the head of a loop, and not by which an index is classified; in a list of values; as an argument in a calculation.
COMPARISONS = [(r'(?<=\s)[<>]=?(?=\s)(?!\s+[A-Z_]+\b)', lambda word: OPERATOR[word][:1])]
LISTED = [(r'(?:(?<=[^=!<>]= )|(?<== [-{]))[1-9]\d*\b(?!\.)', lambda word: [f'(2 * {word})'])]
FACTORS = [(r'(?<![\w.+-])(?<![+-]\s)(?:\d|1[0-5])\b(?!\.)', constants)]  # what is larger are bits


class Bracket:
    """level[start:end], what stands between two brackets or in a macro, all that is deeper being filled; and who calls it."""

    def __init__(self, source, code, level, start, end):
        self.source, self.code, self.level, self.start, self.end, self.opening = source, code, level, start, end, level[start - 1]
        self.caller = re.search(r'(\w*)\s*$', level[max(0, start - 80):start - 1])[1] if self.opening == '(' else ''
        self.is_list = self.opening == '{' and ';' not in code[start:end]

    def found(self, pattern):
        return re.compile(pattern).finditer(self.level, self.start, self.end)

    def rewritten(self, rows):
        return ((*m.span(), other) for pattern, others in rows for m in self.found(pattern) for other in others(m[0]))

    def after(self, at, level=-1):
        """Where the operand ends that begins at `at`, of an operator of this level; or the expression."""
        end = next((m.start() for m in ENDS[level].finditer(self.level, at, self.end)), self.end)
        return len(self.level[:end].rstrip())

    def drops(self, words):
        """An operator left out with its right operand, or with its left one."""
        for m in self.found(BETWEEN):
            word = m[0]
            if word in words:
                yield m.start(), self.after(m.end(), LEVEL[word]), ''
            if word in words and word not in '/%':
                ends = ENDS[LEVEL[word] + 1].finditer(self.level, self.start, m.start())
                begin = max((end.end() for end in ends), default=self.start)
                yield m.end() - len(self.level[begin:m.end()].lstrip()), m.end(), '-' if word == '-' else ''

    def signs(self, begin):
        """An arithmetic expression that has no sign gets one."""
        for m in VALUE.finditer(self.level, begin, self.end):
            if (m[0][0] not in '{,' or self.is_list) and not COMPARED.search(self.code, m.end(), self.after(m.end())):
                yield m.end(), m.end(), '-'

    def exchanges(self):
        """Neighbours in a list exchanged; in a set that must all be within its bounds, each left out."""
        parts = [m.span() for m in self.found(r'[^\s,](?:[^,]*[^\s,])?')]
        if self.caller in ('POSITIVE', 'FINITE') and len(parts) > 1:
            yield parts[0][0], self.level.index(',', parts[0][1]) + 1, ''
            yield from ((self.level.rindex(',', 0, first), last, '') for first, last in parts[1:])
        for k, ((a, b), (c, d)) in enumerate(zip(parts, parts[1:])):
            one, other = self.source[a:b], self.source[c:d]
            orderless = ORDERLESS.fullmatch(self.caller) or k == 1 and COMMUTATIVE.fullmatch(self.caller)
            if one != other and one[0] != '.' and not orderless:
                yield a, d, f'{other}, {one}'

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
            yield from ((self.end, self.end, change) for change in (' + 1', ' - 1'))

    def soundness(self, live):
        """A bound exchanged or off by one, a proof or a refusal not asked for."""
        loop, asked = self.caller == 'for', self.caller in ('if', 'while', 'for', 'switch', 'return', 'sizeof')
        factors = FACTORS if NUMERIC.fullmatch(self.caller) else []
        yield from self.rewritten(SOUNDNESS + (not loop) * COMPARISONS + self.is_list * LISTED + factors)
        yield from self.drops(['&&', *asked * ['||'], *(not re.match('[a-z_]', self.caller)) * ['+', '-']])
        if loop and self.start in live:
            m = re.compile(r'[^;]*;[^;]*?\s([<>])=?\s').match(self.level, self.start, self.end)
            if m:
                yield m.end(), m.end(), '-1 + ' if m[1] == '<' else '1 + '
        for m in self.found(r'(?:\breturn|(?<=\s)=)\s+'):
            end = self.after(m.end())
            if BOUNDED.search(self.code, m.end(), end):
                yield m.end(), end, f'({self.source[m.end():end]}) || true'


def c_mutants(path, source, kind):
    """Of its brackets, from the innermost on; and of its simple statements."""
    level = code = HIDDEN.sub(lambda m: f'"{(len(m[0]) - 2) * "·"}"' if m[0][0] in '"\'' else len(m[0]) * ' ', source)
    brackets = []
    while spans := [m.span() for m in INNERMOST.finditer(level)]:
        brackets += [Bracket(source, code, level, start + 1, end - 1) for start, end in spans]
        level = INNERMOST.sub(lambda m: (m[0][0] + (len(m[0]) - 2) * '·' + m[0][-1]).translate(OUTSIDE), level)
    macros = [m.span() for m in re.finditer('(?<=^#).*', level, re.M)]
    brackets += [Bracket(source, code, level, *span) for span in macros]
    bodies = [m.span(2) for m in re.finditer(r'(\b(?:struct|union)\b(?: \w+)?)?\s(⦃·*⦄)', level) if not m[1]]
    live = {k for first, last in macros + bodies for k in range(first + 1, last)}  # where something may be changed
    for m in re.finditer(r'(\w+)⟨·*⟩\n(⦃·*⦄)', level) if kind == 'soundness' else ():
        live -= set(range(*m.span(2))) if SPARED.fullmatch(f'{path}:{m[1]}') else set()
    statements = [m for b in brackets if b.opening == '{' and not b.is_list and b.start in live for m in b.found(STATEMENT)]
    for m in statements if kind == 'tokens' else ():
        live -= set(range(*m.span('declared')))

    for b in brackets:
        yield from (found for found in getattr(b, kind)(live) if found[0] in live)
    for span, text in ((m.span('simple'), m['simple']) for m in statements if m['simple']):
        word = re.match(r'\w*', text)[0]
        if kind == 'tokens':
            yield *span, ';'
        elif ADDS.fullmatch(word):
            yield *span, ';'
        if kind == 'soundness' and BALL.fullmatch(word):
            call = next(b for b in brackets if b.start == span[0] + len(word) + 1)
            ball = source[call.start:next(call.found('[^,]*')).end()]
            yield *span, f'{{ {source[slice(*span)]} mag_zero(arb_radref({ball})); }}'


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
                yield *m.span(), whole + (str((int(last) + 1) % 10) if last != '9' or '.' in whole else '8') + rest
            elif word in YAML_OPERATOR:
                unary = word in '+-' and shown[shown.rfind('\n', 0, m.start()) + 1:m.start()].strip()[-1:] in ('', *'(=:{[,"^*/')
                yield *m.span(), '' if unary else YAML_OPERATOR[word]
            elif name in YAML_SIBLING:
                yield *m.span(), of + dot + YAML_SIBLING[name]
            else:  # the next one of the section, so that the mutant may make sense
                other = names[(names.index(word) + 1) % len(names)] if word in names and len(names) > 1 else word + 'x'
                yield *m.span(), other


def step_mutants(text):
    """A step that shows less than it says: an equality left out or made a tautology, an entry of from or to left out."""
    for m in re.finditer(r'^      - ([^\n"]+?) = ([^\n"]+)\n(?!        )', text, re.M):
        yield *m.span(), ''
        yield from ((m.start(1), m.end(2), f'{side} = {side}') for side in m.groups())
    for m in re.finditer(r'^    (?:from|to): \[(.*)\]$', text, re.M):
        entries = m[1].split(', ')
        yield from ((*m.span(1), ', '.join(entries[:i] + entries[i + 1:])) for i in range(len(entries)))


def mutants(path, text, kind):
    """In the order of the file, without repetition."""
    if path.endswith('.yaml'):
        found = [*yaml_mutants(text), *(step_mutants(text) if 'derivations' in path else ())]
    else:
        found = c_mutants(path, text, kind)
    return [(start, end, by) for start, end, by in sorted(set(found)) if text[start:end] != by]
