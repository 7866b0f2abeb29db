/*
 * verify/motion/lohner.h: a set of states under a map, and a test for every error term of the theorem in lohner.c. In fractions
 * the theorem's two sides can be compared exactly: radius' against the largest |e'_j| that any point of the image has.
 */
#include "tests/run.h"

#include "evaluate/sample.h"
#include "motion/lohner.h"
#include "text/scope.h"

CASE(all, NULL, flint_cleanup)

enum { N = LOHNER_SIZE };

/* ---- what is true, in fractions ---- */

static void basis_of(fmpq_mat_t to, const struct lohner *set)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            fmpq_set_double(fmpq_mat_entry(to, i, j), set->basis[i][j]);
}

/* sum += |a| b */
static void add_modulus(fmpq_t sum, const fmpq_t a, const fmpq_t b)
{
    SCOPE(fmpq, modulus);
    fmpq_abs(modulus, a);
    fmpq_addmul(sum, modulus, b);
}

/* Numbers between -1 and 1 that fill a double, other ones for another k */
static double scattered(int k)
{
    return 2 * fmod(0.6180339887498949 * (k + 1), 1) - 1;
}

/* A set, and a map: where that takes the centre, what it does to the directions, and what it leaves out */
struct map {
    struct lohner set;
    arb_ptr image;
    arb_mat_t derivative;
    mag_ptr error;
};

/* Of a box around 0, whose radii are between one and two of these: none of them where 0 */
static void map_init(struct map *m, double radius)
{
    VECTOR(arb, box, N);
    for (int i = 0; i < N; i++)
        mag_set_d(arb_radref(box + i), radius * (1 + fabs(scattered(i))));
    lohner_init(&m->set);
    lohner_from_box(&m->set, box);
    m->image = _arb_vec_init(N);
    arb_mat_init(m->derivative, N, N);
    m->error = _mag_vec_init(N);
}

static void map_clear(struct map *m)
{
    lohner_clear(&m->set);
    _arb_vec_clear(m->image, N);
    arb_mat_clear(m->derivative);
    _mag_vec_clear(m->error, N);
}

/* The largest |e'_j| of the image: sup |basis'^-1 derivative| radius + |basis'^-1| (ball + error) */
static void largest(fmpq_t sum, int j, const fmpq_mat_t inverse, const struct map *m, mag_srcptr radius)
{
    SCOPE(fmpq, a, b, turned);
    fmpq_zero(sum);
    for (int k = 0; k < N; k++) {
        SCOPE(fmpq, wide);
        fmpq_zero(turned);
        for (int i = 0; i < N; i++) {
            arb_srcptr entry = arb_mat_entry(m->derivative, i, k);
            arf_get_fmpq(a, arb_midref(entry));
            fmpq_addmul(turned, fmpq_mat_entry(inverse, j, i), a);
            mag_get_fmpq(b, arb_radref(entry));
            add_modulus(wide, fmpq_mat_entry(inverse, j, i), b);
        }
        fmpq_abs(turned, turned);
        fmpq_add(turned, turned, wide);
        mag_get_fmpq(b, radius + k);
        fmpq_addmul(sum, turned, b);
        mag_get_fmpq(a, arb_radref(m->image + k));
        mag_get_fmpq(b, m->error + k);
        fmpq_add(a, a, b);
        add_modulus(sum, fmpq_mat_entry(inverse, j, k), a);
    }
}

/* Moves the set; where it can be moved, it holds the image, and a radius is no more than so many times what is needed. */
static bool move_and_compare(struct map *m, slong prec, double at_most)
{
    struct lohner *const set = &m->set;
    VECTOR(mag, before, N);
    MATRIX(fmpq, inverse, N, N);
    SCOPE(fmpq, need, have);
    for (int j = 0; j < N; j++)
        mag_set(before + j, set->radius + j);
    const bool moved = lohner_move(set, m->image, m->derivative, 1, m->error, prec);
    basis_of(inverse, set);
    ck_assert(fmpq_mat_inv(inverse, inverse));
    for (int j = 0; j < N && moved; j++) {
        largest(need, j, inverse, m, before);
        mag_get_fmpq(have, set->radius + j);
        ck_assert_msg(fmpq_cmp(have, need) >= 0, "direction %d: %.12g for %.12g", j, fmpq_get_d(have), fmpq_get_d(need));
        ck_assert_double_le(fmpq_get_d(have), at_most * fmpq_get_d(need) + 1e-300);
        ck_assert(arf_equal(arb_midref(set->centre + j), arb_midref(m->image + j)));
        ck_assert(mag_is_zero(arb_radref(set->centre + j)));
    }
    return moved;
}

/* ---- sets and maps ---- */

/* Every pair of axes turned, by angles of that number */
static void turn(arb_mat_t m, int number)
{
    MATRIX(arb, r, N, N);
    SCOPE(arb, angle);
    arb_mat_one(m);
    for (int i = 0; i < N; i++)
        for (int j = i + 1; j < N; j++) {
            arb_set_d(angle, 3 * scattered(17 * number + N * i + j));
            arb_mat_one(r);
            arb_sin_cos(arb_mat_entry(r, j, i), arb_mat_entry(r, i, i), angle, 53);
            arb_set(arb_mat_entry(r, j, j), arb_mat_entry(r, i, i));
            arb_neg(arb_mat_entry(r, i, j), arb_mat_entry(r, j, i));
            arb_mat_mul(m, m, r, 53);
        }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            mag_zero(arb_radref(arb_mat_entry(m, i, j)));
}

enum { MAPS = 24 };
static const double ROUNDED = 1 + 0x1p-20; /* mag_t has thirty bits, of which sums of six take some */

/* ---- the error terms ---- */

EACH(L1_every_direction_moves, MAPS)
{
    OWNED(map) m;
    map_init(&m, 0.3);
    turn(m.derivative, _i);
    for (int i = 0; i < N; i++) /* sheared too */
        arb_mul_2exp_si(arb_mat_entry(m.derivative, i, _i % N), arb_mat_entry(m.derivative, i, _i % N), 3);
    ck_assert(move_and_compare(&m, LOHNER_BITS, ROUNDED));
}

/* 1 + s_k for each k, and nothing else of the others: twice as far as it was, however many unknowns the derivatives have. */
RANGE(L1_the_part_of_every_unknown_moves, 1, 12)
{
    arb_mat_struct part[12];
    OWNED(map) m;
    map_init(&m, 0);
    for (int i = 0; i <= _i; i++) {
        arb_mat_init(part + i, N, N);
        if (i == 0 || i == _i)
            arb_mat_one(part + i);
    }
    for (int i = 0; i < N; i++)
        mag_one(m.set.radius + i);
    ck_assert(lohner_move(&m.set, m.image, part, _i + 1, m.error, LOHNER_BITS));
    for (int i = 0; i < N; i++)
        ck_assert(mag_cmp_2exp_si(m.set.radius + i, 1) >= 0);
    for (int i = 0; i <= _i; i++)
        arb_mat_clear(part + i);
}

/* A diagonal map leaves the axes: the inverse is exact, the product is rounded to a few bits. */
EACH(L2_the_product_is_rounded, MAPS)
{
    OWNED(map) m;
    map_init(&m, 1);
    for (int i = 0; i < N; i++)
        arb_set_d(arb_mat_entry(m.derivative, i, i), 1 + 0.4 * fabs(scattered(_i * N + i)));
    ck_assert(move_and_compare(&m, 3, 1.5));
}

/* The derivative is a ball, as wide as it is large. */
EACH(L2_the_derivative_is_a_ball, MAPS)
{
    OWNED(map) m;
    map_init(&m, 1);
    turn(m.derivative, _i);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            mag_set_d(arb_radref(arb_mat_entry(m.derivative, i, j)), 0.5 + 0.25 * scattered(i * N + j));
    ck_assert(move_and_compare(&m, LOHNER_BITS, ROUNDED));
}

/* From a point: all there is comes from the image's radius, or from the error. */
static void assert_loose(int number, bool error, slong prec, double at_most)
{
    OWNED(map) m;
    map_init(&m, 0.25); /* which decides the basis; then it is a point */
    turn(m.derivative, number);
    for (int i = 0; i < N; i++) {
        arb_set_d(m.image + i, scattered(i));
        mag_set_d(error ? m.error + i : arb_radref(m.image + i), 1 + fabs(scattered(number + i)));
    }
    for (int i = 0; i < N; i++)
        mag_zero(m.set.radius + i);
    const bool moved = move_and_compare(&m, prec, at_most);
    ck_assert(moved || prec < 8);
}

EACH(L3_the_image_has_a_radius, MAPS)
{
    assert_loose(_i, false, LOHNER_BITS, ROUNDED);
}

EACH(L4_the_map_has_an_error, MAPS)
{
    assert_loose(_i, true, LOHNER_BITS, ROUNDED);
}

/* Along the axes nothing else is rounded than their sum, whose last bits a mag_t cannot hold. */
EACH(L3_L4_radius_and_error_add_up, MAPS)
{
    OWNED(map) m;
    map_init(&m, 0);
    arb_mat_one(m.derivative);
    for (int i = 0; i < N; i++) {
        mag_set_d(arb_radref(m.image + i), 1 + fabs(scattered(_i * N + i)));
        mag_set_d(m.error + i, 0.01 * fabs(scattered(_i * N - i)));
    }
    ck_assert(move_and_compare(&m, LOHNER_BITS, ROUNDED));
}

/* In eight bits the inverse is rounded more than all else, in two it may not be found. */
EACH(L5_the_inverse_is_rounded, MAPS)
{
    assert_loose(_i, true, 8, 5);
}

EACH(L8_a_basis_whose_inverse_is_not_found_is_no_set, MAPS)
{
    assert_loose(_i, true, 2, INFINITY);
}

EACH(L8_a_reach_that_is_not_finite_is_no_set, N)
{
    OWNED(map) m;
    map_init(&m, 1);
    arb_mat_one(m.derivative);
    mag_inf(m.error + _i);
    ck_assert(!lohner_move(&m.set, m.image, m.derivative, 1, m.error, LOHNER_BITS));
}

TEST(L6_a_set_has_the_radii_of_its_box)
{
    OWNED(lohner) set;
    VECTOR(arb, box, N);
    for (int i = 0; i < N; i++) {
        arb_set_d(box + i, 1);
        arb_div_ui(box + i, box + i, (ulong)i + 3, 100); /* a midpoint beyond a double */
        mag_set_d(arb_radref(box + i), i + 1 + fabs(scattered(i)));
    }
    lohner_init(&set);
    lohner_from_box(&set, box);
    for (int i = 0; i < N; i++) {
        ck_assert(mag_cmp(set.radius + i, arb_radref(box + i)) >= 0);
        ck_assert(arf_equal(arb_midref(set.centre + i), arb_midref(box + i)));
        for (int j = 0; j < N; j++)
            ck_assert_double_eq(set.basis[i][j], i == j);
    }
}

/* One direction alone, whose entries no mag_t can hold: rounded down, they would fall short. */
EACH(L7_a_box_has_all_of_its_set, 2 * N)
{
    OWNED(map) m;
    map_init(&m, 0);
    SCOPE(fmpq, need, have, entry);
    VECTOR(arb, box, N);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            m.set.basis[i][j] = scattered(_i * N + i * N + j);
        mag_set_ui(m.set.radius + i, i == _i % N || _i >= N ? 1 : 0);
    }
    lohner_to_box(box, &m.set);
    for (int i = 0; i < N; i++) {
        fmpq_zero(need);
        for (int j = 0; j < N; j++) {
            mag_get_fmpq(have, m.set.radius + j);
            fmpq_set_double(entry, m.set.basis[i][j]);
            add_modulus(need, entry, have);
        }
        mag_get_fmpq(have, arb_radref(box + i));
        ck_assert(fmpq_cmp(have, need) >= 0);
        ck_assert_double_le(fmpq_get_d(have), ROUNDED * fmpq_get_d(need));
    }
}

/* ---- sets that last ---- */

static double number(const arb_t x)
{
    return arf_get_d(arb_midref(x), ARF_RND_NEAR);
}

/* A thousand turns by one radian in each plane (i, i + 3): boxes would grow by 1.38 a turn, to 1e140. */
TEST(a_set_turns_without_growing)
{
    OWNED(map) m;
    map_init(&m, 0);
    VECTOR(arb, box, N);
    MATRIX(arb, turn, N, N);
    SCOPE(arb, angle);
    arb_one(angle);
    for (int i = 0; i < 3; i++) {
        arb_sin_cos(arb_mat_entry(turn, i, i + 3), arb_mat_entry(turn, i, i), angle, 64);
        arb_set(arb_mat_entry(turn, i + 3, i + 3), arb_mat_entry(turn, i, i));
        arb_neg(arb_mat_entry(turn, i + 3, i), arb_mat_entry(turn, i, i + 3));
        mag_set_d(arb_radref(box + i), i + 1);
    }
    lohner_from_box(&m.set, box);
    for (int step = 0; step < 1000; step++) {
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++)
                arb_set_d(arb_mat_entry(m.derivative, i, j), m.set.basis[i][j]);
        arb_mat_mul(m.derivative, turn, m.derivative, 64);
        ck_assert(lohner_move(&m.set, m.image, m.derivative, 1, m.error, LOHNER_BITS));
    }
    lohner_to_box(box, &m.set);
    arb_mul_ui(angle, angle, 1000, 64);
    arb_sin_cos(m.image, m.image + 1, angle, 64);
    for (int i = 0; i < N; i++) { /* (radius cos, radius sin) are the ends of the set */
        const double end = fabs(number(m.image + (i < 3))) * (i % 3 + 1), radius = mag_get_d(arb_radref(box + i));
        ck_assert_double_ge(radius, end * (1 - 0x1p-50));
        ck_assert_double_le(radius, end * (1 + 1e-4)); /* mag_t rounds up by 2^-30, often, a thousand times */
    }
}

TEST(a_set_under_a_singular_map_stays_bounded)
{
    OWNED(map) m;
    map_init(&m, 0);
    VECTOR(arb, box, N);
    arb_one(arb_mat_entry(m.derivative, 3, 1)); /* all but the second direction vanish */
    for (int i = 0; i < N; i++)
        mag_one(arb_radref(box + i));
    lohner_from_box(&m.set, box);
    ck_assert(lohner_move(&m.set, m.image, m.derivative, 1, m.error, LOHNER_BITS));
    lohner_to_box(box, &m.set);
    for (int i = 0; i < N; i++)
        ck_assert_double_eq_tol(mag_get_d(arb_radref(box + i)), i == 3, 1e-6);
    arb_mat_zero(m.derivative);
    mag_set_ui(m.error + 2, 5); /* what the map leaves open is in the image */
    ck_assert(lohner_move(&m.set, m.image, m.derivative, 1, m.error, LOHNER_BITS));
    lohner_to_box(box, &m.set);
    for (int i = 0; i < N; i++)
        ck_assert_double_eq_tol(mag_get_d(arb_radref(box + i)), i == 2 ? 5 : 0, 1e-6);
    arb_indeterminate(arb_mat_entry(m.derivative, 0, 0));
    ck_assert(!lohner_move(&m.set, m.image, m.derivative, 1, m.error, LOHNER_BITS));
}
