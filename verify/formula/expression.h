/*
 * Formulas: parsed once from plain infix into a program, which then runs in any arithmetic.
 *
 * A program is a list of nodes in postfix order, each naming the earlier nodes that it works on; the
 * first nodes are the inputs. A named subexpression is a node with a name, computed once.
 */
#ifndef CT_EXPRESSION_H
#define CT_EXPRESSION_H

#include "formula/arithmetic.h"
#include "text/tree.h"

struct node {
    enum operator op;
    int left, right; /* operands: earlier nodes, -1 where there is none   */
    slong exponent;  /* of a power                                        */
    fmpq number;     /* of a number                                       */
};

struct name {
    char *text;
    int node;
};

struct program {
    struct node *nodes;
    int count;
    int inputs;         /* nodes 0 ... inputs - 1                                */
    struct name *names; /* of inputs and subexpressions, in order of appearance  */
    int named;
};

void program_init(struct program *p);
void program_clear(struct program *p);
void program_copy(struct program *to, const struct program *from);

/* Inputs come before everything else. Returns the node. */
int program_input(struct program *p, const char *name);

/* The node of that name, -1 when there is none. */
int program_find(const struct program *p, const char *name);

/* Gives a node a (further) name. */
void program_name(struct program *p, int node, const char *name);

/*
 * Parses one formula, + - * / ^ ( ) sqrt sin cos exp log atan2 positive, over the names the program knows.
 * Returns its node; or -1, with what was expected in `why` (NULL: nobody asks).
 */
int program_parse(struct program *p, const char *text, struct message *why);

/*
 * A formula may also refer to what the program does not hold, by NAME.more or NAME(...): the caller reads
 * that. The reader is called after NAME and goes on from `at`, with parse_sum() for what is a formula
 * again. It returns a node; or -1, with `why` set and `at` where the mistake is, whose offset into the text *where is.
 */
struct parser;
typedef int reference_reader(struct parser *s, const char *name);

struct parser {
    struct program *program;
    const char *at;
    struct message *why;
    int depth;
    reference_reader *reference; /* NULL: there are none */
    void *context;               /* the reader's own     */
};

int program_parse_with(struct program *p, const char *text, reference_reader *reference, void *context,
                       size_t *where, struct message *why);

/* The formula that stands `shift` characters into a scalar; -1 after a complaint that points into it. */
int program_read(struct program *p, const struct yaml *n, const char *text, size_t shift, reference_reader *reference, void *context);

enum { LONGEST_NAME = 63 };
int parse_sum(struct parser *s);
bool parse_symbol(struct parser *s, char symbol);                  /* passes it if it is the next one   */
bool parse_word(struct parser *s, char word[LONGEST_NAME + 1]);    /* letters, digits, _; at least one  */
int parse_refuse(struct parser *s, const char *expected);          /* -1, and "expected ..., found ..." */

/*
 * Copies a node of another program with all that it rests on: map[i] is the node that takes the place of node i, -1: none
 * (all inputs that it needs have one), and becomes what node i is in p, of all that is copied. Returns the copy.
 */
int program_copy_node(struct program *p, const struct program *from, int node, int *map);

/* The node, or twice its negative where it is older than `first`: a node of its own. */
int program_own(struct program *p, int first, int node);

/* needed[i]: the node rests on node i, and not by way of a node that stand_in (NULL: none) replaces. To be freed. */
char *program_needs(const struct program *p, int node, const int *stand_in);

/* The same, beside what is marked already. */
void program_mark(const struct program *p, int node, const int *stand_in, char *needed);

/* One more node; operands that an operator does not have are -1. */
int program_append(struct program *p, enum operator op, int left, int right, slong exponent);

/*
 * The derivative of a node when named quantities move: rate[i] is the node that stands for the
 * derivative of node i (rates of them; -1 for a constant, and for every node that is computed).
 * Appends what it needs to the program and returns the derivative's node.
 */
int program_derivative(struct program *p, int node, const int *rate, int rates);

/* A program at work in one arithmetic: a value for every node. */
struct machine {
    const struct program *program;
    const struct arithmetic *arithmetic;
    slong prec;
    char *values;
    int count; /* of values, one for each node */
};

void machine_init(struct machine *m, const struct program *p, const struct arithmetic *a, slong prec);
void machine_clear(struct machine *m);
void *machine_value(const struct machine *m, int node);

/* Computes every node after the inputs, which the caller has set through machine_value(). */
void machine_run(struct machine *m);

/* Of these only what a node rests on, and itself. */
void machine_run_to(struct machine *m, int node);

/* The derivatives of nodes by all inputs (reverse differentiation): the program with theirs behind it. */
struct gradient {
    struct program program;
    struct machine machine;
    int *by; /* the derivative of the k-th node by input i: by[k*inputs + i] */
};

void gradient_init(struct gradient *g, const struct program *p, const int *nodes, int count, const struct arithmetic *a, slong prec);
void gradient_clear(struct gradient *g);

/* Where the values are those of m, which has run; to machine.prec, its own. */
void gradient_run(struct gradient *g, const struct machine *m);
void *gradient_value(const struct gradient *g, int k, int input);

#endif
