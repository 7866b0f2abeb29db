/*
 * A number lives as long as the block that declares it: SCOPE(arb, x, y); declares arb_t x, y, initialises them, and
 * clears them wherever the block is left. VECTOR(arb, v, n); does the same for n of them, MATRIX(arb, a, n, m); for a matrix; and
 * OWNED(jet) a, b; clears two struct jet, by jet_clear(), that are initialised before anything leaves the block. (The attribute is
 * gcc's and clang's.)
 */
#ifndef CT_SCOPE_H
#define CT_SCOPE_H

#include "text/flint.h"

#define CLEARED_BY(function) __attribute__((cleanup(function)))
#define OWNED(type) CLEARED_BY(type##_clear) struct type

#define SCOPE_1(type, x) type##_t x CLEARED_BY(type##_leave); type##_init(x)
#define SCOPE_2(type, x, ...) SCOPE_1(type, x); SCOPE_1(type, __VA_ARGS__)
#define SCOPE_3(type, x, ...) SCOPE_1(type, x); SCOPE_2(type, __VA_ARGS__)
#define SCOPE_4(type, x, ...) SCOPE_1(type, x); SCOPE_3(type, __VA_ARGS__)
#define SCOPE_5(type, x, ...) SCOPE_1(type, x); SCOPE_4(type, __VA_ARGS__)
#define SCOPE_6(type, x, ...) SCOPE_1(type, x); SCOPE_5(type, __VA_ARGS__)
#define SCOPE_7(type, x, ...) SCOPE_1(type, x); SCOPE_6(type, __VA_ARGS__)
#define SCOPE_8(type, x, ...) SCOPE_1(type, x); SCOPE_7(type, __VA_ARGS__)
#define SCOPE_OF(_1, _2, _3, _4, _5, _6, _7, _8, name, ...) name
#define SCOPE(type, ...) \
    SCOPE_OF(__VA_ARGS__, SCOPE_8, SCOPE_7, SCOPE_6, SCOPE_5, SCOPE_4, SCOPE_3, SCOPE_2, SCOPE_1, )(type, __VA_ARGS__)

#define VECTOR(type, v, n) \
    type##_ptr v = _##type##_vec_init(n); \
    struct type##_vector v##_scope CLEARED_BY(type##_vector_leave) = {v, n}; \
    (void)v##_scope

#define MATRIX(type, a, rows, columns) \
    type##_mat_t a CLEARED_BY(type##_mat_leave); \
    type##_mat_init(a, rows, columns)

#define SCOPED(type) \
    static inline void type##_leave(type##_t *x) \
    { \
        type##_clear(*x); \
    }

#define SCOPED_VECTOR(type, pointer) \
    struct type##_vector { \
        pointer of; \
        slong count; \
    }; \
    static inline void type##_vector_leave(struct type##_vector *v) \
    { \
        _##type##_vec_clear(v->of, v->count); \
    }

typedef fmpq *fmpq_ptr;

SCOPED(acb)
SCOPED(acb_poly)
SCOPED(arb)
SCOPED(arb_mat)
SCOPED(arb_poly)
SCOPED(arf)
SCOPED(fmpq)
SCOPED(fmpq_mat)
SCOPED(fmpq_poly)
SCOPED(fmpz)
SCOPED(fmpz_poly)
SCOPED(mag)
SCOPED_VECTOR(acb, acb_ptr)
SCOPED_VECTOR(arb, arb_ptr)
SCOPED_VECTOR(fmpq, fmpq_ptr)
SCOPED_VECTOR(mag, mag_ptr)

#endif
