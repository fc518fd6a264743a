/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elementary functions of this program's own, in place of the C library's: whose last digit depends on the
 * library and on the processor's instructions (glibc has variants with fused operations), and with it every
 * state, series and table.
 *
 * All are correctly rounded to nearest, so that there is one answer, on every machine: a double-double gives
 * the result to 2^-58 of itself or better and is rounded where its error cannot matter; else, about once in a
 * thousand, accurate.c decides with 192 bits (A. Ziv, ACM Transactions on Mathematical Software 17, 1991).
 * + - * / and sqrt(), which IEEE 754 rounds in one way, are all that is used; no fused operation, no
 * extended precision. The rounding mode is to nearest.
 *
 * Domains, limits, infinities and NAN as in C17's annex F; angles of any size. errno and the floating-point
 * flags say nothing. sqrt, fabs, floor, fmod, ldexp and the like are exact everywhere and stay the library's.
 * tests/check_layers.sh holds that no other function of libm is called. */
#ifndef BASE_MATH_FUNCTIONS_H
#define BASE_MATH_FUNCTIONS_H

double math_sin(double);
double math_cos(double);
double math_asin(double);
double math_acos(double);
double math_atan(double);
double math_atan2(double y, double x);
double math_sinh(double);
double math_cosh(double);
double math_exp(double);
double math_expm1(double);
double math_log(double);
double math_log10(double);
double math_log1p(double);
double math_pow(double x, double y);
double math_hypot(double x, double y); /* sqrt(x^2 + y^2) */
double math_erf(double);

#endif
