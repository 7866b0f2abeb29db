/*
 * Identities: equalities between formulas over free quantities, and their proof by normal forms (symbolic.h).
 *
 * The steps of derivations.yaml and the claims of claims.yaml state them alike: a mapping says what is free and what is
 * defined (angles, positive, free, small, order, rates, let, "square roots"), a list what is equal.
 */
#ifndef CT_IDENTITIES_H
#define CT_IDENTITIES_H

#include "formula/typeset.h"
#include "proof/alteration.h"
#include "sheet/sheet.h"
#include "text/tree.h"

enum { SIGN_NEGATIVE = 1, SIGN_ZERO = 2, SIGN_POSITIVE = 4, SIGN_ANY = 7 }; /* sets of signs */
enum { MOST_SHOWN = 32 };

/* A free quantity: its signs, and what else is said of it. */
struct variable {
    int signs;
    bool angle, quarter_turn;
    int power; /* it is multiplied by epsilon^power */
};

struct equality {
    char *text;
    const struct yaml *at;
    size_t offset; /* where it stands in that text: of a = b = c, b = c is the second */
    int left, right;
};

/* What a square root is said to be equal to: to be proved positive. */
struct root {
    const char *text;
    const struct yaml *at;
    int node;
};

/* What a formula takes of the sheet or of the definitions: an output, a named subexpression, a side of a relation. */
struct use {
    const struct section *section;
    const struct formulas *formulas; /* the section's, as printed too, or a relation's */
    int part;                        /* the node in that program    */
    int node;                        /* what it became          */
    int *copy;                       /* what each node of that program became */
};

/* Principles and properties: sections that have formulas, but no equation number. */
struct definitions {
    struct section *sections;
    struct quantity (*outputs)[MOST_OUTPUTS]; /* what the sections' outputs point to */
    int count;
};

/* What the names of formulas may stand for, and where they are written. */
struct scope {
    const struct sheet *sheet;
    const struct definitions *definitions;
    const struct yaml *given;              /* the mapping; NULL: everything is free   */
    const struct yaml *shared;             /* of what it does not say; then not all need serve here. NULL: none */
    const char *const *names;              /* further free names                      */
    int name_count;
    const struct alteration *altered;      /* what is made of formulas that are taken; NULL: nothing */
};

struct identities {
    struct scope scope;         /* of which they are read, */
    const struct yaml *show;    /* and what they show      */
    struct program program;
    struct variable *variables; /* of its inputs */
    struct equality *shown;
    struct root *roots;
    struct use *uses;
    int shown_count, root_count, use_count;
    int last_rate;              /* the node that the last rate() became */
    int order;                  /* the highest power of epsilon that is compared; -1: exact */
    int sheet_inputs;           /* of its inputs: those that are the sheet's, before those of its own */
    struct tex lets;            /* ", C2 = 0": quantities of the sheet that are bound to a formula of their own */
    char *needed;               /* needed[i]: something shown rests on node i */
};

/* NULL: there is none of that id; nor in the sheet. */
const struct section *definition_find(const struct definitions *d, const char *id);
const struct section *section_or_definition(const struct sheet *sheet, const struct definitions *d, const char *id);

/* The relation of that number, the first, second ... ("1", "2" ...) of them; NULL when there is none. */
const struct relation *relation_find(const struct sheet *sheet, const char *number, const char *index,
                                     const struct section **section);

/* Of an open scope, a formula each: its node, -1 after a complaint. */
bool identities_open(struct identities *t, const struct scope *s);
int identities_formula(struct identities *t, const struct yaml *node);

/*
 * What they show, a = b or a = b = c, or a list or mapping of such, after which the scope is closed: what is declared and defined
 * serves something, and square roots are where they are needed. False after a complaint.
 */
bool identities_show(struct identities *t, const struct yaml *show);
void identities_clear(struct identities *t);

/* The first, second ... text of a list, or the one text that stands for a list; NULL: there is no further one. */
const struct yaml *text_at(const struct yaml *node, int i);

/* The same identities read once more, with formulas that are altered, but for their square roots. */
void identities_alter(struct identities *altered, const struct identities *t, const struct alteration *a);

/* Whether a name is a free one that the sheet does not have. */
bool is_free_name(const struct identities *t, const char *name);

/* The next of these signs outside brackets, or the end of the text; whether two texts are the same but for blanks. */
const char *side_end(const char *text, const char *signs);
bool same_text(const char *a, const char *a_end, const char *b);

/* The keys of the mapping, for a table of fields that has others too. */
#define IDENTITIES_FIELDS \
    {.key = "free"}, {.key = "positive"}, {.key = "angles"}, {.key = "quarter turns"}, {.key = "small"}, \
    {.key = "order"}, {.key = "rates"}, {.key = "square roots"}

/* The node of a formula that stands `shift` characters into a scalar; -1 after a complaint. */
int identities_text(struct identities *t, const struct yaml *node, const char *text, size_t shift);

/* Where the identities hold: "Omega > 0, psi any angle". Text to be freed. */
char *identities_domain(const struct identities *t);

enum result { IDENTITY_HOLDS, IDENTITY_DIFFERS, IDENTITY_UNDECIDED };

struct proof {
    enum result result;
    char *evidence;          /* NULL where all hold; else what does not, and one point as an example  */
    const struct yaml *at;   /* where that stands */
    size_t offset;
};

void identities_prove(const struct identities *t, struct proof *p);

/* The first equality that holds whatever the formulas of the sheet are, NULL: none does. (binding.c) */
const struct equality *identities_tautology(const struct identities *t);

void proof_clear(struct proof *p);

/* ---- at work ---- */

/* The values and signs of nodes, in a field of normal forms of their own: worked out when they are first asked for. */
struct run {
    const struct identities *t;
    struct known *nodes;
    int count;         /* of nodes                                    */
    int *input;        /* that a variable is                          */
    slong variables, terms;
    bool at_point;     /* every variable is a prime, where nothing happens to vanish */
};

enum manner { RUN_STRICT, RUN_LOOSE, RUN_AT_POINT }; /* strict and loose: see symbolic.h; at a point it is loose, too */

/* To this many terms. An INPUT that is appended to the program is a further variable, by its exponent, or where its number
   is one an angle; there are `more` of them. */
void run_begin(struct run *r, const struct identities *t, slong terms, enum manner manner, slong more);
void run_end(struct run *r);

/* From now on of these nodes: the same identities, altered. What is a square root stays one. */
void run_turn_to(struct run *r, const struct identities *altered);

/* A node becomes a square root, if it is proved to be positive. */
bool run_root(struct run *r, int node);

/* How two nodes compare. What has no value anywhere differs: an angle where a number is due, a pole that is none of the point alone. */
enum result run_compare(struct run *r, int left, int right);

#endif
