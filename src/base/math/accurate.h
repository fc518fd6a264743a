/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of functions.h to 2^-165 of themselves, hence correctly rounded: by numbers of 192 bits, in
 * some microseconds. For arguments at which the function is finite and no constant.
 *
 * `near` is the result to 2^-40 of itself or better, from which a step of Newton's goes to all bits. */
#ifndef BASE_MATH_ACCURATE_H
#define BASE_MATH_ACCURATE_H

double accurate_sin(double);
double accurate_cos(double);
double accurate_tan(double);
double accurate_asin(double, double near);
double accurate_acos(double, double near);
double accurate_atan2(double y, double x, double near);
double accurate_sinh(double);
double accurate_cosh(double);
double accurate_tanh(double);
double accurate_exp(double);
double accurate_expm1(double);
double accurate_log(double, double near);
double accurate_log2(double, double near_log); /* near_log: of the natural one */
double accurate_log10(double, double near_log);
double accurate_log1p(double, double near);
double accurate_pow(double x, double y, double near_log); /* x > 0; near_log: of log x */
double accurate_cbrt(double, double near);
double accurate_hypot(double x, double y);
double accurate_erf(double);

#endif
