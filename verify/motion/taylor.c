/*
 * One table holds the closed loop, another one the pair in the inverse-square field; everything below interprets them: series
 * coefficients, columns of derivatives, tails. No two of them can disagree about the equations.
 */
#include "motion/taylor.h"

#include "text/scope.h"

enum { X, Y, Z, U, V, W, Q, G, S, A, D, R, P, ONE, TWO, THREE, C1, C2, LAMBDA, HOLD };

static const struct term closed_loop_terms[JET_TERMS] = {
    {G, Q, Q, 1},
    {S, X, U, 1},     {S, Y, V, 1},      {S, Z, W, 1},
    {A, G, S, 1},
    {D, LAMBDA, Q, 1}, {D, ONE, ONE, -1},
    {R, C1, D, 1},     {R, HOLD, Q, -1}, {R, C2, A, -1},
    {P, G, R, 1},
    {X, ONE, U, 1},
    {Y, ONE, V, 1},
    {Z, ONE, W, 1},
    {U, TWO, V, 1},   {U, THREE, X, 1},  {U, P, X, 1},
    {V, TWO, U, -1},  {V, P, Y, 1},
    {W, ONE, Z, -1},  {W, P, Z, 1},
    {Q, Q, A, -1},
};

const struct system closed_loop = {JET_STATES, JET_SERIES, JET_ALL, JET_TERMS, closed_loop_terms};

_Static_assert(R == (int)JET_CHARGE && G == (int)JET_STATES && ONE == (int)JET_SERIES && HOLD + 1 == JET_ALL, "series in order");

void jet_init(struct jet *jet, const struct system *system, slong order, const struct space *space)
{
    const slong each = order + 1, count = system->all * each;
    arb_ptr balls = space == NULL ? _arb_vec_init(count) : NULL;
    struct model *models = space != NULL ? models_init((int)count, space) : NULL;
    *jet = (struct jet){.order = order, .system = system, .space = space};
    for (int v = 0; v < system->all; v++)
        if (space == NULL)
            jet->c[v] = balls + v * each;
        else
            jet->m[v] = models + v * each;
}

void jet_clear(struct jet *jet)
{
    if (jet->space == NULL)
        _arb_vec_clear(jet->c[0], jet->system->all * (jet->order + 1));
    else
        models_clear(jet->m[0]);
}

void jet_constants(struct jet *jet, const arb_t c1, const arb_t c2)
{
    arb_ptr *const c = jet->c + jet->system->series - ONE;
    arb_set_ui(c[ONE], 1);
    arb_set_ui(c[TWO], 2);
    arb_set_ui(c[THREE], 3);
    arb_set(c[C1], c1);
    arb_set(c[C2], c2);
    arb_set_ui(c[LAMBDA], 1);
    arb_set_ui(c[HOLD], 3);
}

/* Coefficient `at` of z's v becomes, or gets added, sign sum_{j < count} x_a[j] y_b[k - j]. */
static void add_products(struct jet *z, int v, slong at, bool add, int sign, const struct jet *x, int a, const struct jet *y, int b,
                         slong k, slong count, slong prec)
{
    if (z->space != NULL) {
        model_dot(z->m[v] + at, add, sign, x->m[a], y->m[b] + k, (int)count);
        return;
    }
    arb_ptr to = z->c[v] + at;
    arb_dot(to, add ? to : NULL, sign < 0, x->c[a], 1, y->c[b] + k, -1, count, prec);
}

void jet_start_q(struct jet *jet, slong prec)
{
    for (int i = 0; i < 3; i++)
        add_products(jet, G, 0, i > 0, 1, jet, X + i, jet, X + i, 0, 1, prec);
    if (jet->space != NULL) {
        model_inverse_root(jet->m[Q], jet->m[G]);
        return;
    }
    arb_sqrt(jet->c[Q], jet->c[G], prec);
    arb_inv(jet->c[Q], jet->c[Q], prec);
}

void jet_start_column_q(struct jet *column, const struct jet *jet, slong prec)
{
    for (int i = 0; i < 3; i++)
        add_products(column, G, 0, i > 0, -1, jet, X + i, column, X + i, 0, 1, prec);
    add_products(column, S, 0, false, 1, jet, Q, column, G, 0, 1, prec);
    add_products(column, G, 0, false, 1, jet, Q, column, S, 0, 1, prec);
    add_products(column, Q, 0, false, 1, jet, Q, column, G, 0, 1, prec);
}

/*
 * Theorem (a series in balls, or in models). The coefficients of every motion that starts in the balls given, with parameters in
 * theirs, lie in the balls here: (T13) arb_dot and arb_div_ui enclose their exact results, in however few bits; of models see model.c.
 *
 * The rates' coefficients, and the states' above them; of z itself, or of z as a column of jet: a term a b of the rates has the
 * derivative a db + da b.
 */
void jet_extend(struct jet *z, const struct jet *jet, slong prec, double fall)
{
    const struct system *system = jet->system;
    for (slong k = 0; k < z->order; k++) {
        slong bits = FLINT_MAX(prec - (slong)(fall * (double)k), 32);
        for (int t = 0; t < system->count; t++) {
            const struct term *f = system->terms + t;
            const slong at = k + (f->to < system->states);
            const bool add = !first_of_sum(system, t), factor = is_constant(system, f->a);
            if (z == jet || !is_constant(system, f->b))
                add_products(z, f->to, at, add, f->sign, jet, f->a, z, f->b, k, factor ? 1 : k + 1, bits);
            if (z != jet && !factor)
                add_products(z, f->to, at, true, f->sign, z, f->a, jet, f->b, k, k + 1, bits);
        }
        for (int v = 0; v < system->states; v++)
            if (z->space != NULL)
                model_scale(z->m[v] + k + 1, 1.0 / (double)(k + 1));
            else
                arb_div_ui(z->c[v] + k + 1, z->c[v] + k + 1, (ulong)(k + 1), bits);
    }
}

void jet_size(mag_t size, const struct jet *jet, int v, slong k)
{
    if (jet->space != NULL)
        mag_set_d(size, model_size(jet->m[v] + k));
    else
        arb_get_mag(size, jet->c[v] + k);
}

void majorant_init(struct majorant *m, const struct system *system, slong order)
{
    const slong each = order + 1;
    m->order = order;
    m->system = system;
    m->count = system->all * (2 * each + 1) + system->states + system->count;
    m->tail = _mag_vec_init(m->count);
    m->remainder = m->tail + system->all;
    m->cross = m->remainder + system->states;
    for (int v = 0; v < system->all; v++) {
        m->size[v] = m->cross + system->count + 2 * v * each;
        m->suffix[v] = m->size[v] + each;
    }
}

void majorant_clear(struct majorant *m)
{
    _mag_vec_clear(m->tail, m->count);
}

void majorant_of(struct majorant *m, const struct jet *jets, mag_srcptr weights, slong count,
                 const mag_t h)
{
    SCOPE(mag, power, size);
    m->system = jets->system;
    for (int v = 0; v < m->system->all; v++) {
        mag_one(power);
        for (slong k = 0; k <= m->order; k++) {
            mag_zero(m->size[v] + k);
            for (slong j = 0; j < count; j++) {
                jet_size(size, jets + j, v, k);
                mag_addmul(m->size[v] + k, size, weights + j);
            }
            mag_mul(m->size[v] + k, m->size[v] + k, power);
            mag_mul(power, power, h);
        }
        mag_zero(m->suffix[v] + m->order);
        for (slong k = m->order - 1; k >= 0; k--)
            mag_add(m->suffix[v] + k, m->suffix[v] + k + 1, m->size[v] + k);
    }
}

/* sum += the part from degree n on of (known terms of a) (known terms of b) */
static void add_cross(mag_t sum, const struct majorant *ma, int a, const struct majorant *mb, int b)
{
    for (slong i = 1; i < ma->order && !is_constant(ma->system, a); i++)
        mag_addmul(sum, ma->size[a] + i, mb->suffix[b] + ma->order - i);
}

/* sum += what the tails t_a, t_b add to that: ||a|| t_b + t_a ||b|| + t_a t_b, norms of the known terms */
static void add_tail(mag_t sum, const struct majorant *ma, int a, const struct majorant *mb, int b)
{
    mag_addmul(sum, ma->suffix[a], mb->tail + b);
    mag_addmul(sum, ma->tail + a, mb->suffix[b]);
    mag_addmul(sum, ma->tail + a, mb->tail + b);
}

/* Remainders of the states such that the solution's keep below `image` wherever they keep below m->remainder. */
static void remainder_image(mag_ptr image, struct majorant *m, const struct majorant *base,
                            const mag_t factor)
{
    for (int v = 0; v < m->system->states; v++) {
        mag_add(m->tail + v, m->size[v] + m->order, m->remainder + v);
        mag_zero(image + v);
    }
    for (int v = m->system->states; v < m->system->series; v++)
        mag_zero(m->tail + v);
    for (int t = 0; t < m->system->count; t++) {
        const struct term *f = m->system->terms + t;
        mag_ptr sum = f->to < m->system->states ? image + f->to : m->tail + f->to;
        mag_add(sum, sum, m->cross + t);
        if (base == NULL) {
            add_tail(sum, m, f->a, m, f->b);
        } else {
            add_tail(sum, m, f->a, base, f->b);
            add_tail(sum, base, f->a, m, f->b);
        }
    }
    for (int v = 0; v < m->system->states; v++)
        mag_mul(image + v, image + v, factor);
}

static bool below(mag_srcptr image, const struct majorant *m)
{
    for (int v = 0; v < m->system->states; v++)
        if (mag_is_inf(image + v) || mag_cmp(image + v, m->remainder + v) > 0)
            return false;
    return true;
}

/*
 * Theorem (the remainder of a series). With ||ab|| <= ||a|| ||b||, the tail of a product is at most
 * cross + ||a|| t_b + t_a ||b|| + t_a t_b, which does not decrease in t. Coefficient k+1 of a state is
 * coefficient k of its rate over k+1, so the terms of a state beyond degree n sum to at most h/(n+1) times
 * the tail of its rate. This takes bounds rho of the remainders to bounds G(rho), and G is monotone.
 *
 * If G(rho) <= rho, then the remainders of the solution are at most G(rho). For let its terms of degrees n+1 ... K
 * sum to at most rho; those of degrees n+1 ... K+1 come from coefficients of the rates to degree K, thus
 * from coefficients of the states to degree K, and sum to at most G(rho) <= rho: induction on K, from
 * K = n where the sum is empty. So the series converge absolutely on |s| <= h, and their sum solves the
 * equations there. No enclosure of the solution is needed beforehand.
 *
 * Columns obey the differentiated system, linear in them: each term gives da b + a db, and the same
 * holds. A sum of columns under non-negative weights has the sum of their majorants.
 *
 * The error terms, each with a test of its name in tests/motion/test_taylor.c:
 *   (T1) cross: the known terms' products from degree n on          (add_cross)
 *   (T2) ||a|| t_b   (T3) t_a ||b||   (T4) t_a t_b                   (add_tail)
 *   (T5) of a state's tail the term of degree n   (T6) and its remainder  (remainder_image)
 *   (T7) the factor h/(n+1)
 *   (T8) of columns both da b and a db, in cross and in tails
 *   (T9) of a sum of columns each, under its weight                  (majorant_of)
 *   (T10) the radii of the coefficients' balls                       (majorant_of)
 *   (T11) G(rho) <= rho, tried, not presumed                         (below)
 *   (T12) the roundings of mag_t, all of them upward
 */
bool majorant_prove(struct majorant *m, const struct majorant *base, const mag_t h)
{
    enum { ATTEMPTS = 24 }; /* a step that is short enough takes two or three */
    VECTOR(mag, image, m->system->states);
    SCOPE(mag, factor);
    mag_set_ui(factor, (ulong)(m->order + 1));
    mag_div(factor, h, factor);

    for (int t = 0; t < m->system->count; t++) {
        const struct term *f = m->system->terms + t;
        mag_zero(m->cross + t);
        add_cross(m->cross + t, m, f->a, base == NULL ? m : base, f->b);
        if (base != NULL)
            add_cross(m->cross + t, base, f->a, m, f->b);
    }
    for (int v = 0; v < m->system->states; v++)
        mag_zero(m->remainder + v);

    bool proved = false;
    for (int attempt = 0; attempt < ATTEMPTS && !proved; attempt++) {
        remainder_image(image, m, base, factor);
        proved = below(image, m);
        for (int v = 0; v < m->system->states; v++)
            mag_mul_2exp_si(m->remainder + v, image + v, proved ? 0 : 1);
    }
    return proved;
}
