/*
 * Lohner's set: the basis is chosen in double precision, what depends on it is enclosed.
 */
#include "motion/lohner.h"

#include <math.h>
#include <string.h>

#include "text/scope.h"

enum { N = LOHNER_SIZE };

typedef double matrix[N][N];

void lohner_init(struct lohner *set)
{
    set->centre = _arb_vec_init(N);
    set->radius = _mag_vec_init(N);
    memset(set->basis, 0, sizeof set->basis);
}

void lohner_clear(struct lohner *set)
{
    _arb_vec_clear(set->centre, N);
    _mag_vec_clear(set->radius, N);
}

void lohner_from_box(struct lohner *set, arb_srcptr box)
{
    for (int i = 0; i < N; i++) {
        arb_get_mid_arb(set->centre + i, box + i);
        mag_set(set->radius + i, arb_radref(box + i));
        for (int j = 0; j < N; j++)
            set->basis[i][j] = i == j;
    }
}

void lohner_to_box(arb_ptr box, const struct lohner *set)
{
    SCOPE(mag, entry);
    for (int i = 0; i < N; i++) {
        arb_set(box + i, set->centre + i);
        for (int j = 0; j < N; j++) {
            mag_set_d(entry, set->basis[i][j]); /* its absolute value, upward */
            mag_addmul(arb_radref(box + i), entry, set->radius + j);
        }
    }
}

/* v less its parts along the first k columns, twice for the sake of rounding; returns what length is left */
static double project(double v[N], matrix basis, int k)
{
    double norm = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int m = 0; m < k; m++) {
            double dot = 0;
            for (int i = 0; i < N; i++)
                dot += v[i] * basis[i][m];
            for (int i = 0; i < N; i++)
                v[i] -= dot * basis[i][m];
        }
    for (int i = 0; i < N; i++)
        norm = hypot(norm, v[i]);
    return norm;
}

/*
 * An orthonormal basis whose first k columns span the first k of `a`, each k. Gram and Schmidt's way leaves
 * coordinates alone that the motion leaves alone: a pair in the orbit plane stays there exactly.
 */
static void orthonormalise(matrix basis, matrix a)
{
    for (int k = 0; k < N; k++) {
        double v[N], length = 0, left, enough = 1e-10;
        for (int i = 0; i < N; i++)
            length = hypot(length, a[i][k]);
        for (int i = 0; i < N; i++)
            v[i] = a[i][k] / length;
        left = project(v, basis, k);
        for (int axis = 0; axis < N && !(left > enough); axis++) { /* a column lost to those before it, or 0/0 */
            enough = 0.4; /* less than 1/sqrt 6: some axis has that much left */
            memset(v, 0, sizeof v);
            v[axis] = 1;
            left = project(v, basis, k);
        }
        for (int i = 0; i < N; i++)
            basis[i][k] = v[i] / left;
    }
}

/* A basis along the images of the old directions, the one of longest radius first: it suffers least. */
static void choose_basis(struct lohner *set, const arb_mat_t derivative)
{
    matrix sorted;
    VECTOR(mag, length, N);
    SCOPE(mag, entry);
    int place[N] = {0};
    for (int j = 0; j < N; j++) {
        for (int i = 0; i < N; i++) {
            arb_get_mag(entry, arb_mat_entry(derivative, i, j));
            mag_addmul(length + j, entry, set->radius + j);
        }
        for (int k = 0; k < j; k++)
            place[mag_cmp(length + k, length + j) >= 0 ? j : k]++;
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sorted[i][place[j]] =
                arf_get_d(arb_midref(arb_mat_entry(derivative, i, j)), ARF_RND_NEAR);
    orthonormalise(set->basis, sorted);
}

/* sum_i += |a_ij| x_j */
static void add_absolute(mag_ptr sum, const arb_mat_t a, mag_srcptr x)
{
    SCOPE(mag, entry);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            arb_get_mag(entry, arb_mat_entry(a, i, j));
            mag_addmul(sum + i, entry, x + j);
        }
}

/*
 * Theorem. With image = centre' + ball: derivative e + ball + error = basis' e' where
 * e' = basis'^-1 derivative e + basis'^-1 (ball + error), for any regular basis'. Its choice, in double
 * precision, decides how sharp the set is, never whether it holds the image: the inverse is enclosed.
 *
 * The error terms, each with a test of its name in tests/motion/test_lohner.c:
 *   (L1) |basis'^-1 derivative| radius, of all directions and parts  (L2) the radii of that product
 *   (L3) |basis'^-1| times the image's own ball            (L4) and times the error
 *   (L5) the radii of the inverse
 *   (L6) a box becomes a set with all its radii            (lohner_from_box)
 *   (L7) a set becomes a box by |basis| radius, upward     (lohner_to_box)
 *   (L8) a basis without an inverse, or a radius that is not finite, is no set
 */
bool lohner_move(struct lohner *set, arb_srcptr image, const arb_mat_struct *derivative, int count, mag_srcptr error, slong prec)
{
    MATRIX(arb, basis, N, N);
    MATRIX(arb, unit, N, N);
    MATRIX(arb, inverse, N, N);
    MATRIX(arb, turned, N, N);
    VECTOR(mag, loose, N);
    VECTOR(mag, radius, N);
    choose_basis(set, derivative);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            arb_set_d(arb_mat_entry(basis, i, j), set->basis[i][j]);
        mag_add(loose + i, arb_radref(image + i), error + i);
        arb_get_mid_arb(set->centre + i, image + i);
    }
    arb_mat_one(unit);
    bool bounded = arb_mat_solve_lu(inverse, basis, unit, prec); /* elimination keeps zeros */
    for (int i = 0; i < count; i++) {
        arb_mat_mul(turned, inverse, derivative + i, prec);
        add_absolute(radius, turned, set->radius);
    }
    add_absolute(radius, inverse, loose);
    for (int i = 0; i < N; i++) {
        mag_swap(set->radius + i, radius + i);
        bounded = bounded && mag_is_finite(set->radius + i);
    }
    return bounded;
}
