/*
 * internal.h   what the files of the library share: domain checks, vectors, the reduced mass
 */
#ifndef COULOMBTETHER_INTERNAL_H
#define COULOMBTETHER_INTERNAL_H

#include <math.h>
#include <stdbool.h>

#include "coulombtether.h"

/* More digits kept in registers than in memory would make results depend on the compiler's choice of the two. */
#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0 && defined(__i386__)
#error "compile for i386 with -msse2 -mfpmath=sse: the x87 registers round doubles at another place"
#endif

/* Whether every argument is finite; whether every argument is finite and above zero. */
#define FINITE(...) all_within(-INFINITY, (const double[]){__VA_ARGS__}, sizeof(double[]){__VA_ARGS__} / sizeof(double))
#define POSITIVE(...) all_within(0, (const double[]){__VA_ARGS__}, sizeof(double[]){__VA_ARGS__} / sizeof(double))

/* NaN compares false, and so fails. */
static inline bool all_within(double lowest, const double *x, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!(x[i] > lowest && x[i] < INFINITY))
            return false;
    return true;
}

static inline bool finite_vector(struct ct_vector r)
{
    return FINITE(r.x, r.y, r.z);
}

static inline bool finite_hill_state(struct ct_hill_state s)
{
    return FINITE(s.x1, s.y1, s.z1, s.x1_dot, s.y1_dot, s.z1_dot);
}

static inline struct ct_vector nan_vector(void)
{
    return (struct ct_vector){NAN, NAN, NAN};
}

static inline struct ct_vector hill_position(struct ct_hill_state s)
{
    return (struct ct_vector){s.x1, s.y1, s.z1};
}

static inline struct ct_vector hill_velocity(struct ct_hill_state s)
{
    return (struct ct_vector){s.x1_dot, s.y1_dot, s.z1_dot};
}

static inline struct ct_vector difference(struct ct_vector a, struct ct_vector b)
{
    return (struct ct_vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

static inline struct ct_vector sum(struct ct_vector a, struct ct_vector b)
{
    return (struct ct_vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline struct ct_vector multiple(double k, struct ct_vector a)
{
    return (struct ct_vector){k * a.x, k * a.y, k * a.z};
}

static inline double dot(struct ct_vector a, struct ct_vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* Without the squares of the components, which could overflow or vanish where the norm does neither. */
static inline double norm(struct ct_vector a)
{
    return hypot(hypot(a.x, a.y), a.z);
}

/* Eq. (12): NaN where the two are not apart, or not finite. */
static inline double distance(struct ct_vector r1, struct ct_vector r2)
{
    const double L = norm(difference(r1, r2));

    return finite_vector(r1) && finite_vector(r2) && L > 0 ? L : NAN;
}

/* m1 m2 / (m1 + m2) */
static inline double reduced_mass(struct ct_params p)
{
    return p.m1 * (p.m2 / (p.m1 + p.m2));
}

#endif
