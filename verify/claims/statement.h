/*
 * The statements of paper/claims.yaml, read, and the verdicts on them.
 *
 * A statement has assertions, each found true or false or left undecided, and verdicts, each under a condition on them.
 * No assertion may be missing: one that a condition or a number needs and that is not decided leaves the verdict open.
 */
#ifndef CT_STATEMENT_H
#define CT_STATEMENT_H

#include "claims/claim.h"
#include "claims/marked.h"
#include "proof/derivation.h"

enum { MOST_ASSERTIONS = 40, MOST_TURNS = 8, MOST_CITED = 8, MOST_STATES = 6 };

/* A formula over whatever has a name where it stands. */
struct formula {
    const struct program *program; /* NULL: there is none */
    int node;
    ulong uses; /* a bit for each assertion that it takes a number of */
};

/* `at`: a name's values, one after another, or its one value and its uncertainty, if it has one. */
struct value {
    const char *name;
    struct formula of[MOST_TURNS], radius;
    int turns;
    ulong uses;
};

struct values {
    struct value *list;
    int count, turns; /* turns: so many values has each that has more than one */
};

enum assertion_kind {
    ASSERT_SHOW, ASSERT_ROOT, ASSERT_ROOTS, ASSERT_RANK, ASSERT_STEP, ASSERT_CLAIM, ASSERT_COMPUTE
};

/* States and their rates, in which they are linear. */
struct linear_system {
    int size;
    const struct program *of;
    int states[MOST_STATES], rates[MOST_STATES]; /* nodes */
    int control, observe;                 /* a node, -1; a state's index, -1 */
};

struct assertion {
    const char *name;
    const struct yaml *node;
    enum assertion_kind kind;
    int sign;                     /* of left - right: -1, 0, 1                          */
    const struct identities *identity; /* an equality for all values; NULL: it is none  */
    struct formula formula;       /* left - right; whose roots                          */
    int right;                    /* node of it                                         */
    bool loose;                   /* right is a number alone, yet at no turn within ten of left */
    const char *variable;         /* that moves between low and high; NULL: none        */
    struct formula low, high;     /* of roots low alone                                 */
    struct values at;
    long count;
    struct linear_system system;
    const char *cited[MOST_CITED + 1]; /* the ids of steps or of claims; NULL: no further one */
    struct computed *computed;
    ulong uses;                   /* assertions that it takes numbers of */
    bool done;
    enum truth truth;
    enum how how;
};

/* A number of the evidence. */
enum rounding { TO_DIGITS, UPWARD, DOWNWARD, AS_RATIONAL };

struct quoted_number {
    struct formula formula;
    const char *text, *unit;
    enum rounding rounding;
    slong digits;
    const struct yaml *node;      /* where it stands */
    size_t offset;
    char *decimal;                /* NULL: its digits are not proved */
    enum how how;
};

/* What a verdict wants of each assertion: 1 that it is true, -1 that it is false, 0 nothing. */
struct verdict_condition {
    signed char wanted[MOST_ASSERTIONS];
};

struct statement {
    const char *id, *where, *kind, *claim, *why, *evidence;
    int word_of_kind;
    const struct yaml *given, *system, *prove, *verdict;
    struct assertion *assertions;
    int assertion_count;
    enum verdict verdicts[VERDICTS];
    struct verdict_condition conditions[VERDICTS];
    int verdict_count;
    const char *equations[8];     /* it is a reason of the verdicts on these, too */
    int equation_count;
    struct values at;             /* of `given` */
    struct quoted_number *numbers;
    int number_count;
};

struct statements {
    struct tree *tree;
    const struct sheet *sheet;
    const struct derivations *proofs;
    struct statement *list;
    int count;
    struct computations computed;
    char **texts;
    const char **names; /* of the statement that is read */
    struct identities **formulas; /* of an entry each, or of the evidence */
    int text_count, name_count, formula_count;
};

/* Reads them; -1 and "name:line:column: expected ..." where the sheet is broken. A step is proved when a verdict asks. */
int statements_read(struct statements *s, const struct derivations *proofs, const struct source *source, struct message *why);
void statements_clear(struct statements *s);
struct statement *statement_find(const struct statements *s, const char *id);

/* What comes of a statement. */
struct ruling {
    enum verdict verdict; /* VERDICT_NONE: undecided */
    enum how how;
    bool as_written;      /* it is the one that the evidence is written for, and all numbers are proved */
    struct message open;  /* what is open, where: "paper/claims.yaml:120:5: ..." */
};

/*
 * None stands without one of its assertions, or with its contrary: each condition is of all that it names, and what none names serves
 * one that is named, or a number, or the sheet is refused.
 */
void statement_decide(struct statements *all, struct statement *s, struct ruling *r);

/* The evidence with its numbers, after the statement was decided. */
void statement_evidence(const struct statement *s, struct written *w);

/* ---- between the files ---- */

enum truth truth_both(enum truth a, enum truth b);

/* The first section of an equation number; NULL: there is none. */
const struct section *section_with(const struct sheet *sheet, const char *equation);

/* What a formula's names stand for. */
struct bindings {
    struct statements *all;
    struct statement *statement;
    const struct values *at;
    int at_count;                      /* of them: those that may be used */
    int turn;                          /* which of its values each has now */
    const char *moving;                /* a name that moves, bound by who moves it; NULL: none */
    bool inside;                       /* a value, where what moves has none */
    slong bits;
    enum how *how;                     /* the weakest way in which a value was known */
};

static inline void weaken(const struct bindings *b, enum how how)
{
    *b->how = FLINT_MAX(*b->how, how);
}

/* The formula's value; an indeterminate ball where a name has none. */
void formula_enclose(arb_t z, const struct formula *f, const struct bindings *b);

/* Its value as an exact number, where all its names have one and it is rational. */
bool formula_rational(fmpq_t q, const struct formula *f, const struct bindings *b);

/* Sets the inputs that a node needs, but for what moves: in balls; or else exactly, false where one has no rational value. */
bool machine_bind(struct machine *m, int node, bool balls, const struct bindings *b);

/* Whether a name is a number of an entry: ENTRY or ENTRY.number. */
bool is_number_of(const char *name, const char *entry);

/* The root that an assertion names, where it is the only one there; how many there are, -1: that stays open. */
slong root_enclose(arb_t z, struct assertion *a, const struct bindings *of, slong bits);

void assertion_find(struct statements *all, struct statement *s, struct assertion *a);

#endif
