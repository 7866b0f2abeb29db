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

void program_needs(const struct program *p, int node, const int *stand_in, char *needed)
{
    memset(needed, 0, (size_t)node + 1);
    program_mark(p, node, stand_in, needed);
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
    char *needed = xrealloc(NULL, (size_t)node + 1, 1);
    program_needs(from, node, map, needed);
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

void program_truncate(struct program *p, int count)
{
    while (p->count > count)
        fmpq_clear(&p->nodes[--p->count].number);
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
    if (s->at[n] == 'e' || s->at[n] == 'E') {
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
    bool negative = parse_symbol(s, '-');
    skip_blanks(s);
    size_t n = strspn(s->at, "0123456789");
    if (n == 0 || n > 3)
        return parse_refuse(s, "an integer exponent of at most three digits");
    slong exponent = strtol(s->at, NULL, 10);
    s->at += n;
    return program_append(s->program, OPERATOR_POWER, base, -1, negative ? -exponent : exponent);
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

int program_parse(struct program *p, const char *text, size_t *where, struct message *why)
{
    return program_parse_with(p, text, NULL, NULL, where, why);
}

int program_parse_with(struct program *p, const char *text, reference_reader *reference, void *context,
                       size_t *where, struct message *why)
{
    struct parser s = {.program = p, .text = text, .at = text, .reference = reference, .context = context};
    s.why = why;
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

static int product_node(struct program *p, int a, int b)
{
    return a < 0 || b < 0 ? -1 : program_append(p, OPERATOR_MULTIPLY, a, b, 0);
}

static int negative(struct program *p, int a)
{
    return a < 0 ? -1 : program_append(p, OPERATOR_NEGATE, a, -1, 0);
}

static int sum(struct program *p, int a, int b)
{
    return a < 0 ? b : b < 0 ? a : program_append(p, OPERATOR_ADD, a, b, 0);
}

static int quotient(struct program *p, int a, int b)
{
    return a < 0 ? -1 : program_append(p, OPERATOR_DIVIDE, a, b, 0);
}

/* The rate of node i, given the rates a of its left and b of its right operand; -1 stands for zero. */
static int node_rate(struct program *p, int i, int a, int b)
{
    const struct node node = p->nodes[i];
    switch (node.op) {
    case OPERATOR_NEGATE:
        return negative(p, a);
    case OPERATOR_ADD:
        return sum(p, a, b);
    case OPERATOR_SUBTRACT:
        return sum(p, a, negative(p, b));
    case OPERATOR_MULTIPLY:
        return sum(p, product_node(p, a, node.right), product_node(p, node.left, b));
    case OPERATOR_DIVIDE: /* (l/r)' = (l' - (l/r) r') / r */
        return quotient(p, sum(p, a, negative(p, product_node(p, i, b))), node.right);
    case OPERATOR_POWER:
        if (a < 0 || node.exponent == 0)
            return -1;
        return product_node(p, a, product_node(p, append_integer(p, node.exponent),
                                     program_append(p, OPERATOR_POWER, node.left, -1, node.exponent - 1)));
    case OPERATOR_SQRT:
        return a < 0 ? -1 : quotient(p, a, product_node(p, append_integer(p, 2), i));
    case OPERATOR_SIN:
        return a < 0 ? -1 : product_node(p, a, program_append(p, OPERATOR_COS, node.left, -1, 0));
    case OPERATOR_COS:
        return a < 0 ? -1 : negative(p, product_node(p, a, program_append(p, OPERATOR_SIN, node.left, -1, 0)));
    case OPERATOR_EXP:
        return product_node(p, a, i);
    case OPERATOR_LOG:
        return quotient(p, a, node.left);
    case OPERATOR_ATAN2: /* (x y' - y x') / (x^2 + y^2) */
        return quotient(p, sum(p, product_node(p, node.right, a), negative(p, product_node(p, node.left, b))),
                        sum(p, product_node(p, node.left, node.left), product_node(p, node.right, node.right)));
    case OPERATOR_INPUT:
    case OPERATOR_NUMBER:
    case OPERATOR_POSITIVE: /* flat but for the jump, where the caller has no business */
        break;
    }
    return -1;
}

int program_derivative(struct program *p, int node, const int *rate, int rates)
{
    int *derivative = xrealloc(NULL, (size_t)node + 1, sizeof *derivative);
    char *needed = xrealloc(NULL, (size_t)node + 1, 1);
    program_needs(p, node, NULL, needed);
    for (int i = 0; i <= node; i++) {
        int left = p->nodes[i].left, right = p->nodes[i].right;
        derivative[i] = i < rates ? rate[i] : -1;
        if (derivative[i] < 0 && needed[i])
            derivative[i] = node_rate(p, i, left < 0 ? -1 : derivative[left],
                                      right < 0 ? -1 : derivative[right]);
    }
    int result = derivative[node];
    free(derivative);
    free(needed);
    return result < 0 ? append_integer(p, 0) : result;
}

/* ---- machines ---- */

enum { SCRATCH = 3 };

void machine_init(struct machine *m, const struct program *p, const struct arithmetic *a, slong prec)
{
    *m = (struct machine){p, a, prec, NULL, p->count + SCRATCH};
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

static void compute(const struct machine *m, enum operator op, void *z, const void *x, const void *y)
{
    m->arithmetic->apply(op, z, x, y, 0, m->prec);
}

static void run_node(struct machine *m, int i)
{
    const struct node *node = &m->program->nodes[i];
    if (node->op != OPERATOR_NUMBER)
        m->arithmetic->apply(node->op, machine_value(m, i), machine_value(m, node->left),
                             node->right < 0 ? NULL : machine_value(m, node->right), node->exponent, m->prec);
}

/* The value of a sine or cosine where a node before `end` is just that; NULL: none is. They take longest. */
static void *known_value(const struct machine *m, enum operator op, int operand, int end)
{
    for (int i = m->program->inputs; i < end && (op == OPERATOR_SIN || op == OPERATOR_COS); i++)
        if (m->program->nodes[i].op == op && m->program->nodes[i].left == operand)
            return machine_value(m, i);
    return NULL;
}

void machine_run(struct machine *m)
{
    for (int i = m->program->inputs; i < m->program->count; i++) {
        const void *known = known_value(m, m->program->nodes[i].op, m->program->nodes[i].left, i);
        if (known != NULL && m->arithmetic->set != NULL)
            m->arithmetic->set(machine_value(m, i), known);
        else
            run_node(m, i);
    }
}

void machine_run_to(struct machine *m, int node)
{
    char *needed = xrealloc(NULL, (size_t)node + 1, 1);
    program_needs(m->program, node, NULL, needed);
    for (int i = m->program->inputs; i <= node; i++)
        if (needed[i])
            run_node(m, i);
    free(needed);
}

/* Whether what node i passes on to its left operand (or its right one) is taken away: multiply() leaves the sign out. */
static bool is_negative(const struct node *node, bool right)
{
    return node->op == OPERATOR_NEGATE || node->op == OPERATOR_COS ||
           (right && (node->op == OPERATOR_SUBTRACT || node->op == OPERATOR_DIVIDE || node->op == OPERATOR_ATAN2));
}

/* d, the derivative by node i, times that of the node by its left operand (or its right one); e and f are scratch. */
static void multiply(const struct machine *m, int i, bool right, void *d, void *e, void *f)
{
    const struct node *node = &m->program->nodes[i];
    void *x = machine_value(m, node->left), *z = machine_value(m, i);
    void *y = node->right < 0 ? NULL : machine_value(m, node->right);
    const enum operator other = node->op == OPERATOR_SIN ? OPERATOR_COS : OPERATOR_SIN;
    const void *known;
    SCOPE(fmpq, number);
    switch (node->op) {
    case OPERATOR_MULTIPLY:
        compute(m, OPERATOR_MULTIPLY, d, d, right ? x : y);
        break;
    case OPERATOR_DIVIDE:
        compute(m, OPERATOR_DIVIDE, d, d, y);
        if (right)
            compute(m, OPERATOR_MULTIPLY, d, d, z);
        break;
    case OPERATOR_POWER:
        fmpq_set_si(number, node->exponent, 1);
        m->arithmetic->set_rational(e, number, m->prec);
        compute(m, OPERATOR_MULTIPLY, d, d, e);
        m->arithmetic->apply(OPERATOR_POWER, e, x, NULL, node->exponent - 1, m->prec);
        compute(m, OPERATOR_MULTIPLY, d, d, e);
        break;
    case OPERATOR_SQRT:
        compute(m, OPERATOR_ADD, e, z, z);
        compute(m, OPERATOR_DIVIDE, d, d, e);
        break;
    case OPERATOR_SIN:
    case OPERATOR_COS:
        known = known_value(m, other, node->left, m->program->count);
        if (known == NULL)
            compute(m, other, e, x, NULL);
        compute(m, OPERATOR_MULTIPLY, d, d, known != NULL ? known : e);
        break;
    case OPERATOR_EXP:
        compute(m, OPERATOR_MULTIPLY, d, d, z);
        break;
    case OPERATOR_LOG:
        compute(m, OPERATOR_DIVIDE, d, d, x);
        break;
    case OPERATOR_ATAN2: /* by y: x / (x^2 + y^2), by x: -y / (x^2 + y^2); here x is y, and y is x */
        compute(m, OPERATOR_MULTIPLY, d, d, right ? x : y);
        compute(m, OPERATOR_MULTIPLY, e, x, x);
        compute(m, OPERATOR_MULTIPLY, f, y, y);
        compute(m, OPERATOR_ADD, e, e, f);
        compute(m, OPERATOR_DIVIDE, d, d, e);
        break;
    case OPERATOR_POSITIVE: /* flat but for the jump, where the caller has no business */
        m->arithmetic->set_rational(d, number, m->prec);
        break;
    default: /* of a sum the factor is 1 */
        break;
    }
}

void machine_gradient(const struct machine *m, int node, struct machine *adjoint)
{
    const struct program *p = m->program;
    void *d = machine_value(adjoint, p->count), *e = machine_value(adjoint, p->count + 1);
    void *f = machine_value(adjoint, p->count + 2);
    char *reached = xrealloc(NULL, (size_t)p->count, 1);
    SCOPE(fmpq, number);
    memset(reached, 0, (size_t)p->count);
    for (int i = 0; i < p->inputs; i++)
        m->arithmetic->set_rational(machine_value(adjoint, i), number, m->prec);
    fmpq_one(number);
    m->arithmetic->set_rational(machine_value(adjoint, node), number, m->prec);
    reached[node] = 1;
    for (int i = node; i >= p->inputs; i--) {
        const struct node *of = &p->nodes[i];
        const int operands[2] = {of->left, of->right};
        for (int k = 0; k < 2 && reached[i]; k++) {
            if (operands[k] < 0 || (of->op == OPERATOR_SUBTRACT && operands[0] == operands[1]))
                continue; /* no operand, or x - x, which does not change */
            void *sum = machine_value(adjoint, operands[k]), *term = reached[operands[k]] ? d : sum;
            m->arithmetic->set(term, machine_value(adjoint, i));
            multiply(m, i, k == 1, term, e, f);
            if (reached[operands[k]])
                compute(m, is_negative(of, k == 1) ? OPERATOR_SUBTRACT : OPERATOR_ADD, sum, sum, d);
            else if (is_negative(of, k == 1))
                compute(m, OPERATOR_NEGATE, sum, sum, NULL);
            reached[operands[k]] = 1;
        }
    }
    free(reached);
}
