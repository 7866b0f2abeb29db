/*
 * What is computed in balls from one line to the next holds both ends of every ball that it begins with, one at a time: a line
 * whose radius is lost holds neither. The ends go the same way with many more bits; what they give is compared elsewhere.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include "motion/motion.h"
#include "motion/two_body.h"
#include "text/scope.h"

enum { MOST = 17, PREC = 64, ENDS_PREC = 256, WIDTH = 24 };

typedef void moved(arb_ptr out, arb_srcptr in, slong prec);

/* The pair in the inverse-square field after the 32nd part of a radian, one step; in: smallness, c1, c2, shares of mass, places, velocities. */
static void pair_in_the_inverse_square_field(arb_ptr out, arb_srcptr in, slong prec)
{
    struct two_body b;
    SCOPE(arb, tau);
    two_body_init(&b);
    arb_set(b.smallness, in);
    arb_set(b.c1, in + 1);
    arb_set(b.c2, in + 2);
    _arb_vec_set(b.mass, in + 3, CRAFT);
    _arb_vec_set(b.place, in + 5, CRAFT * AXES);
    _arb_vec_set(b.velocity, in + 11, CRAFT * AXES);
    arb_set_d(tau, 0x1p-5);
    ck_assert(two_body_move(&b, tau, prec));
    _arb_vec_set(out, b.place, CRAFT * AXES);
    _arb_vec_set(out + 6, b.velocity, CRAFT * AXES);
    two_body_clear(&b);
}

/* (10) and its derivative; in: m1, m2, L_ref and the state of the angles. */
static void coordinates_of_angles(arb_ptr out, arb_srcptr in, slong prec)
{
    struct flow_parameters p;
    flow_parameters_init(&p);
    arb_set(p.m1, in);
    arb_set(p.m2, in + 1);
    arb_set(p.L_ref, in + 2);
    _arb_vec_set(out, in + 3, FLOW_STATE);
    state_from_angles(out, sheet(), &p, prec);
    flow_parameters_clear(&p);
}

static const struct {
    moved *move;
    int inputs, outputs;
    double in[MOST];
} moves[] = {
    {pair_in_the_inverse_square_field, 17, 12,
     {0.125, 10, 2, 0.25, 0.75, 0.5, 0.25, 0.125, -0.5, -0.125, -0.25, 0.0625, -0.0625, 0.125, 0.03125, -0.0625, -0.125}},
    {coordinates_of_angles, 9, 6, {150, 100, 25, 0.5, 0.25, 1, 0x1p-12, -0x1p-13, 0x1p-6}},
};

RANGE(both_ends_of_every_ball_are_held, 0, COUNT(moves) * MOST)
{
    const int move = _i / MOST, wide = _i % MOST;
    if (wide >= moves[move].inputs)
        return;
    VECTOR(arb, in, MOST);
    VECTOR(arb, held, MOST);
    VECTOR(arb, end, MOST);
    for (int i = 0; i < moves[move].inputs; i++)
        arb_set_d(in + i, moves[move].in[i]);
    const double radius = ldexp(fabs(moves[move].in[wide]), -WIDTH);
    mag_set_d(arb_radref(in + wide), radius);
    moves[move].move(held, in, PREC);
    for (int side = -1; side <= 1; side += 2) {
        arb_set_d(in + wide, moves[move].in[wide] + side * radius);
        moves[move].move(end, in, ENDS_PREC);
        for (int i = 0; i < moves[move].outputs; i++)
            ck_assert_msg(arb_contains(held + i, end + i), "move %d, input %d, output %d", move, wide, i);
    }
    flint_cleanup();
}
