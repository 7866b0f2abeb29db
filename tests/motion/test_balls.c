/*
 * What is computed in balls from one line to the next holds both ends of every ball that it begins with, one at a time: a line
 * whose radius is lost holds neither. The ends go the same way with many more bits; what they give is compared elsewhere.
 */
#include "tests/run.h"
#include "tests/paper.h"

#include "motion/motion.h"
#include "motion/two_body.h"
#include "text/scope.h"

enum { MOST = 18, PREC = 64, ENDS_PREC = 256, WIDTH = 36 };

typedef void moved(arb_ptr out, arb_srcptr in, slong prec);

/* (B1) to (B3): the pair in the inverse-square field, one step; in: smallness, c1, c2, shares of mass, places, velocities, radians. */
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
    arb_set(tau, in + 17);
    ck_assert(two_body_move(&b, tau, prec));
    _arb_vec_set(out, b.place, CRAFT * AXES);
    _arb_vec_set(out + 6, b.velocity, CRAFT * AXES);
    two_body_clear(&b);
}

/* (10) and its derivative; in: m1, m2, L_ref and the state of the angles. */
static void coordinates_of_angles(arb_ptr out, arb_srcptr in, slong prec)
{
    FLOW_PARAMETERS(p);
    arb_set(p.m1, in);
    arb_set(p.m2, in + 1);
    arb_set(p.L_ref, in + 2);
    _arb_vec_set(out, in + 3, FLOW_STATE);
    state_from_angles(out, sheet(), &p, prec);
}

static int take(void *context, slong k, const fmpq_t t, arb_srcptr state)
{
    (void)k;
    (void)t;
    _arb_vec_set(context, state, FLOW_STATE);
    return 0;
}

/* Omega, L_ref, C1, C2, of the nonlinear model k_c, m1, m2 as well, and the state; a second of the motion, or one step of it. */
static void one_second(arb_ptr out, bool nonlinear, bool step, arb_srcptr in, slong prec)
{
    FLOW_PARAMETERS(p);
    SCOPE(fmpq, second);
    arb_ptr all[] = {p.Omega, p.L_ref, p.C1, p.C2, p.k_c, p.m1, p.m2};
    const int parameters = nonlinear ? 7 : 4;
    for (int i = 0; i < parameters; i++)
        arb_set(all[i], in + i);
    fmpq_one(second);
    struct flow_request r = {&p, in + parameters, second, 1, 17, prec, take, out, nonlinear, step ? second : NULL, NULL, 0};
    ck_assert_int_eq(flow_run(&r), FLOW_DONE);
}

static void steps_of_the_method(arb_ptr out, arb_srcptr in, slong prec)
{
    one_second(out, true, true, in, prec);
}

static void steps_of_the_linear_method(arb_ptr out, arb_srcptr in, slong prec)
{
    one_second(out, false, true, in, prec);
}

static void linear_motions(arb_ptr out, arb_srcptr in, slong prec)
{
    one_second(out, false, false, in, prec);
}

/* (7), (18), (13), (14) and (21); in: as for a step */
static void charges_of_a_state(arb_ptr out, arb_srcptr in, slong prec)
{
    FLOW_PARAMETERS(p);
    arb_ptr all[] = {p.Omega, p.L_ref, p.C1, p.C2, p.k_c, p.m1, p.m2};
    for (int i = 0; i < 7; i++)
        arb_set(all[i], in + i);
    charges_of_state(out, out + 2, sheet(), &p, in + 7, prec);
}

static const struct {
    const char *terms;
    moved *move;
    int inputs, outputs;
    double in[MOST];
} moves[] = {
    {"B1 to B3", pair_in_the_inverse_square_field, 18, 12,
     {0.125, 10, 2, 0.25, 0.75, 0.5, 0.25, 0.125, -0.5, -0.125, -0.25, 0.0625, -0.0625, 0.125, 0.03125, -0.0625, -0.125, 0x1p-5}},
    /* p steers alone: places near (1, 0, 0)/s, where it is large, and a step as long as is proved there */
    {"B1 to B3", pair_in_the_inverse_square_field, 18, 12,
     {0.5, 0.125, 0.125, 0.5, 0.5, -0.875, 0.5, 0.25, 0.75, -0.75, -0.5, 0.0625, -0.0625, 0.125, 0.03125, -0.0625, -0.125, 0.1875}},
    {"R1 to R3", steps_of_the_method, 13, 6, {1, 2, 10, 8, 1, 1, 1, 1, 0.5, 0.25, 0.5, -0.25, 0.125}},
    /* r near 1, where c1 (r - 1) alone varies */
    {"R1 to R3", steps_of_the_method, 13, 6, {0x1p-4, 2, 2, 0x1p-7, 1, 1, 1, 0.75, 0.5, 0.4375, 0, 0, 0}},
    {"R1 to R3", steps_of_the_method, 13, 6, {1, 2, 0.125, 0.125, 1, 1, 1, 0.25, 0.25, 0.125, 0.5, -0.25, 0.125}},
    {"R1 to R3", steps_of_the_method, 13, 6, {4, 25, 512, 16, 1, 3, 2, 0.5, 0.25, 100, 0.5, -0.25, 400}},
    {"R1 to R3, linear", steps_of_the_linear_method, 10, 6, {8, 2, 640, 16, 0.5, 0.25, 0.125, 4, -2, 1}},
    {"A1, A2", linear_motions, 10, 6, {1, 8, 10, 3, 0.5, 0.25, 1, 0.25, -0.25, 1}},
    /* pitch from its rate alone at its peak theta'/(2 Omega), where it does not depend on Omega t but on the unit of its rate */
    {"A1, A2", linear_motions, 10, 6, {0x1.921fb54442d18p-1, 8, 10, 3, 0.5, 0, 1, 0.25, -0.25, 1}},
    {"charges", charges_of_a_state, 13, 3, {0.0625, 10, 0.03125, 0.125, 8e9, 150, 100, 4, 0.5, 0.25, 0x1p-6, -0x1p-7, 0x1p-6}},
    {"(10)", coordinates_of_angles, 9, 6, {150, 100, 25, 0.5, 0.25, 1, 0x1p-12, -0x1p-13, 0x1p-6}},
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
            ck_assert_msg(arb_contains(held + i, end + i), "%s: row %d, input %d, output %d", moves[move].terms, move, wide, i);
    }
}
