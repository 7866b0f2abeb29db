/*
 * The nonlinear flow of whole sets of initial states and parameters: Taylor models (model.h) of the states in the unknowns that
 * are given within bounds, and what they are off carried by a Lohner set (lohner.h).
 */
#ifndef CT_FLOW_SET_H
#define CT_FLOW_SET_H

#include "motion/flow.h"
#include "motion/model.h"
#include "motion/taylor.h"

/*
 * x y z u v w, then the closed loop's constants that a set may have bounds of: k lambda^2 c1, k lambda^2 c2, lambda, 3 k lambda^3;
 * and what R/q is multiplied by to make the charge product
 */
enum { SET_CHARGE = FLOW_STATE + 4, SET_MODELS, SET_BOUNDS = FLOW_STATE + 1 /* of the coordinates and the charge product */ };

enum { MOST_THREADS = 16 };

struct flow_set {
    struct space space, linear; /* of the states, and of degree 1 for the derivatives */
    struct model *model;        /* SET_MODELS, in units of taylor.h                   */
    arb_t Omega, unit, charge;  /* of lengths, m, and of the charge product, C^2       */
    int most_pieces;            /* into which the set may be split: 1 for none         */
    int threads;                /* that follow them, as many as there are processors: the rows are the same however many */
    bool charged;               /* it ends at the first row at which Q_ref + dQ may be >= 0 */
    struct flow_steps how;      /* orders and step, where a test sets them             */
};

void flow_set_init(struct flow_set *s, int variables, int degree);
void flow_set_clear(struct flow_set *s);

/*
 * The receiver gets, as time goes on, a ball of each coordinate, in SI, and of Q_ref + dQ (0 if the set is not charged), that holds
 * it for all of the set. `reached` gets the time in seconds up to which the motion was proved.
 */
enum flow_status flow_set(const struct flow_set *s, const fmpq *times, slong count, flow_receiver *receive, void *context,
                          double *reached);

#endif
