/*
 * FLINT, Arb and Calcium from where this machine keeps them: FLINT 3 has all three (flint/arb.h, flint/ca.h), FLINT 2
 * stands beside a separate Arb (arb.h) and Calcium (calcium/ca.h).
 */
#ifndef CT_FLINT_H
#define CT_FLINT_H

#include <mpfr.h> /* before FLINT, which then knows it */

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_mpoly.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/ulong_extras.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

#if __FLINT_RELEASE >= 30000
#include <flint/acb.h>
#include <flint/acb_poly.h>
#include <flint/arb.h>
#include <flint/arb_calc.h>
#include <flint/arb_fmpz_poly.h>
#include <flint/arb_mat.h>
#include <flint/arb_poly.h>
#include <flint/arf.h>
#include <flint/ca.h>
#include <flint/fmpz_mpoly_q.h>
#include <flint/mag.h>
#include <flint/qqbar.h>
#else
#include <acb.h>
#include <acb_poly.h>
#include <arb.h>
#include <arb_calc.h>
#include <arb_fmpz_poly.h>
#include <arb_mat.h>
#include <arb_poly.h>
#include <arf.h>
#include <calcium/ca.h>
#include <calcium/fmpz_mpoly_q.h>
#include <calcium/qqbar.h>
#include <mag.h>
#endif

#endif
