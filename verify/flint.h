/*
 * FLINT and Arb from where this machine keeps them: FLINT 3 has Arb inside
 * (flint/arb.h), FLINT 2 stands beside a separate Arb (arb.h).
 */
#ifndef CT_FLINT_H
#define CT_FLINT_H

#include <mpfr.h> /* before FLINT, which then knows it */

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpq_vec.h>
#include <flint/fmpz.h>
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
#include <flint/mag.h>
#else
#include <acb.h>
#include <acb_poly.h>
#include <arb.h>
#include <arb_calc.h>
#include <arb_fmpz_poly.h>
#include <arb_mat.h>
#include <arb_poly.h>
#include <arf.h>
#include <mag.h>
#endif

#endif
