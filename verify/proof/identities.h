/*
 * Identities: equalities between formulas over free quantities, and their proof by normal forms (symbolic.h).
 *
 * The steps of derivations.yaml and the claims of claims.yaml state them alike: a mapping says what is free and what is
 * defined (angles, positive, "not negative", free, small, order, rates, let, "square roots"), a list what is equal.
 */
#ifndef CT_IDENTITIES_H
#define CT_IDENTITIES_H

#include "sheet/sheet.h"
#include "text/document.h"

enum { SIGN_NEGATIVE = 1, SIGN_ZERO = 2, SIGN_POSITIVE = 4, SIGN_ANY = 7 }; /* sets of signs */
enum { MOST_SHOWN = 32, MOST_BOUND = 40 };

/* A free quantity: its signs, and what else is said of it. */
struct variable {
    int signs;
    bool angle, quarter_turn;
    int power; /* it is multiplied by epsilon^power */
};

struct equality {
    const char *text;
    const yaml_node_t *at;
    int left, right;
};

/* What a square root is said to be equal to: to be proved positive. */
struct root {
    const char *text;
    int node;
};

/* What a formula takes of the sheet or of the definitions: a node of a section's program, or a side of a relation. */
struct use {
    const struct section *section;
    const struct relation *relation; /* NULL: none                               */
    const struct formulas *formulas;
    int part;                        /* the node in the section's program; 0 left, 1 right */
    int bound[MOST_BOUND];           /* what the section's inputs are            */
    int pair;                        /* of the numbers that alter it, -1: none   */
};

struct identities {
    struct program program;
    struct variable *variables; /* of its inputs */
    struct equality *shown;
    struct root *roots;
    struct use *uses;
    int shown_count, root_count, use_count;
    int first_pair, pairs;      /* inputs that an alteration takes up */
    int order;                  /* the highest power of epsilon that is compared; -1: exact */
    bool shared;                /* what is given serves others too: not all need serve here */
    char **lets;                /* "C2 = 0": quantities of the sheet that are bound to a formula of their own */
    int sheet_lets;
    char *needed;               /* needed[i]: something shown rests on node i */
};

/* Principles and properties: sections that have formulas, but no equation number. */
struct definitions {
    struct section *sections;
    struct quantity **outputs; /* what the sections' outputs point to */
    int count, output_count;
};

/*
 * What becomes of the identities when formulas change. ANY: each formula F that `concerns` becomes a F + b with free
 * a and b of its own (an angle is turned by b). Else one node of one section's program, or of one relation, changes, or
 * (RESULT) the sign of that part where a formula refers to it.
 */
enum change { CHANGE_ANY, CHANGE_RESULT, CHANGE_SIGN, CHANGE_LEFT, CHANGE_RIGHT, CHANGE_NUMBER, CHANGES };

struct alteration {
    enum change change;
    bool (*concerns)(const void *context, const struct use *u);
    const void *context;
    int node;
};

/* Whether a node can change so; the change, and the node that is wanted then; the program of a side of a relation. */
int alteration_make(struct program *p, enum change change, int node, int wanted);
bool alteration_applies(const struct program *p, enum change change, int node);
int relation_program(struct program *p, const struct sheet *sheet, const struct relation *relation, bool right);

/* What the names of formulas may stand for, and where they are written. */
struct scope {
    const struct document *document;
    const struct sheet *sheet;
    const struct definitions *definitions; /* NULL: none                              */
    const yaml_node_t *given;              /* the mapping; NULL: everything is free   */
    const yaml_node_t *shared;             /* of what it does not say; then not all need serve here. NULL: none */
    const yaml_node_t *variant;            /* a mapping with another `let`; NULL: none */
    const char *const *names;              /* further free names                      */
    int name_count;
    const struct alteration *alteration;   /* NULL: none                              */
};

/* Of an open scope, a formula each: its node, -1 after a complaint; an equality each, false after a complaint. */
bool identities_open(struct identities *t, const struct scope *s);
int identities_formula(struct identities *t, const struct scope *s, const yaml_node_t *node);
bool identities_show(struct identities *t, const struct scope *s, const yaml_node_t *node);
/* What is declared and defined serves something (unless altered), and square roots are where they are needed. */
bool identities_close(struct identities *t, const struct scope *s);
void identities_clear(struct identities *t);

/* The keys of the mapping, to tell them from others: NULL ends them. */
extern const char *const identities_keys[];

/* The node of a formula in the program's names and the sheet's; -1 with `why`: where it is already read. */
int identities_text(struct identities *t, const struct scope *s, const char *text, size_t *where, struct message *why);

/* Where the identities hold: "Omega > 0, psi any angle". Text to be freed. */
char *identities_domain(const struct identities *t);

enum result { IDENTITY_HOLDS, IDENTITY_DIFFERS, IDENTITY_UNDECIDED };

struct proof {
    enum result result;
    char *evidence;          /* NULL where all hold; else what does not, and one point as an example  */
    char *difference;        /* the numerator's leading terms as TeX, of what differs; NULL: nothing  */
    bool holds[MOST_SHOWN];  /* equality by equality                                                  */
};

void identities_prove(const struct identities *t, struct proof *p);

/* How many equalities do not hold, and which do, with no evidence; loose: see symbolic.h. */
int identities_broken(const struct identities *t, bool loose, bool holds[MOST_SHOWN]);
void proof_clear(struct proof *p);

/* Whether two nodes of a program are equal for all values of its inputs, whatever functions mean. */
bool nodes_equal(const struct program *p, int left, int right);

#endif
