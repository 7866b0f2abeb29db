/*
 * Claims about the linear model (40): when it is stable, what damps it, what the charge can reach.
 */
#include "claims_stability.h"

#include <stdio.h>

#include "algebra.h"
#include "optimum.h"
#include "symbolic.h"
#include "sheet.h"

/* ---- stability -------------------------------------------------------- */

static void decide_routh(struct evidence *e)
{
    bool minors = section_identity("eq41", "a2*a3 - a1", "C2*(C1 - 5*Omega^2)") &&
                  section_identity("eq41", "a1*(a2*a3 - a1) - a3^2*a0", "12*Omega^4*C2^2") &&
                  section_identity("eq41", "a3", "C2") && section_identity("eq41", "a4", "1") &&
                  section_identity("eq41", "a0", "3*Omega^2*(C1 - 9*Omega^2)");
    bool printed = section_identity("eq42", "margin1", "C1 - 9*Omega^2") &&
                   section_identity("eq42", "margin2", "C2");
    /* at C1 = 9 Omega^2 a root 0 and a stable cubic; on the axis nothing else, as p(i sqrt 3) = -12 */
    bool boundary = identity("s c", "(s^2 + 3)*(s^2 + c*s) + 4*s^2", "s*(s^3 + c*s^2 + 7*s + 3*c)") &&
                    identity("c", "c*7 - 3*c", "4*c");
    evidence_add(e, "Hurwitz minors C2, C2 (C1 - 5 Omega^2), 12 Omega^4 C2^2 and a0 = 3 Omega^2 (C1 - 9 "
                    "Omega^2) are positive under (42); without it a0 <= 0 puts a root at or right of 0, or C2 "
                    "<= 0 gives roots of sum -C2 >= 0. Boundary C1 = 9 Omega^2, C2 > 0: a simple root 0 (dL "
                    "may rest anywhere), the other three stable; boundary C2 = 0: see derivative-feedback");
    evidence_decide(e, HOLDS, EXACT, minors && printed && boundary);
}

static void decide_length_alone(struct evidence *e)
{
    bool proved = section_identity("eq19", "dL_ddot",
                                   "-C2*dL_dot - (C1 - 9*Omega^2)*dL + 2*Omega*L_ref*psi_dot");
    evidence_add(e, "without psi_dot: lambda^2 + C2 lambda + (C1 - 9 Omega^2), stable exactly when both "
                    "coefficients are positive, which is (42) word for word; the coupling neither narrows nor "
                    "widens the region");
    evidence_decide(e, HOLDS, EXACT, proved);
}

static void decide_derivative_feedback(struct evidence *e)
{
    /* squares s^2 = -(c1 - 2)/2 +- sqrt(D)/2, D = (c1 - 8)^2 + 48 > 0, negative both for c1 > 9 */
    bool proved = identity("c", "(c - 2)^2 - 4*3*(c - 9)", "(c - 8)^2 + 48") &&
                  section_identity("eq41", "a1", "3*Omega^2*C2") && section_identity("eq41", "a3", "C2") &&
                  section_identity("eq41", "a2", "C1 - 2*Omega^2");
    fmpq_mat_t B;
    fmpq_mat_init(B, PLANE, PLANE);
    const slong edge[4] = {1, 1, 9, 0};
    proved = proved && plane_model(B, edge) && characteristic_is(B, "x^2*(x^2 + 7)") &&
             rank_of(B) == PLANE - 1;
    fmpq_mat_clear(B);
    evidence_add(e, "C2 = 0 leaves lambda^4 + (C1 - 2 Omega^2) lambda^2 + 3 Omega^2 (C1 - 9 Omega^2): with "
                    "lambda also -lambda, so never asymptotically stable, whatever C1. Its discriminant in "
                    "lambda^2/Omega^2, (c1 - 8)^2 + 48, is positive: for C1 > 9 Omega^2 four different "
                    "imaginary roots, undamped; at C1 = 9 Omega^2 a double root 0 with one eigenvector, a "
                    "drift; below it a positive root");
    evidence_decide(e, HOLDS, EXACT, proved);
}

static void decide_no_damping_term(struct evidence *e)
{
    bool proved = section_identity("eq17", "dL_ddot - k_c/m1/L_ref^2*((m1 + m2)/m2)*dQ",
                                   "2*Omega*L_ref*psi_dot + 9*Omega^2*dL") &&
                  section_identity("eq19", "dL_ddot + C2*dL_dot",
                                   "2*Omega*L_ref*psi_dot - (C1 - 9*Omega^2)*dL");
    evidence_add(e, "(17) is 2 Omega L_ref psi_dot + 9 Omega^2 dL and the charge term, without dL_dot; in (19) "
                    "the whole coefficient of dL_dot is -C2");
    evidence_decide(e, HOLDS, EXACT, proved);
}

static void decide_constant_charge(struct evidence *e)
{
    bool proved = rates_proved() && identity("s", "(s^2 + 3)*(s^2 - 9) + 4*s^2", "(s^2 - 1)^2 - 28");
    arb_t root, Omega;
    arb_init(root);
    arb_init(Omega);
    arb_sqrt_ui(root, 28, CLAIM_BITS);
    arb_add_ui(root, root, 1, CLAIM_BITS);
    arb_sqrt(root, root, CLAIM_BITS);
    table_rate(Omega);
    arb_mul(Omega, Omega, root, CLAIM_BITS);
    arb_inv(Omega, Omega, CLAIM_BITS);
    evidence_add(e, "(41) with C1 = C2 = 0 is (s^2 - 1)^2 - 28, s = lambda/Omega");
    proved = say(e, ": a real root s = sqrt(1 + 2 sqrt 7) = ", root, 20) && proved;
    proved = say(e, ", growth by e in ", Omega, 6) && proved;
    evidence_add(e, " s with Table 1; without the yaw coupling it would be s = 3");
    arb_clear(root);
    arb_clear(Omega);
    evidence_decide(e, HOLDS, CERTIFIED, proved);
}

/* The free motion of (3), Q = 0, in the units of Omega: its matrix from differences, as L may not be 0. */
static bool hill_matrix(fmpq_mat_t A)
{
    slong inputs[11] = {1, 1, 1, 1, 0, 1}; /* Omega k_c m1 m2 Q, then x1 = 1 */
    fmpq *rest = _fmpq_vec_init(3), *moved = _fmpq_vec_init(3);
    bool rational = section_at("eq03", inputs, rest);
    for (int j = 0; j < STATE; j++) {
        slong there[11] = {1, 1, 1, 1, 0};
        there[5] = j >= 3;
        there[5 + j] = 1;
        rational = section_at("eq03", there, moved) && rational;
        for (int i = 0; i < 3; i++) {
            if (j >= 3)
                fmpq_sub(moved + i, moved + i, rest + i);
            fmpq_set(fmpq_mat_entry(A, 3 + i, j), moved + i);
        }
        if (j >= 3)
            fmpq_one(fmpq_mat_entry(A, j - 3, j));
    }
    _fmpq_vec_clear(rest, 3);
    _fmpq_vec_clear(moved, 3);
    return rational;
}

static void decide_zero_charge(struct evidence *e)
{
    fmpq_mat_t A;
    fmpq_mat_init(A, STATE, STATE);
    bool proved = section_identity("eq15", "L_ddot - k_c/m1*Q/L^2*((m1 + m2)/m2)",
                                   "(2*Omega*psi_dot + 3*Omega^2)*L");
    proved = proved && hill_matrix(A) && characteristic_is(A, "x^2*(x^2 + 1)^2") &&
             rank_of(A) == STATE - 1;
    fmpq_mat_clear(A);
    evidence_add(e, "(15) with Q = 0, psi_dot = 0: L_ddot = 3 Omega^2 L, roots +- sqrt(3) Omega, real, no "
                    "oscillation. That needs psi_dot held at 0: the free motion (3) has the roots 0, 0, +- i "
                    "Omega twice, the double 0 with one eigenvector: the craft do drift apart, but linearly in "
                    "time, not exponentially");
    e->why = "Only with the yaw rate held at zero; free craft drift apart linearly in time.";
    evidence_decide(e, QUALIFIED, EXACT, proved);
}

/* The energy V loses C2 dL_dot^2 and nothing else. */
static bool energy_decays(void)
{
    const struct section *s = section_find(sheet(), "eq40");
    struct program p;
    int rate[9]; /* the inputs of eq40 */
    program_copy(&p, &s->corrected.program);
    for (int i = 0; i < p.inputs; i++)
        rate[i] = -1;
    rate[program_find(&p, "psi")] = program_find(&p, "psi_dot");
    rate[program_find(&p, "dL")] = program_find(&p, "dL_dot");
    rate[program_find(&p, "psi_dot")] = s->corrected.outputs[1];
    rate[program_find(&p, "dL_dot")] = s->corrected.outputs[2];
    int V = formula(&p, "(dL_dot^2 + L_ref^2*psi_dot^2 + (C1 - 9*Omega^2)*dL^2 + 3*Omega^2*L_ref^2*psi^2)/2");
    int V_dot = program_derivative(&p, V, rate, p.inputs), loss = formula(&p, "-C2*dL_dot^2");
    bool decays = V >= 0 && loss >= 0 && vanishes(&p, program_difference(&p, V_dot, loss));
    program_clear(&p);
    return decays;
}

/* Only the equilibrium keeps dL_dot = 0: det(c, c A, c A^2, c A^3) = +-36 (c1 - 9) in units Omega = L_ref = 1. */
static bool rate_observes_all(void)
{
    bool observes = true;
    fmpq_mat_t B, K;
    fmpq_t det, expected;
    fmpq_init(det);
    fmpq_init(expected);
    fmpq_mat_init(B, PLANE, PLANE);
    fmpq_mat_init(K, PLANE, PLANE);
    for (slong c1 = 0; c1 <= 6; c1++) { /* c A^k is of degree k in each gain: 0 + 1 + 2 + 3 */
        for (slong c2 = 0; c2 <= 6; c2++) {
            const slong parameters[4] = {1, 1, c1, c2};
            observes = plane_model(B, parameters) && observes;
            fmpq_mat_transpose(B, B);
            krylov(K, B);
            fmpq_mat_det(det, K);
            fmpq_set_si(expected, 36 * (c1 - 9), 1);
            fmpq_neg(det, det);
            observes = observes && fmpq_equal(det, expected);
        }
    }
    fmpq_mat_clear(B);
    fmpq_mat_clear(K);
    fmpq_clear(det);
    fmpq_clear(expected);
    return observes;
}

static void decide_coupling_damps(struct evidence *e)
{
    bool proved = energy_decays() && rate_observes_all();
    evidence_add(e, "V = (dL_dot^2 + L_ref^2 psi_dot^2 + (C1 - 9 Omega^2) dL^2 + 3 Omega^2 L_ref^2 psi^2)/2, "
                    "positive definite exactly when C1 > 9 Omega^2, has V_dot = -C2 dL_dot^2: the two coupling "
                    "terms cancel, so the coupling takes nothing out; it carries yaw energy into dL, where the "
                    "charge removes it, at any n and not only at n = 12. dL_dot = 0 for ever leaves rest alone "
                    "(observability determinant 36 (c1 - 9) in size), so yaw is damped too (LaSalle): a second "
                    "proof that (42) suffices");
    e->why = "At any n, not at matching frequencies alone: it carries yaw's energy to the length, where C2 takes it.";
    evidence_decide(e, QUALIFIED, EXACT, proved);
}

static bool contains(const char *id, const char *name)
{
    return program_find(&section_find(sheet(), id)->corrected.program, name) >= 0;
}

static void decide_gains_reference(struct evidence *e)
{
    bool proved = !contains("eq17", "C1") && !contains("eq17", "C2") && !contains("eq17", "psi") &&
                  contains("eq19", "C1") && contains("eq19", "C2") && !contains("eq19", "psi") &&
                  section_identity("eq40", "dL_ddot", "-C2*dL_dot + 2*Omega*L_ref*psi_dot - (C1 - 9*Omega^2)*dL");
    evidence_add(e, "(17) holds neither gain; the equation of dL with C1 and C2 is (19), again (40c). None of "
                    "them contains psi: what is left out is the term of psi_dot");
    e->why = "The gains stand in (19), not in (17), and what is left out there is the term of psi_dot.";
    evidence_decide(e, HOLDS_AS_CORRECTED, EXACT, proved);
}

/* ---- what the charge can reach ---------------------------------------- */

static void decide_pitch(struct evidence *e)
{
    bool proved = section_identity("eq40", "theta_ddot", "-4*Omega^2*theta") &&
                  section_identity("eq40", "psi_ddot", "-2*Omega/L_ref*dL_dot - 3*Omega^2*psi") &&
                  section_identity("eq40", "dL_ddot", "-C2*dL_dot + 2*Omega*L_ref*psi_dot - (C1 - 9*Omega^2)*dL");
    arb_t period, Omega;
    arb_init(period);
    arb_init(Omega);
    table_rate(Omega);
    arb_const_pi(period, CLAIM_BITS);
    arb_div(period, period, Omega, CLAIM_BITS);
    evidence_add(e, "theta_ddot = -4 Omega^2 theta, whatever the gains, and theta enters neither psi_ddot nor "
                    "dL_ddot: roots +- 2 i Omega, simple; stable with constant amplitude, never asymptotically");
    proved = say(e, "; period pi/Omega = ", period, 12) && proved;
    evidence_add(e, " s with Table 1, half an orbit");
    arb_clear(period);
    arb_clear(Omega);
    evidence_decide(e, HOLDS, EXACT, proved);
}

/* (17): dQ acts on dL_ddot alone, with a factor that is never zero. */
static bool charge_acts_on_length(void)
{
    return section_identity("eq17", "dL_ddot - 2*Omega*L_ref*psi_dot - 9*Omega^2*dL",
                            "k_c*(m1 + m2)/(m1*m2*L_ref^2)*dQ");
}

static void decide_pitch_uncontrollable(struct evidence *e)
{
    const slong constant_charge[4] = {1, 1, 0, 0}; /* in the units Omega and L_ref */
    fmpq_mat_t A, K;
    fmpq_mat_init(A, STATE, STATE);
    fmpq_mat_init(K, STATE, STATE);
    bool proved = linear_model(A, constant_charge) && charge_acts_on_length();
    krylov(K, A);
    for (int j = 0; j < STATE; j++) /* theta and theta_dot */
        proved = proved && fmpq_is_zero(fmpq_mat_entry(K, 1, j)) && fmpq_is_zero(fmpq_mat_entry(K, 4, j));
    evidence_add(e, "the controllability matrix of (40a), (40b), (17) under dQ has rank %ld of %d; its rows of "
                    "theta and theta_dot are zero, so the modes +- 2 i Omega are out of reach of every charge "
                    "law, to first order",
                 (long)rank_of(K), STATE);
    fmpq_mat_clear(A);
    fmpq_mat_clear(K);
    evidence_decide(e, HOLDS, EXACT, proved);
}

static void decide_yaw_controllable(struct evidence *e)
{
    const slong constant_charge[4] = {1, 1, 0, 0};
    fmpq_mat_t B, K;
    fmpq_mat_init(B, PLANE, PLANE);
    fmpq_mat_init(K, PLANE, PLANE);
    bool proved = plane_model(B, constant_charge) && charge_acts_on_length() && energy_decays() &&
                  rate_observes_all();
    krylov(K, B);
    const slong rank = rank_of(K);
    evidence_add(e, "psi, dL and their rates under dQ: controllability rank %ld of %d, so that feedback of all "
                    "four places the roots at will; feedback of dL and dL_dot alone makes them asymptotically "
                    "stable under (42)",
                 (long)rank, PLANE);
    fmpq_mat_clear(B);
    fmpq_mat_clear(K);
    evidence_decide(e, HOLDS, EXACT, proved && rank == PLANE);
}

/* Without the gravity gradient on psi: a lower rank under dQ, and a double root 0 for all gains. */
static bool momentum_stays(slong *rank)
{
    bool stays = true;
    char text[64];
    fmpq_mat_t B, K;
    fmpq_mat_init(B, PLANE, PLANE);
    fmpq_mat_init(K, PLANE, PLANE);
    for (slong k = 0; k < 2 * 2; k++) { /* of degree 1 in each gain */
        const slong parameters[4] = {1, 1, 6 + k % 2, k / 2};
        stays = plane_model(B, parameters) && stays;
        fmpq_zero(fmpq_mat_entry(B, 2, 0)); /* psi_ddot by psi */
        snprintf(text, sizeof text, "x^2*(x^2 + %d*x + %d)", (int)parameters[3], (int)parameters[2] - 5);
        stays = stays && characteristic_is(B, text) && rank_of(B) == PLANE - 1;
    }
    krylov(K, B);
    *rank = rank_of(K);
    fmpq_mat_clear(B);
    fmpq_mat_clear(K);
    return stays && *rank < PLANE;
}

static void decide_attitude(struct evidence *e)
{
    slong rank;
    bool proved = momentum_stays(&rank) && charge_acts_on_length() && energy_decays() && rate_observes_all() &&
                  section_identity("eq40", "L_ref^2*psi_ddot + 2*Omega*L_ref*dL_dot", "-3*Omega^2*L_ref^2*psi");
    evidence_add(e, "by (40b) the angular momentum, L_ref^2 psi_dot + 2 Omega L_ref dL a unit of reduced mass, "
                    "changes by the gravity-gradient torque -3 Omega^2 L_ref^2 psi alone. Without it the rank "
                    "under dQ is %ld of %d and (41) is lambda^2 (lambda^2 + C2 lambda + C1 - 5 Omega^2): a "
                    "double root 0 for all gains, psi drifts. But with the torque alone, dL held, psi only "
                    "swings, at sqrt(3) Omega: the torque turns, the charge damps, through dL_dot; neither "
                    "makes yaw asymptotically stable alone, and pitch is not so at all",
                 (long)rank, PLANE);
    e->why = "Neither does so alone: the torque turns yaw back, the charge damps it; pitch is damped by neither, to first order.";
    evidence_decide(e, QUALIFIED, EXACT, proved);
}

/* True when the Coulomb part f of (3), not zero, has no moment r x f there; Q = 1, the masses 1 or 2. */
static bool no_moment_at(slong m1, slong m2, const slong r[3])
{
    slong inputs[11] = {1, 1, m1, m2, 1, r[0], r[1], r[2]};
    fmpq *f = _fmpq_vec_init(3), *g = _fmpq_vec_init(3);
    bool none = section_at("eq03", inputs, f);
    inputs[4] = 0;
    none = section_at("eq03", inputs, g) && none;
    for (int i = 0; i < 3; i++)
        fmpq_sub(f + i, f + i, g + i);
    none = none && !(fmpq_is_zero(f) && fmpq_is_zero(f + 1) && fmpq_is_zero(f + 2));
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        fmpq_mul_si(g, f + j, r[i]);
        fmpq_mul_si(g + 1, f + i, r[j]);
        none = none && fmpq_equal(g, g + 1);
    }
    _fmpq_vec_clear(f, 3);
    _fmpq_vec_clear(g, 3);
    return none;
}

/*
 * Quaternions p, q, r, s give all directions with a rational length, p^2 + q^2 + r^2 + s^2. Times its cube
 * the moment is a polynomial of degree 4 in each of them, and of degree 1 in each mass when cleared of fractions.
 */
static void decide_no_moment(struct evidence *e)
{
    bool none = true;
    for (int k = 0; k < 5 * 5 * 5 * 5 * 4 && none; k++) {
        const slong p = 1 + k % 5, q = 1 + k / 5 % 5, r = 1 + k / 25 % 5, s = 1 + k / 125 % 5;
        const slong x1[3] = {p * p + q * q - r * r - s * s, 2 * (q * r + p * s), 2 * (q * s - p * r)};
        none = no_moment_at(1 + k / 625 % 2, 1 + k / 1250, x1);
    }
    evidence_add(e, "the charge term of (3) is parallel to (x1, y1, z1) in every direction, and the other "
                    "craft's is opposite by (4): no net force and no moment about the centre of mass, whatever "
                    "the charges");
    evidence_decide(e, HOLDS, EXACT, none);
}

/* The row of (9) that stays a unit vector of the Hill frame when one angle alone turns. */
static bool axis_stays(const char *angle, int axis)
{
    const struct section *s = section_find(sheet(), "eq09");
    struct machine m;
    fmpq_t zero;
    bool stays = true;
    fmpq_init(zero);
    symbolic_begin(1, 0, false);
    machine_init(&m, &s->corrected.program, &arithmetic_symbolic, 1);
    for (int i = 0; i < 2; i++)
        m.arithmetic->set_rational(machine_value(&m, i), zero, 1);
    symbolic_set_angle(machine_value(&m, program_find(m.program, angle)), 0);
    machine_run(&m);
    for (int j = 0; j < 3; j++) {
        const struct symbolic *x = machine_value(&m, s->corrected.outputs[3 * axis + j]);
        stays = stays && (j == axis ? fmpz_mpoly_q_is_one : fmpz_mpoly_q_is_zero)(x->a, symbolic_context());
    }
    machine_clear(&m);
    symbolic_end();
    fmpq_clear(zero);
    return stays;
}

static void decide_names(struct evidence *e)
{
    bool proved = axis_stays("psi", 2) && axis_stays("theta", 1) && !axis_stays("psi", 1) &&
                  !axis_stays("theta", 2);
    evidence_add(e, "by (9) psi turns about the orbit normal and theta about the axis that starts along the "
                    "velocity: names after the order of a 3-2-1 rotation. For an Earth-pointing craft the turn "
                    "about the orbit normal is commonly called pitch, that about the velocity roll");
    evidence_decide(e, DEFINITION, EXACT, proved);
}

#define ANALYSIS "section Stability analysis"

const struct claim claims_stability[] = {
    {"routh", "Eq. (42)",
     "(42) is necessary and sufficient for asymptotic stability of yaw and length error", decide_routh},
    {"length-alone", "Eq. (42), after Eq. (19)",
     "the same conditions make the length error stable when the yaw rate is left out", decide_length_alone},
    {"derivative-feedback", "after Eq. (19)",
     "derivative feedback is essential for asymptotic convergence", decide_derivative_feedback},
    {"no-damping-term", "Eq. (17), after Eq. (19)",
     "without feedback the length error has no damping term", decide_no_damping_term},
    {"constant-charge-linear", "section Linearized orbital perturbation",
     "with the charges held constant the separation is unstable", decide_constant_charge},
    {"zero-charge-linear", "after Eq. (15)",
     "without charge the separation obeys an unstable oscillator", decide_zero_charge},
    {"coupling-damps", ANALYSIS ", after Eq. (44)",
     "at matching frequencies the coupling by the yaw rate contributes to the damping", decide_coupling_damps},
    {"phase-damps", "section Numerical simulation, Eq. (40b)",
     "yaw is damped by the phase between the length rate and yaw", decide_phase},
    {"characteristic-parameters", "Eq. (41)",
     "the characteristic equation does not contain the reference length", decide_characteristic},
    {"roots-scale", "Eq. (41)",
     "its roots depend on the orbital rate", decide_roots_scale},
    {"complex-pairs", ANALYSIS ", Figure 4",
     "under (44) the roots are two complex pairs, with two real parts, for all n > 9", decide_complex_pairs},
    {"complex-pairs-any-gains", ANALYSIS,
     "the roots of (41) are complex pairs", decide_complex_pairs_any},
    {"real-parts-vanish", ANALYSIS ", Figure 4",
     "one real part tends to zero on either side of n = 12", decide_limits},
    {"slow-at-the-ends", ANALYSIS ", Figure 4",
     "n close to 9 or large slows the convergence", decide_slow_ends},
    {"n12-optimal", ANALYSIS ", after Eq. (44)",
     "n = 12 is the best choice of n", decide_n12},
    {"matching-optimal", ANALYSIS ", after Eq. (44)",
     "gains that match the frequency of the length error to that of yaw are optimal", decide_both_gains},
    {"frequencies", ANALYSIS ", after Eq. (44)",
     "alone, yaw has frequency sqrt(3) Omega whatever the gains, the length sqrt(n - 9) Omega; n = 12 matches them",
     decide_frequencies},
    {"critical-damping", "Eqs. (43), (44)",
     "(44) damps the length error critically when the yaw rate is left out", decide_critical},
    {"wiggle", "section Numerical simulation",
     "the length error, else critically damped, oscillates because of the yaw rate", decide_wiggle},
    {"simulation-gains", "section Numerical simulation",
     "the gains of the simulation are approximately 10 Omega^2 and 2 Omega", decide_simulation_gains},
    {"gains-reference", "section Numerical simulation",
     "the gains follow from Eq. (17) with its psi term left out", decide_gains_reference},
    {"pitch-decoupled", "Eq. (40a)",
     "pitch is decoupled and a stable sinusoid", decide_pitch},
    {"pitch-uncontrollable", "Eq. (40a)",
     "pitch cannot be controlled through the charge", decide_pitch_uncontrollable},
    {"yaw-controllable", "Eq. (40b)",
     "yaw can be stabilised asymptotically by the charge, through the length", decide_yaw_controllable},
    {"attitude", "abstract, conclusion",
     "the Coulomb force cannot stabilise the attitude, the gravity gradient does", decide_attitude},
    {"no-moment", "abstract, introduction",
     "Coulomb forces between the craft do not change the angular momentum", decide_no_moment},
    {"names-yaw-pitch", "Figure 3, Eq. (9)",
     "the rotation in the orbit plane is called yaw, that out of it pitch", decide_names},
    {"step-below-period", "section Numerical simulation",
     "100 s is well below the period of natural oscillation", decide_step},
    {NULL, NULL, NULL, NULL}};
