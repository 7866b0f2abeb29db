#include "formula/expression.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "text/decimal.h"
#include "text/scope.h"

/* ---- programs ---- */

void program_init(struct program *p)
{
    *p = (struct program){0};
}

void program_clear(struct program *p)
{
    for (int i = 0; i < p->count; i++)
        fmpq_clear(&p->nodes[i].number);
    for (int i = 0; i < p->named; i++)
        free(p->names[i].text);
    free(p->nodes);
    free(p->names);
    program_init(p);
}

int program_append(struct program *p, enum operator op, int left, int right, slong exponent)
{
    p->nodes = xrealloc(p->nodes, (size_t)p->count + 1, sizeof *p->nodes);
    struct node *node = &p->nodes[p->count];
    *node = (struct node){.op = op, .left = left, .right = right, .exponent = exponent};
    fmpq_init(&node->number);
    return p->count++;
}

static int append_integer(struct program *p, slong value)
{
    int node = program_append(p, OPERATOR_NUMBER, -1, -1, 0);
    fmpq_set_si(&p->nodes[node].number, value, 1);
    return node;
}

void program_copy(struct program *to, const struct program *from)
{
    program_init(to);
    for (int i = 0; i < from->count; i++) {
        const struct node *node = &from->nodes[i];
        program_append(to, node->op, node->left, node->right, node->exponent);
        fmpq_set(&to->nodes[i].number, &node->number);
    }
    for (int i = 0; i < from->named; i++)
        program_name(to, from->names[i].node, from->names[i].text);
    to->inputs = from->inputs;
}

int program_input(struct program *p, const char *name)
{
    int node = program_append(p, OPERATOR_INPUT, -1, -1, 0);
    program_name(p, node, name);
    p->inputs = p->count;
    return node;
}

int program_find(const struct program *p, const char *name)
{
    for (int i = p->named; i-- > 0;)
        if (strcmp(p->names[i].text, name) == 0)
            return p->names[i].node;
    return -1;
}

void program_name(struct program *p, int node, const char *name)
{
    *APPENDED(p->names, p->named) = (struct name){text_copy(name), node};
}

char *program_needs(const struct program *p, int node, const int *stand_in)
{
    char *needed = xrealloc(NULL, (size_t)p->count, 1);
    memset(needed, 0, (size_t)p->count);
    program_mark(p, node, stand_in, needed);
    return needed;
}

void program_mark(const struct program *p, int node, const int *stand_in, char *needed)
{
    needed[node] = 1;
    for (int i = node; i >= 0; i--) {
        const struct node *n = &p->nodes[i];
        bool replaced = stand_in != NULL && stand_in[i] >= 0;
        if (needed[i] && !replaced && n->left >= 0)
            needed[n->left] = 1;
        if (needed[i] && !replaced && n->right >= 0)
            needed[n->right] = 1;
    }
}

int program_copy_node(struct program *p, const struct program *from, int node, int *map)
{
    char *needed = program_needs(from, node, map);
    for (int i = 0; i <= node; i++) {
        const struct node n = from->nodes[i];
        if (!needed[i] || map[i] >= 0)
            continue;
        map[i] = program_append(p, n.op, n.left < 0 ? -1 : map[n.left], n.right < 0 ? -1 : map[n.right], n.exponent);
        fmpq_set(&p->nodes[map[i]].number, &from->nodes[i].number);
    }
    free(needed);
    return map[node];
}

int program_own(struct program *p, int first, int node)
{
    for (int i = 0; i < 2 && node < first + i; i++)
        node = program_append(p, OPERATOR_NEGATE, node, -1, 0);
    return node;
}

/* ---- the parser: recursive descent, one function a level of binding ---- */

enum { DEEPEST_FORMULA = 200 }; /* brackets within brackets: far beyond any formula, far below the C stack's end */

static void skip_blanks(struct parser *s)
{
    while (*s->at == ' ' || *s->at == '\n' || *s->at == '\t')
        s->at++;
}

bool parse_symbol(struct parser *s, char symbol)
{
    skip_blanks(s);
    if (*s->at != symbol)
        return false;
    s->at++;
    return true;
}

int parse_refuse(struct parser *s, const char *expected)
{
    skip_blanks(s);
    if (*s->at == '\0')
        message_set(s->why, "expected %s, the formula ends here", expected);
    else
        message_set(s->why, "expected %s, found '%c'", expected, *s->at);
    return -1;
}

static int parse_number(struct parser *s)
{
    char literal[64];
    size_t n = strspn(s->at, "0123456789.");
    if (s->at[n] == 'e') {
        size_t sign = s->at[n + 1] == '+' || s->at[n + 1] == '-';
        n += 1 + sign + strspn(s->at + n + 1 + sign, "0123456789");
    }
    if (n >= sizeof literal)
        return parse_refuse(s, "a number of less than 64 characters");
    memcpy(literal, s->at, n);
    literal[n] = '\0';
    int node = program_append(s->program, OPERATOR_NUMBER, -1, -1, 0);
    if (literal_read(&s->program->nodes[node].number, literal, true) != LITERAL_FINITE)
        return parse_refuse(s, "a decimal number");
    s->at += n;
    return node;
}

static int parse_call(struct parser *s, enum operator op)
{
    int left = parse_sum(s), right = -1;
    if (left < 0)
        return -1;
    if (op == OPERATOR_ATAN2) {
        if (!parse_symbol(s, ','))
            return parse_refuse(s, "',' and the second argument of atan2");
        if ((right = parse_sum(s)) < 0)
            return -1;
    }
    if (!parse_symbol(s, ')'))
        return parse_refuse(s, "')' or an operator");
    return program_append(s->program, op, left, right, 0);
}

bool parse_word(struct parser *s, char word[LONGEST_NAME + 1])
{
    size_t n = 0;
    skip_blanks(s);
    while (isalnum((unsigned char)s->at[n]) || s->at[n] == '_')
        n++;
    if (n == 0 || n > LONGEST_NAME) {
        parse_refuse(s, n ? "a name of less than 64 characters" : "a name");
        return false;
    }
    memcpy(word, s->at, n);
    word[n] = '\0';
    s->at += n;
    return true;
}

static int unknown_symbol(struct parser *s, const char *name)
{
    const char *near = NEAREST(name, s->program->names, s->program->named, text);
    message_set(s->why, "unknown symbol '%s', expected an input or a named subexpression%s%s%s", name,
                near ? " (did you mean '" : "", near ? near : "", near ? "'?)" : "");
    return -1;
}

static int parse_name(struct parser *s)
{
    static const struct {
        const char *name;
        enum operator op;
    } functions[] = {{"sqrt", OPERATOR_SQRT},   {"sin", OPERATOR_SIN},
                     {"cos", OPERATOR_COS},     {"exp", OPERATOR_EXP},     {"log", OPERATOR_LOG},
                     {"atan2", OPERATOR_ATAN2}, {"positive", OPERATOR_POSITIVE}};
    const char *begin = s->at;
    char name[LONGEST_NAME + 1];
    if (!parse_word(s, name))
        return -1;
    for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
        if (strcmp(name, functions[i].name) == 0)
            return parse_symbol(s, '(') ? parse_call(s, functions[i].op) : parse_refuse(s, "'('");
    if (s->reference != NULL && (*s->at == '.' || *s->at == '('))
        return s->reference(s, name);
    int node = program_find(s->program, name);
    if (node < 0) {
        s->at = begin;
        return unknown_symbol(s, name);
    }
    return node;
}

static int parse_primary(struct parser *s)
{
    skip_blanks(s);
    if (isdigit((unsigned char)*s->at) || *s->at == '.')
        return parse_number(s);
    if (isalpha((unsigned char)*s->at))
        return parse_name(s);
    if (!parse_symbol(s, '('))
        return parse_refuse(s, "a number, a symbol or '('");
    int node = parse_sum(s);
    if (node >= 0 && !parse_symbol(s, ')'))
        return parse_refuse(s, "')' or an operator");
    return node;
}

static int parse_power(struct parser *s)
{
    int base = parse_primary(s);
    if (base < 0 || !parse_symbol(s, '^'))
        return base;
    skip_blanks(s);
    size_t n = strspn(s->at, "0123456789");
    if (n == 0 || n > 3)
        return parse_refuse(s, "an exponent of at most three digits");
    slong exponent = strtol(s->at, NULL, 10);
    s->at += n;
    return program_append(s->program, OPERATOR_POWER, base, -1, exponent);
}

static int parse_sign(struct parser *s)
{
    if (!parse_symbol(s, '-'))
        return parse_power(s);
    if (++s->depth > DEEPEST_FORMULA)
        return parse_refuse(s, "less nesting");
    int operand = parse_sign(s);
    s->depth--;
    return operand < 0 ? -1 : program_append(s->program, OPERATOR_NEGATE, operand, -1, 0);
}

/* Operands with one of two operators between them, from left to right. */
static int parse_chain(struct parser *s, int (*operand)(struct parser *), const char symbols[2], enum operator first,
                       enum operator second)
{
    int left = operand(s);
    while (left >= 0) {
        const bool is_first = parse_symbol(s, symbols[0]);
        if (!is_first && !parse_symbol(s, symbols[1]))
            break;
        const int right = operand(s);
        left = right < 0 ? -1 : program_append(s->program, is_first ? first : second, left, right, 0);
    }
    return left;
}

static int parse_product(struct parser *s)
{
    return parse_chain(s, parse_sign, "*/", OPERATOR_MULTIPLY, OPERATOR_DIVIDE);
}

int parse_sum(struct parser *s)
{
    if (++s->depth > DEEPEST_FORMULA)
        return parse_refuse(s, "less nesting");
    const int sum = parse_chain(s, parse_product, "+-", OPERATOR_ADD, OPERATOR_SUBTRACT);
    s->depth--;
    return sum;
}

int program_parse(struct program *p, const char *text, struct message *why)
{
    struct message unread;
    size_t where;
    return program_parse_with(p, text, NULL, NULL, &where, why != NULL ? why : &unread);
}

int program_parse_with(struct program *p, const char *text, reference_reader *reference, void *context,
                       size_t *where, struct message *why)
{
    struct parser s = {.program = p, .at = text, .why = why, .reference = reference, .context = context};
    int node = parse_sum(&s);
    skip_blanks(&s);
    if (node >= 0 && *s.at != '\0')
        node = parse_refuse(&s, "an operator or the end of the formula");
    *where = (size_t)(s.at - text);
    return node;
}

int program_read(struct program *p, const struct yaml *n, const char *text, size_t shift, reference_reader *reference, void *context)
{
    struct message expected = {""};
    size_t where;
    const int result = program_parse_with(p, text, reference, context, &where, &expected);
    if (result < 0)
        node_error(n, shift + where, "%s", expected.text);
    return result;
}

/* ---- derivatives of programs ---- */

/*
 * What a derivative by a node is times that of the node by its left and its right operand: its sign, then what multiplies (*)
 * and divides (/) it:
 *
 *     L, R  the operands      Z  the node itself      D  twice that      n  the exponent      P  L^(n - 1)
 *     C, S  cosine and sine of L      Q  L^2 + R^2
 *
 * positive() has none, flat but for the jump, where the caller has no business.
 */
static const char *const slopes[OPERATOR_POSITIVE + 1][2] = {
    [OPERATOR_NEGATE] = {"-"},   [OPERATOR_ADD] = {"+", "+"},         [OPERATOR_SUBTRACT] = {"+", "-"},
    [OPERATOR_SQRT] = {"+/D"},   [OPERATOR_MULTIPLY] = {"+*R", "+*L"}, [OPERATOR_DIVIDE] = {"+/R", "-/R*Z"},
    [OPERATOR_SIN] = {"+*C"},    [OPERATOR_COS] = {"-*S"},            [OPERATOR_POWER] = {"+*n*P"},
    [OPERATOR_EXP] = {"+*Z"},    [OPERATOR_LOG] = {"+/L"},            [OPERATOR_ATAN2] = {"+*R/Q", "-*L/Q"},
};

static int factor_node(struct program *p, int i, char factor)
{
    const struct node n = p->nodes[i];
    switch (factor) {
    case 'L':
        return n.left;
    case 'R':
        return n.right;
    case 'Z':
        return i;
    case 'D':
        return program_append(p, OPERATOR_ADD, i, i, 0);
    case 'n':
        return append_integer(p, n.exponent);
    case 'P':
        return program_append(p, OPERATOR_POWER, n.left, -1, n.exponent - 1);
    case 'C':
        return program_append(p, OPERATOR_COS, n.left, -1, 0);
    case 'S':
        return program_append(p, OPERATOR_SIN, n.left, -1, 0);
    default:
        return program_append(p, OPERATOR_ADD, program_append(p, OPERATOR_MULTIPLY, n.left, n.left, 0),
                              program_append(p, OPERATOR_MULTIPLY, n.right, n.right, 0), 0);
    }
}

/* d times the derivative of node i by an operand; -1 stands for zero. */
static int times_slope(struct program *p, int i, bool right, int d)
{
    const char *slope = slopes[p->nodes[i].op][right];
    if (d < 0 || slope == NULL || (p->nodes[i].op == OPERATOR_POWER && p->nodes[i].exponent == 0))
        return -1;
    for (const char *at = slope + 1; *at != '\0'; at += 2) {
        const int factor = factor_node(p, i, at[1]);
        d = program_append(p, *at == '*' ? OPERATOR_MULTIPLY : OPERATOR_DIVIDE, d, factor, 0);
    }
    return *slope == '-' ? program_append(p, OPERATOR_NEGATE, d, -1, 0) : d;
}

static int sum(struct program *p, int a, int b)
{
    return a < 0 ? b : b < 0 ? a : program_append(p, OPERATOR_ADD, a, b, 0);
}

int program_derivative(struct program *p, int node, const int *rate, int rates)
{
    int *derivative = xrealloc(NULL, (size_t)node + 1, sizeof *derivative);
    char *needed = program_needs(p, node, NULL);
    for (int i = 0; i <= node; i++) {
        const int left = p->nodes[i].left, right = p->nodes[i].right;
        derivative[i] = i < rates ? rate[i] : -1;
        if (derivative[i] < 0 && needed[i]) {
            const int by_left = times_slope(p, i, false, left < 0 ? -1 : derivative[left]);
            derivative[i] = sum(p, by_left, times_slope(p, i, true, right < 0 ? -1 : derivative[right]));
        }
    }
    int result = derivative[node];
    free(derivative);
    free(needed);
    return result < 0 ? append_integer(p, 0) : result;
}

/* The derivatives of a node by all inputs, each a node: reverse differentiation. */
static void append_gradient(struct program *p, int node, int *by)
{
    int *derivative = xrealloc(NULL, (size_t)node + 1, sizeof *derivative); /* of the node by each of those before it */
    for (int i = 0; i < node; i++)
        derivative[i] = -1;
    derivative[node] = append_integer(p, 1);
    for (int i = node; i >= p->inputs; i--) {
        const int operands[2] = {p->nodes[i].left, p->nodes[i].right};
        const bool none = p->nodes[i].op == OPERATOR_SUBTRACT && operands[0] == operands[1]; /* x - x does not change */
        for (int k = 0; k < 2 && operands[k] >= 0 && !none; k++)
            derivative[operands[k]] = sum(p, derivative[operands[k]], times_slope(p, i, k == 1, derivative[i]));
    }
    for (int i = 0; i < p->inputs; i++)
        by[i] = i > node || derivative[i] < 0 ? append_integer(p, 0) : derivative[i];
    free(derivative);
}

/* ---- machines ---- */

void machine_init(struct machine *m, const struct program *p, const struct arithmetic *a, slong prec)
{
    *m = (struct machine){p, a, prec, NULL, p->count};
    m->values = xrealloc(NULL, (size_t)m->count, a->size);
    for (int i = 0; i < m->count; i++)
        a->init(machine_value(m, i), prec);
    for (int i = 0; i < p->count; i++)
        if (p->nodes[i].op == OPERATOR_NUMBER)
            a->set_rational(machine_value(m, i), &p->nodes[i].number, prec);
}

void machine_clear(struct machine *m)
{
    for (int i = 0; i < m->count; i++)
        m->arithmetic->clear(machine_value(m, i));
    free(m->values);
    m->values = NULL;
}

void *machine_value(const struct machine *m, int node)
{
    return m->values + (size_t)node * m->arithmetic->size;
}

static void run_node(struct machine *m, int i)
{
    const struct node *node = &m->program->nodes[i];
    if (node->op != OPERATOR_NUMBER)
        m->arithmetic->apply(node->op, machine_value(m, i), machine_value(m, node->left),
                             node->right < 0 ? NULL : machine_value(m, node->right), node->exponent, m->prec);
}

/* The value of a sine or cosine where an earlier node is just that; NULL: none is. They take longest. */
static void *known_value(const struct machine *m, int node)
{
    const struct node *nodes = m->program->nodes, *n = &nodes[node];
    for (int i = m->program->inputs; i < node && (n->op == OPERATOR_SIN || n->op == OPERATOR_COS); i++)
        if (nodes[i].op == n->op && nodes[i].left == n->left)
            return machine_value(m, i);
    return NULL;
}

static void run_from(struct machine *m, int first)
{
    for (int i = first; i < m->program->count; i++) {
        const void *known = known_value(m, i);
        if (known != NULL && m->arithmetic->set != NULL)
            m->arithmetic->set(machine_value(m, i), known);
        else
            run_node(m, i);
    }
}

void machine_run(struct machine *m)
{
    run_from(m, m->program->inputs);
}

void machine_run_to(struct machine *m, int node)
{
    char *needed = program_needs(m->program, node, NULL);
    for (int i = m->program->inputs; i <= node; i++)
        if (needed[i])
            run_node(m, i);
    free(needed);
}

void gradient_init(struct gradient *g, const struct program *p, const int *nodes, int count, const struct arithmetic *a, slong prec)
{
    program_copy(&g->program, p);
    g->by = xrealloc(NULL, (size_t)(count * p->inputs) + 1, sizeof *g->by);
    for (int k = 0; k < count; k++)
        append_gradient(&g->program, nodes[k], g->by + k * p->inputs);
    machine_init(&g->machine, &g->program, a, prec);
}

void gradient_run(struct gradient *g, const struct machine *m)
{
    g->machine.program = &g->program; /* which may have moved */
    for (int i = 0; i < m->program->count; i++)
        m->arithmetic->set(machine_value(&g->machine, i), machine_value(m, i));
    run_from(&g->machine, m->program->count);
}

void *gradient_value(const struct gradient *g, int k, int input)
{
    return machine_value(&g->machine, g->by[k * g->program.inputs + input]);
}

void gradient_clear(struct gradient *g)
{
    machine_clear(&g->machine);
    program_clear(&g->program);
    free(g->by);
}
