/*
 * Beyond the paper: at what order its approximations err, and what pitch comes to in the nonlinear motion.
 */
#include "algebra.h"
#include "convergence.h"
#include "optimum.h"
#include "second_order.h"

enum { BITS = 192 };

/* "; NAME: psi 2.00, ..." and whether all are as expected. */
static bool add_orders(struct evidence *e, const char *before, const struct convergence *c, slong digits,
                       double tolerance)
{
    bool decided = true;
    evidence_add(e, "%s", before);
    for (int i = 0; i < c->study->count; i++) {
        evidence_add(e, "%s%s", i ? ", " : " ", variable_names[c->study->which[i]]);
        decided = evidence_number(e, " ", convergence_order(c, i), digits, "") && decided;
    }
    return decided && convergence_as_expected(c, tolerance);
}

static bool study_orders(struct evidence *e, const char *before, const char *name)
{
    struct convergence c;
    bool found = convergence_init(&c, study_find(name)) && add_orders(e, before, &c, 3, 0.005);
    convergence_clear(&c);
    return found;
}

static void approximation_orders(struct evidence *e)
{
    bool proved = study_orders(e, "the linear model, from the paper's start times 0.0001, errs by orders: after 12 h",
                               "linear_43200s");
    proved = study_orders(e, "; after 48 h", "linear_172800s") && proved;
    proved = study_orders(e, "; after 48 h from pitch alone", "linear_pitch_172800s") && proved;
    evidence_add(e, ": by reflection in the orbit plane psi and dL are even in pitch, theta is odd");
    proved = study_orders(e, "; the Runge-Kutta method on the nonlinear model at steps of 5 s, after 24000 s",
                          "rk4_nonlinear_24000s") && proved;
    evidence_add(e, " (constants: coulomb-tether study convergence)");
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

/* A bound on what one study's variables are off by at L_ref/R_c = 10 m / 42164 km. */
static bool add_orbit(struct evidence *e, const char *name)
{
    const struct study *s = study_find(name);
    arb_ptr d = _arb_vec_init(VARIABLES);
    fmpq_t smallness;
    fmpq_init(smallness);
    fmpq_set_si(smallness, 10, 42164000); /* the sheet's L_ref and R_c */
    bool found = s->differences(d, s, smallness);
    for (int i = 0; i < s->count; i++)
        evidence_bound(e, i ? ", " : " ", d + i, "");
    _arb_vec_clear(d, VARIABLES);
    fmpq_clear(smallness);
    return found;
}

static void hill_orders(struct evidence *e)
{
    bool found = study_orders(e, "craft 1 and the line of the craft, after 12 h: orders in L_ref/R_c, equal masses,",
                              "hill_43200s");
    found = study_orders(e, "; 100 and 200 kg,", "hill_unequal_43200s") && found;
    evidence_add(e, ": the first term that Hill's equations drop is even in the place, so that equal masses feel it "
                    "alike: it moves the pair, not the line. At R_c = 42164 km the differences are at most");
    found = add_orbit(e, "hill_43200s") && found;
    evidence_add(e, "; 100 and 200 kg:");
    found = add_orbit(e, "hill_unequal_43200s") && found;
    evidence_add(e, " (m, rad)");
    evidence_decide(e, HOLDS, MEASURED, found);
}

/* k and s for the gains (43), (44) of u^2 = n - 9, and whether they are proved. */
static bool rates_at(arb_t k, arb_t s, const arb_t u)
{
    struct second_order o;
    arb_t c1, c2;
    arb_init(c1);
    arb_init(c2);
    arb_sqr(c1, u, BITS);
    arb_add_ui(c1, c1, 9, BITS);
    arb_mul_2exp_si(c2, u, 1);
    second_order_init(&o, c1, c2, BITS);
    arb_set(k, second_order_get(&o, "decay"));
    arb_set(s, second_order_get(&o, "shift"));
    const bool proved = second_order_holds(&o);
    second_order_clear(&o);
    arb_clear(c1);
    arb_clear(c2);
    return proved;
}

static void pitch_stable(struct evidence *e)
{
    arb_ptr x = _arb_vec_init(3);
    arb_one(x + 2);
    const bool exact = rates_at(x, x + 1, x + 2);
    evidence_add(e, "for any gains pitch, z = theta - i theta_dot/(2 Omega), has the centre manifold psi = Re(B z^2), "
                    "dL/L_ref = Re(A z^2), B = -2 i (c1 - 9 + 4 i c2)/(13 c1 - 261 + 52 i c2), A = (2 - 13 i B)/8, "
                    "c1 = C1/Omega^2, c2 = C2/Omega, and on it z' = 2 i z + 9/4 B |z|^2 z: what this leaves of (3) "
                    "with (7) and (18) is of the fourth order in z, in theta of the fifth, exactly. So |z|' = -k |z|^3, k = 2592 c2/((13 c1 - 261)^2 + (52 c2)^2) "
                    "> 0 under (42), which brings yaw and length to the manifold; by the reduction theorem (Carr "
                    "1981) the static formation is asymptotically stable, pitch included, like 1/sqrt(t). The "
                    "linear model leaves that open. n = 10:");
    bool proved = evidence_number(e, " k = ", x, 12, "") && exact;
    proved = evidence_number(e, ", phase rate 2 + s |z|^2, s = ", x + 1, 12, "") && proved;
    _arb_vec_clear(x, 3);
    evidence_decide(e, HOLDS, EXACT, proved);
}

/* u/(169 u^4 + 7072 u^2 + 20736) is stationary at 507 w^2 + 7072 w - 20736 = 0, w = u^2 = n - 9: once, its peak. */
static bool peak_proved(void)
{
    fmpq_poly_t stationary;
    fmpq_t zero;
    fmpq_poly_init(stationary);
    fmpq_init(zero);
    polynomial(stationary, "507*x^2 + 7072*x - 20736");
    bool proved = identity("u", "(13*(9 + u^2) - 261)^2 + (104*u)^2", "169*u^4 + 7072*u^2 + 20736") &&
                  identity("u", "169*u^4 + 7072*u^2 + 20736 - u*(676*u^3 + 14144*u)", "20736 - 507*u^4 - 7072*u^2") &&
                  identity("w", "39^2*(507*w^2 + 7072*w - 20736)", "507*((39*w + 272)^2 - 32^2*133)") &&
                  roots_beyond(stationary, zero) == 1;
    fmpq_poly_clear(stationary);
    fmpq_clear(zero);
    return proved;
}

static void pitch_best_gain(struct evidence *e)
{
    struct optimum settling;
    arb_ptr x = _arb_vec_init(4);
    arb_ptr k = x, s = x + 1, u = x + 2, n = x + 3;
    arb_sqrt_ui(u, 133, BITS);
    arb_mul_ui(u, u, 32, BITS);
    arb_sub_ui(u, u, 272, BITS);
    arb_div_ui(u, u, 39, BITS);
    arb_add_ui(n, u, 9, BITS);
    arb_sqrt(u, u, BITS);
    bool proved = peak_proved() && rates_at(k, s, u);
    evidence_add(e, "on (44) k = 5184 u/(169 u^4 + 7072 u^2 + 20736), u = sqrt(n - 9), is largest at n = 9 + (32 sqrt "
                    "133 - 272)/39");
    proved = evidence_number(e, " = ", n, 16, "") && proved;
    proved = evidence_number(e, ", k = ", k, 12, "") && proved;
    arb_one(u);
    rates_at(n, s, u);
    arb_div(k, n, k, BITS);
    proved = evidence_number(e, "; n = 10 has ", k, 6, " of it") && proved;
    optimum_init(&settling);
    proved = optimum_find(&settling, BITS) && proved;
    proved = evidence_number(e, ". Yaw and length settle fastest at n = ", settling.n, 6, "") && proved;
    optimum_clear(&settling);
    _arb_vec_clear(x, 4);
    evidence_decide(e, HOLDS, EXACT, proved);
}

static void slow_law_orders(struct evidence *e)
{
    struct convergence c;
    bool proved = study_orders(e, "motion less closed form, from a pitch of a = 0.0001, after 12 h, with the orders",
                               "forced_43200s");
    proved = convergence_init(&c, study_find("slow_law")) && proved;
    proved = add_orders(e, "; after 1/a^2 radians of orbit, from a = 0.1 to 0.05, relatively:", &c, 2, 0.05) && proved;
    proved = evidence_number(e, "; constants ", convergence_constant(&c, 0), 2, "") && proved;
    proved = evidence_number(e, " and ", convergence_constant(&c, 1), 2, "") && proved;
    convergence_clear(&c);
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

#define BEYOND "beyond the paper"

const struct claim claims_beyond[] = {
    {"approximation-orders", BEYOND, "the linear model and the Runge-Kutta method err with the orders of their kind",
     approximation_orders},
    {"hill-orders", BEYOND ", Eq. (2)", "Hill's equations are those of the inverse square to first order in L/R_c",
     hill_orders},
    {"pitch-stable", BEYOND ", Eq. (40a)", "the nonlinear closed loop brings pitch to rest too, for all gains of (42)",
     pitch_stable},
    {"pitch-best-gain", BEYOND, "the gain that damps pitch fastest lies close to the one that damps the rest fastest",
     pitch_best_gain},
    {"slow-law-orders", BEYOND, "the closed form errs with its next order, for as long as pitch takes to decay",
     slow_law_orders},
    {NULL, NULL, NULL, NULL}};
