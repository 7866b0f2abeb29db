/*
 * A motion of the pair as a user asks for it: the paper's simulation, with some values replaced.
 * What is derived from the given values (gains from n, the Cartesian state from the angles, the
 * charges) goes through the sheet's own formulas in balls and is not rounded in between.
 */
#ifndef CT_MOTION_H
#define CT_MOTION_H

#include "motion/flow.h"
#include "sheet/input.h"

enum scenario_name {
    SET_m1, SET_m2, SET_L_ref, SET_k_c, SET_Omega, SET_n, SET_C1, SET_C2,
    SET_psi, SET_theta, SET_dL, SET_psi_dot, SET_theta_dot, SET_dL_dot,
    SET_x1, SET_y1, SET_z1, SET_x1_dot, SET_y1_dot, SET_z1_dot,
    SCENARIO_VALUES
};

struct scenario {
    const struct sheet *sheet;
    struct input value[SCENARIO_VALUES];
    bool given[SCENARIO_VALUES];      /* replaced by the user */
    fmpq radius[SCENARIO_VALUES]; /* of a set: how far from its value each may be, >= 0 */
    bool exact;                  /* defaults are the decimals themselves, not the nearest binary64 */
};

extern const char *const scenario_names[SCENARIO_VALUES];

/* The sheet's values: Table 1, n = 10, the initial attitude and length error. */
void scenario_init(struct scenario *s, const struct sheet *sheet, bool exact);
void scenario_clear(struct scenario *s);

/* False, and why, where a value, or one within its radius, lies outside its domain. Wrong combinations are the caller's business. */
bool scenario_valid(const struct scenario *s, bool nonlinear, struct message *why);

/*
 * What a flow is given: the parameters, the gains by n where they are not given, and psi theta dL and their rates, or the state
 * in the Hill frame. Nothing is rounded in between.
 */
void scenario_parameters(struct flow_parameters *p, const struct scenario *s, slong prec);
void scenario_initial(arb_ptr initial, const struct scenario *s, const struct flow_parameters *p, bool nonlinear, slong prec);

/* What no enclosure can see: of x1 ... z1_dot, side by side, x1 = +-L_ref m2/(m1 + m2) alone is not 0: the pair rests there for ever. */
bool is_static(const fmpq_t m1, const fmpq_t m2, const fmpq_t L_ref, const struct input *state);

/* psi theta dL and their rates become position and velocity of craft 1: Eq. (10) and its exact derivative. */
void state_from_angles(arb_ptr state, const struct sheet *sheet, const struct flow_parameters *p, slong prec);

/* q1 and q2 of a nonlinear motion's state, and Q_ref + dQ */
void charges_of_state(arb_ptr q, arb_t product, const struct sheet *sheet, const struct flow_parameters *p, arb_srcptr state,
                      slong prec);

/* A row holds the state, and for a nonlinear motion q1 and q2 after it. */
enum { ROW_NUMBERS = FLOW_STATE + 2 };

/* Takes a row, every digit of it proved; non-zero stops the motion. */
typedef int row_receiver(void *context, slong k, const fmpq_t t, char *const *numbers);

struct motion {
    const struct scenario *scenario;
    bool nonlinear, charges;  /* q1 and q2 too, */
    bool microcoulomb;        /* ... in this unit */
    bool small_angles;        /* a linear motion's x1 y1 z1 through eq10lin, in place of the angles */
    const fmpq *h;            /* the classical Runge-Kutta method's step, NULL for the motion itself */
    int most_pieces;          /* > 0: a set of nonlinear motions, see flow_set.h */
    slong digits;
};

/* A set's rows are bounds of all its motions, two numbers each of x1 ... z1_dot, q1 and q2, rounded outward. */
enum { SET_NUMBERS = 2 * ROW_NUMBERS };
bool may_have_radius(enum scenario_name name); /* k_c's is the force's alone: the law has its middle */

/* Rows at all those times (of one sign, away from 0); 0, or -1 with the reason. */
int motion_rows(const struct motion *m, const fmpq *times, slong count, row_receiver *receive,
                void *context, struct message *why);
enum flow_status motion_set_rows(const struct motion *m, const fmpq *times, slong count, row_receiver *receive, void *context,
                                 double *reached);

#endif
