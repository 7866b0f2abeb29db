/*
 * verify/claims/guarantee.h, by another road: the energy in Cartesian coordinates at random points of the box, and motions
 * of the pair with its errors by a plain Runge-Kutta method, in doubles: what is borne, and what is lost just beyond.
 * Units: see guarantee.h.
 */
#include <math.h>
#include <string.h>

#include "tests/claims/balls.h"
#include "tests/run.h"
#include "claims/curve.h"
#include "claims/guarantee.h"
#include "claims/second_order.h"
#include "tests/paper.h"
#include "motion/flow.h"

enum { PREC = 192 };

static arb_srcptr numbers(double n, double y)
{
    static arb_ptr values;
    SCOPE(arb, gain, length);
    if (values == NULL)
        values = _arb_vec_init(GUARANTEES);
    arb_set_d(gain, n);
    arb_set_d(length, y);
    ck_assert(guarantees_enclose(values, NULL, gain, gain, y > 0 ? length : NULL, PREC));
    return values;
}

static double number(const char *name, double n, double y)
{
    arb_srcptr z = numbers(n, y) + guarantee_find(name);
    ck_assert_msg(arb_rel_accuracy_bits(z) > 40, "%s at n = %g is open", name, n);
    return arf_get_d(arb_midref(z), ARF_RND_NEAR);
}

/* ---- boxes ---- */

static double energy(double n, const double x[6])
{
    const double r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    const double square = x[3] * x[3] + x[4] * x[4] + x[5] * x[5] - 3 * x[0] * x[0] + x[2] * x[2];
    return square / 2 + (n - 3) / r + n * log(r);
}

/* At psi, theta, dL/L_ref and their rates, which turn the vector of the craft about two axes. */
static void place(double x[6], const double s[6])
{
    const double r = 1 + s[2], c = cos(s[1]), d = sin(s[1]);
    const double out = s[5] * c - r * d * s[4], across = r * c * s[3];
    x[0] = r * c * cos(s[0]);
    x[1] = r * c * sin(s[0]);
    x[2] = -r * d;
    x[3] = out * cos(s[0]) - across * sin(s[0]);
    x[4] = out * sin(s[0]) + across * cos(s[0]);
    x[5] = -s[5] * d - r * c * s[4];
}

static unsigned long long state = 1;

static double random_unit(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) * 0x1p-53;
}

/* Below the level in all of the box, and no more so in one a hundredth larger. */
EACH(box_is_the_largest, 6)
{
    static const double gains[] = {9.5, 10, 12, 20, 23, 40};
    const double n = gains[_i], box = number("box", n, 0), level = number("level", n, 0);
    double most = -INFINITY, beyond = -INFINITY, s[6], x[6];
    for (int k = 0; k < 20000; k++) {
        for (int i = 0; i < 6; i++) { /* its corners, edges and faces too */
            const double u = 4 * random_unit() - 2;
            s[i] = box * (u > 1 ? 1 : u < -1 ? -1 : u);
        }
        place(x, s);
        most = fmax(most, energy(n, x));
        for (int i = 0; i < 6; i++)
            s[i] *= 1.01;
        place(x, s);
        beyond = fmax(beyond, energy(n, x));
    }
    ck_assert_double_lt(most, level + 1e-12); /* a hundred roundings of E, which is below 64 */
    ck_assert_double_gt(beyond, level);
}

/* Each alone: at the level there, and the other coordinates at rest. */
EACH(half_widths_reach_the_level, 6)
{
    static const char *const names[] = {"yaw", "pitch", "length", "angle_rate", "angle_rate", "length_rate"};
    static const double gains[] = {9.5, 10, 12, 20, 23, 40};
    const double n = gains[_i], level = number("level", n, 0);
    double hill = -INFINITY, pass = INFINITY;
    for (int k = 3000; k < 40000; k++) { /* the hill on the radius, the pass on the plane across; flat within 1e-4 of either */
        const double r = 1e-4 * k;
        hill = fmax(hill, r > 1 ? energy(n, (const double[6]){r}) : hill);
        pass = fmin(pass, energy(n, (const double[6]){0, r}));
    }
    ck_assert_double_eq_tol(level, fmin(hill, pass), 1e-6);
    ck_assert_double_eq_tol(energy(n, (const double[6]){number("shortest", n, 0)}), level, 1e-12);
    ck_assert_double_eq_tol(energy(n, (const double[6]){number("longest", n, 0)}), level, 1e-12);
    for (int i = 0; i < 6; i++) {
        double s[6] = {0}, x[6], most = -INFINITY;
        for (int side = -1; side <= 1; side += 2) {
            s[i] = side * number(names[i], n, 0);
            place(x, s);
            most = fmax(most, energy(n, x));
        }
        ck_assert_msg(fabs(most - level) < 1e-12, "%s at n = %g", names[i], n);
    }
}

static int take_last(void *context, slong k, const fmpq_t t, arb_srcptr at)
{
    (void)k;
    (void)t;
    _arb_vec_set(context, at, FLOW_STATE);
    return 0;
}

/* A certified motion of unequal masses from next to a corner of the box: 60 radians later yaw and length are at rest. */
TEST(corner_comes_back)
{
    FLOW_PARAMETERS(p);
    VECTOR(arb, at, FLOW_STATE);
    SCOPE(arb, r, square);
    double s[6], x[6];
    SCOPE(fmpq, t);
    fmpq_set_si(t, 60, 1);
    for (int i = 0; i < 6; i++)
        s[i] = 0.999 * number("box", 12, 0);
    place(x, s);
    arb_one(p.Omega);
    arb_one(p.k_c);
    arb_one(p.m1);
    arb_set_ui(p.m2, 3);
    arb_one(p.L_ref);
    arb_set_ui(p.C1, 12);
    arb_set_ui(p.C2, 4);
    for (int i = 0; i < FLOW_STATE; i++)
        arb_set_d(at + i, 0.75 * x[i]); /* craft 1 is at m2/(m1 + m2) of the distance */
    ck_assert_int_eq(flow_run(&(struct flow_request){&p, at, t, 1, 8, 128, take_last, at, true, NULL, NULL, 0}), FLOW_DONE);
    arb_dot(square, NULL, 0, at, 1, at, 1, 3, PREC);
    arb_sqrt(r, square, PREC);
    arb_mul_ui(r, r, 4, PREC);
    arb_div_ui(r, r, 3, PREC);
    ck_assert(is_above(r, 0.99) && is_below(r, 1.01) && is_above(at, 0.74));
}

/* ---- errors that stay ---- */

struct pair {
    double n, c2, factor, screen, push[2], most; /* most: S, the charge product's bound; and none below zero */
};

static void rates(double d[6], const struct pair *p, double part, const double x[6])
{
    const double r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    const double r_dot = (x[0] * x[3] + x[1] * x[4] + x[2] * x[5]) / r;
    const double u = part * p->screen * r, loss = (1 + u) * exp(-u) * (1 + part * p->factor);
    const double command = 3 + p->n * (r - 1) + p->c2 * r_dot;
    const double force = loss * (p->most > 0 ? fmax(0, fmin(p->most, command)) : command) / (r * r * r);
    d[0] = x[3];
    d[1] = x[4];
    d[2] = x[5];
    d[3] = 2 * x[4] + 3 * x[0] - force * x[0] + part * p->push[0];
    d[4] = -2 * x[3] - force * x[1] + part * p->push[1];
    d[5] = -x[2] - force * x[2];
}

/* From 0 to 1, gently at both ends. */
static double grown(double t)
{
    return t < 1 ? t * t * (3 - 2 * t) : 1;
}

/* Whether the pair, with errors that grow to their size in `ramp` radians, is still at a length near L_ref 300 radians later. */
static bool is_borne(const struct pair *p, double ramp, const double start[6])
{
    static const double h = 0.02, weights[] = {0, 0.5, 0.5, 1};
    double x[6];
    memcpy(x, start, sizeof x);
    for (int step = 0; step * h < ramp + 300; step++) {
        double k[5][6] = {{0}}, at[6];
        for (int stage = 0; stage < 4; stage++) {
            for (int i = 0; i < 6; i++)
                at[i] = x[i] + h * weights[stage] * k[stage][i];
            rates(k[stage + 1], p, grown(ramp > 0 ? step * h / ramp : 1), at);
        }
        for (int i = 0; i < 6; i++)
            x[i] += h / 6 * (k[1][i] + 2 * k[2][i] + 2 * k[3][i] + k[4][i]);
        const double r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (!(r > 0.2 && r < 5 && x[0] > 0))
            return false;
    }
    return true;
}

/* The error at `part` of what is borne. */
static struct pair with_error(const char *name, double n, double c2, double part)
{
    struct pair p = {.n = n, .c2 = c2};
    const double value = part * number(name, n, 0);
    if (strncmp(name, "deficit", 7) == 0)
        p.factor = -value;
    else if (strncmp(name, "excess", 6) == 0)
        p.factor = value;
    else if (strcmp(name, "debye") == 0)
        p.screen = part * part / value;
    else
        p.push[strncmp(name, "along", 5) == 0] = strncmp(name, "inward", 6) == 0 ? -value : value;
    return p;
}

static const double gain_pairs[][2] = {{10, 2}, {12, 4}, {25, 8}};

/* It grows slowly: a hundredth below the fold the pair follows, a hundredth above it is lost. */
EACH(errors_are_borne_up_to_the_fold, 15)
{
    static const char *const names[] = {"deficit", "debye", "outward", "inward", "along"};
    const double start[] = {1, 1e-4, 1e-4, 0, 0, 0}; /* off the symmetry that a push keeps */
    const char *name = names[_i % 5];
    const double n = gain_pairs[_i / 5][0], c2 = gain_pairs[_i / 5][1];
    struct pair below = with_error(name, n, c2, 0.99), above = with_error(name, n, c2, 1.01);
    ck_assert_msg(is_borne(&below, 1000, start), "%s at n = %g", name, n);
    ck_assert_msg(!is_borne(&above, 1000, start), "%s at n = %g", name, n);
}

EACH(steps_are_borne, 15)
{
    static const char *const names[] = {"deficit_step", "excess_step", "outward_step", "inward_step", "along_step"};
    const double start[] = {1, 0, 0, 0, 0, 0};
    const char *name = names[_i % 5];
    const double n = gain_pairs[_i / 5][0];
    struct pair p = with_error(name, n, 0.01, 0.999); /* hardly damped */
    ck_assert_msg(is_borne(&p, 0, start), "%s at n = %g", name, n);
}

/* Charges bounded to what holds 1.05 L_ref, and of one sign: from next to the corner of the box that is left. */
EACH(bounded_charges_bring_back, 3)
{
    const double n = gain_pairs[_i][0];
    struct pair p = {.n = n, .c2 = gain_pairs[_i][1], .most = 3 * pow(1.05, 3)};
    double s[6], x[6];
    for (int i = 0; i < 6; i++)
        s[i] = 0.999 * number("box", n, 1.05);
    place(x, s);
    ck_assert(is_borne(&p, 0, x));
    ck_assert_double_lt(number("box", n, 1.05), number("box", n, 0));
    ck_assert_double_eq_tol(number("held", n, 1.05), 1.05, 1e-12); /* nothing of that bound is spare */
    ck_assert(arb_is_finite(numbers(n, 1 + 0x1p-40) + guarantee_find("longest"))); /* a doubled root at the end is still enclosed */
}

TEST(outside_the_domain_nothing_is_said)
{
    VECTOR(arb, values, GUARANTEES);
    SCOPE(arb, n, y);
    arb_set_ui(n, 9);
    ck_assert(!guarantees_enclose(values, NULL, n, n, NULL, PREC) && !arb_is_finite(values));
    arb_indeterminate(n);
    ck_assert(!guarantees_enclose(values, NULL, n, n, NULL, PREC) && !arb_is_finite(values));
    arb_set_ui(n, 10);
    arb_one(y);
    ck_assert(!guarantees_enclose(values, NULL, n, n, y, PREC) && !arb_is_finite(values));
    arb_zero(y);
    ck_assert(!guarantees_enclose(values, NULL, n, y, NULL, PREC) && !arb_is_finite(values));
    arb_add_error_2exp_si(y, 0); /* which gains of either sign are in */
    ck_assert(!guarantees_enclose(values, NULL, n, y, NULL, PREC) && !arb_is_finite(values));
    ck_assert_int_eq(guarantee_find("nothing"), -1);
    ck_assert_int_eq(guarantee_find(guarantees[GUARANTEES - 1].name), GUARANTEES - 1);
    ck_assert_ptr_null(guarantees[GUARANTEES].name);
    arb_set_d(n, 9 + 0x1p-40); /* so near that the doubled root leaves digits open: no wrong sign is guessed */
    ck_assert(guarantees_enclose(values, NULL, n, n, NULL, 64));
    ck_assert(arb_is_finite(values + guarantee_find("delay")) && !arb_is_finite(values + guarantee_find("box")));
    arb_set_d(n, 10); /* of some of these n the depth, 0.0018 at 10, may be none: no root is seen at the lower end, whatever the other */
    mag_set_d(arb_radref(n), 0.05);
    ck_assert(guarantees_enclose(values, NULL, n, n, NULL, PREC));
    ck_assert(arb_is_finite(values + guarantee_find("widest")) && !arb_is_finite(values + guarantee_find("longer")));
    arb_set_d(n, 10.58); /* nor here, where the sign at the upper end is known */
    mag_set_d(arb_radref(n), 0.01);
    ck_assert(guarantees_enclose(values, NULL, n, n, NULL, PREC));
    ck_assert(arb_is_finite(values + guarantee_find("widest")) && !arb_is_finite(values + guarantee_find("shorter")));
}

/* ---- what is proved of all values of a ball ---- */

/* What there is of gains, and what is made of it. */
enum { GAIN_1, GAIN_2, AWAY, LATE, SWING, BOUND, GIVEN };
enum { NUMBERS = GUARANTEES + 2 * 9 + 11 };

/* The guarantees; what the law makes of a pitch of 1/8 + away after 3 + late. */
static void of_gains(arb_ptr z, arb_srcptr in, bool bounded, slong prec)
{
    static const char *const names[] = {"A_re", "A_im", "B_re", "decay", "shift", "S_re", "S_im"};
    struct second_order o;
    struct moved_loop loop;
    VECTOR(arb, turned, FLOW_STATE);
    SCOPE(arb, a, tau);
    guarantees_enclose(z, steps(), in + GAIN_1, in + GAIN_2, bounded ? in + BOUND : NULL, prec);
    z += GUARANTEES;
    arb_set_d(a, 0.125);
    arb_add(a, a, in + AWAY, prec);
    arb_add_ui(tau, in + LATE, 3, prec);
    second_order_init(&o, steps(), in + GAIN_1, in + GAIN_2, prec);
    for (int swings = 0; swings < 2; swings++, z += COUNT(names) + 2) {
        for (int i = 0; i < COUNT(names); i++)
            arb_set(z + i, second_order_get(&o, names[i]));
        slow_law(z + COUNT(names), z + COUNT(names) + 1, &o, a, tau);
        second_order_swing(&o, in + SWING, a); /* which says all of S */
    }
    second_order_after(z, &o, a, tau);
    moved_reference(z + 6, &o, z);
    moved_loop_init(&loop, &o);
    _arb_vec_set(z + 7, loop.constants, 3);
    moved_loop_clear(&loop);
    arb_one(second_order_get(&o, "S_re")); /* the same whatever the start: what pitch alone makes of it */
    arb_zero(second_order_get(&o, "S_im"));
    arb_set(turned + THETA, z + THETA);
    moved_reference(z + 10, &o, turned);
    second_order_clear(&o);
}

static void set_given(arb_ptr in, int gains)
{
    static const double all[][GIVEN] = {{40, 11.1, 0, 0, 1, 1.25}, {12.5, 3.75, 0, 0, 0.75, 1.2}};
    for (int i = 0; i < GIVEN; i++)
        arb_set_d(in + i, all[gains][i]);
}

/* Each as a ball by itself, and all of them: what comes of it holds what comes of its ends, which have more bits. */
EACH(numbers_of_balls_hold_those_of_their_ends, 2 * (GIVEN + 1))
{
    static const double radius[] = {0x1p-10, 0x1p-40};
    const int gains = _i % 2, which = _i / 2;
    VECTOR(arb, in, GIVEN);
    for (int k = 0; k < 2; k++) {
        VECTOR(arb, wide, NUMBERS);
        VECTOR(arb, sharp, NUMBERS);
        set_given(in, gains);
        for (int i = 0; i < GIVEN; i++)
            if (which == GIVEN || which == i)
                mag_set_d(arb_radref(in + i), radius[k]);
        of_gains(wide, in, gains > 0, which == GIVEN ? 64 : PREC);
        for (int i = 0; i < NUMBERS && k == 1; i++)
            ck_assert_msg(arb_is_finite(wide + i), "number %d", i);
        for (int end = -1; end <= 1; end += 2) {
            SCOPE(arb, away);
            set_given(in, gains);
            arb_set_d(away, end * radius[k]);
            for (int i = 0; i < GIVEN; i++)
                if (which == GIVEN || which == i)
                    arb_add(in + i, in + i, away, PREC);
            of_gains(sharp, in, gains > 0, PREC);
            for (int i = 0; i < NUMBERS; i++)
                ck_assert_msg(arb_contains(wide + i, sharp + i) || !arb_is_finite(wide + i), "number %d", i);
        }
    }
}

/* Of exact gains at few bits, where roundings are the only error. */
TEST(numbers_of_few_bits_hold_those_of_many)
{
    static const double gains[] = {9.75, 10.3, 12, 17.1, 31};
    VECTOR(arb, few, NUMBERS);
    VECTOR(arb, many, NUMBERS);
    VECTOR(arb, in, GIVEN);
    int found = 0, asked = 0;
    for (int k = 0; k < 8 * COUNT(gains); k++) {
        set_given(in, 1);
        arb_set_d(in + GAIN_1, gains[k / 8]);
        arb_set_d(in + GAIN_2, 0.3 * gains[k / 8]);
        of_gains(few, in, k % 2, 20 + 4 * (k % 8));
        of_gains(many, in, k % 2, PREC);
        for (int i = 0; i < NUMBERS; i++, asked++) {
            ck_assert_msg(!arb_is_finite(few + i) || arb_contains(few + i, many + i), "number %d at n = %g", i, gains[k / 8]);
            found += arb_is_finite(few + i);
        }
    }
    ck_assert_int_gt(found, asked / 2);
}

/* ---- the error terms of narrow_root, curve.c ---- */

/* a x + b x^2 - c, with balls for a, b and c */
struct parabola {
    arb_t a, b, c;
};

static int parabola_at(arb_ptr out, const arb_t x, void *of, slong order, slong prec)
{
    const struct parabola *p = of;
    SCOPE(arb, part);
    arb_mul(part, p->b, x, prec);
    arb_add(out, p->a, part, prec);
    arb_mul(out, out, x, prec);
    arb_sub(out, out, p->c, prec);
    if (order > 1) {
        arb_mul_2exp_si(part, part, 1);
        arb_add(out + 1, p->a, part, prec);
    }
    return 0;
}

/* The root of a x + b x^2 = c on [0, 4], at the ends of each ball: a = 1 +- r, b = s, c = 2 +- t. */
static const struct {
    const char *name;
    double r, s, t;
    slong prec;
} narrowings[] = {
    {"N1_the_value_has_a_radius", 0, 0, 0.25, 53},      {"N1_and_few_bits", 0, 0.3, 0, 8},
    {"N2_the_slope_has_a_radius", 0.125, 0, 0, 53},     {"N2_and_varies_over_the_interval", 0, 2, 0, 12},
    {"N3_the_side_is_found_where_the_slope_is_open", 0, -0.125, 0, 53}, {"all", 0.0625, 0.5, 0.0625, 20},
};

EACH(a_narrowed_root_holds_those_of_all_values, COUNT(narrowings))
{
    struct parabola p;
    SCOPE(arb, root, exact);
    arb_init(p.a);
    arb_init(p.b);
    arb_init(p.c);
    arb_set_ui(p.a, 1);
    mag_set_d(arb_radref(p.a), narrowings[_i].r);
    arb_set_d(p.b, narrowings[_i].s);
    arb_set_ui(p.c, 2);
    mag_set_d(arb_radref(p.c), narrowings[_i].t);
    arb_set_ui(root, 2);
    mag_set_ui(arb_radref(root), 2);
    narrow_root(root, parabola_at, &p, narrowings[_i].prec);
    for (int corner = 0; corner < 4; corner++) {
        const double a = 1 + (corner & 1 ? 1 : -1) * narrowings[_i].r, b = narrowings[_i].s;
        const double c = 2 + (corner & 2 ? 1 : -1) * narrowings[_i].t;
        arb_set_d(exact, a * a + 4 * b * c); /* exact, and so is 2 c */
        arb_sqrt(exact, exact, PREC);
        SCOPE(arb, part);
        arb_set_d(part, a);
        arb_add(exact, exact, part, PREC);
        arb_set_d(part, 2 * c);
        arb_div(exact, part, exact, PREC);
        ck_assert_msg(arb_contains(root, exact), "%s", narrowings[_i].name);
    }
    ck_assert_msg(mag_cmp_2exp_si(arb_radref(root), 0) < 0, "%s", narrowings[_i].name); /* and is narrowed */
    arb_clear(p.a);
    arb_clear(p.b);
    arb_clear(p.c);
}
