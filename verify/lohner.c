#include "lohner.h"

#include <math.h>
#include <string.h>

enum { N = LOHNER_SIZE };

typedef double matrix[N][N];

void lohner_init(struct lohner *set)
{
    set->centre = _arb_vec_init(N);
    set->reach = _mag_vec_init(N);
    memset(set->basis, 0, sizeof set->basis);
}

void lohner_clear(struct lohner *set)
{
    _arb_vec_clear(set->centre, N);
    _mag_vec_clear(set->reach, N);
}

void lohner_from_box(struct lohner *set, arb_srcptr box)
{
    for (int i = 0; i < N; i++) {
        arb_get_mid_arb(set->centre + i, box + i);
        mag_set(set->reach + i, arb_radref(box + i));
        for (int j = 0; j < N; j++)
            set->basis[i][j] = i == j;
    }
}

void lohner_to_box(arb_ptr box, const struct lohner *set)
{
    mag_t entry;
    mag_init(entry);
    for (int i = 0; i < N; i++) {
        arb_set(box + i, set->centre + i);
        for (int j = 0; j < N; j++) {
            mag_set_d(entry, set->basis[i][j]); /* its absolute value, upward */
            mag_addmul(arb_radref(box + i), entry, set->reach + j);
        }
    }
    mag_clear(entry);
}

/* Householder: an orthogonal basis whose first k columns span the first k of `a`, each k; `a` is lost. */
static void orthogonalise(matrix basis, matrix a)
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            basis[i][j] = i == j;
    for (int k = 0; k < N - 1; k++) {
        double v[N] = {0}, norm = 0;
        for (int i = k; i < N; i++) {
            v[i] = a[i][k];
            norm = hypot(norm, v[i]);
        }
        v[k] += copysign(norm, v[k]);
        double half = norm * fabs(v[k]); /* v.v / 2, so the mirror is 1 - v v'/half */
        for (int j = 0; j < N && half > 0; j++) {
            double left = 0, right = 0;
            for (int i = k; i < N; i++) {
                left += v[i] * a[i][j] / half;
                right += basis[j][i] * v[i] / half;
            }
            for (int i = k; i < N; i++) {
                a[i][j] -= left * v[i];
                basis[j][i] -= right * v[i];
            }
        }
    }
}

/* A basis along the images of the old directions, the one of longest reach first: it suffers least. */
static void choose_basis(struct lohner *set, const arb_mat_t derivative)
{
    matrix sorted;
    mag_ptr length = _mag_vec_init(N);
    mag_t entry;
    mag_init(entry);
    int place[N] = {0};
    for (int j = 0; j < N; j++) {
        for (int i = 0; i < N; i++) {
            arb_get_mag(entry, arb_mat_entry(derivative, i, j));
            mag_addmul(length + j, entry, set->reach + j);
        }
        for (int k = 0; k < j; k++)
            place[mag_cmp(length + k, length + j) >= 0 ? j : k]++;
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            sorted[i][place[j]] =
                arf_get_d(arb_midref(arb_mat_entry(derivative, i, j)), ARF_RND_NEAR);
    orthogonalise(set->basis, sorted);
    mag_clear(entry);
    _mag_vec_clear(length, N);
}

/* sum_i += |a_ij| x_j */
static void add_absolute(mag_ptr sum, const arb_mat_t a, mag_srcptr x)
{
    mag_t entry;
    mag_init(entry);
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            arb_get_mag(entry, arb_mat_entry(a, i, j));
            mag_addmul(sum + i, entry, x + j);
        }
    mag_clear(entry);
}

/*
 * With image = centre' + radius: derivative e + radius + error = basis' e' where
 * e' = basis'^-1 derivative e + basis'^-1 (radius + error), for any regular basis'. Its choice, in double
 * precision, decides how sharp the set is, never whether it holds the image: the inverse is enclosed.
 */
bool lohner_move(struct lohner *set, arb_srcptr image, const arb_mat_t derivative, mag_srcptr error)
{
    arb_mat_t basis, inverse, turned;
    mag_ptr loose = _mag_vec_init(N), reach = _mag_vec_init(N);
    arb_mat_init(basis, N, N);
    arb_mat_init(inverse, N, N);
    arb_mat_init(turned, N, N);

    choose_basis(set, derivative);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++)
            arb_set_d(arb_mat_entry(basis, i, j), set->basis[i][j]);
        mag_add(loose + i, arb_radref(image + i), error + i);
        arb_get_mid_arb(set->centre + i, image + i);
    }
    bool bounded = arb_mat_inv(inverse, basis, LOHNER_BITS);
    arb_mat_mul(turned, inverse, derivative, LOHNER_BITS);
    add_absolute(reach, turned, set->reach);
    add_absolute(reach, inverse, loose);
    for (int i = 0; i < N; i++) {
        mag_swap(set->reach + i, reach + i);
        bounded = bounded && mag_is_finite(set->reach + i);
    }

    arb_mat_clear(basis);
    arb_mat_clear(inverse);
    arb_mat_clear(turned);
    _mag_vec_clear(loose, N);
    _mag_vec_clear(reach, N);
    return bounded;
}
