/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The elementary functions: correctly rounded, by MPFR where it is installed and by their own slow way, at
 * random arguments and at those that are known to lie nearest to the middle of two doubles. The quick way's
 * bounds of error are measured: hence the source itself. */
#include "base/math/functions.c"

#include "suite.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef HAVE_MPFR
#include <mpfr.h>
#endif

enum { SHORT = 4000, LONG = 1000000 };

static long arguments(void)
{
    return getenv("MATVIB_LONG") ? LONG : SHORT;
}

static uint64_t state = 88172645463325252u;

static double uniform(double low, double high)
{
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return low + (high - low) * (double)(state >> 11) * 0x1p-53;
}

/* of any size from low to high, either sign where low < 0: then from -high */
static double drawn(double low, double high)
{
    const double size = math_exp(uniform(math_log(fabs(low)), math_log(high)));
    return low < 0 && uniform(0, 1) < 0.5 ? -size : size;
}

static bool same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

/* the slow way's */
static double slow_asin(double x)
{
    return accurate_asin(x, math_asin(x));
}
static double slow_acos(double x)
{
    return accurate_acos(x, math_acos(x));
}
static double slow_atan(double x)
{
    return accurate_atan2(x, 1, math_atan(x));
}
static double slow_log(double x)
{
    return accurate_log(x, math_log(x));
}
static double slow_log10(double x)
{
    return accurate_log10(x, math_log(x));
}
static double slow_log1p(double x)
{
    return accurate_log1p(x, math_log1p(x));
}
static double slow_pow(double x, double y)
{
    return accurate_pow(x, y, math_log(x));
}
static double slow_atan2(double y, double x)
{
    return accurate_atan2(y, x, math_atan2(y, x));
}

typedef double Function(double);
typedef double FunctionOfTwo(double, double);

#ifdef HAVE_MPFR
typedef int Judge(mpfr_t, const mpfr_t, mpfr_rnd_t);
typedef int JudgeOfTwo(mpfr_t, const mpfr_t, const mpfr_t, mpfr_rnd_t);
#define BY(name) mpfr_##name
#else
typedef void Judge(void);
typedef void JudgeOfTwo(void);
#define BY(name) NULL
#endif

static const struct {
    const char *name;
    Function *function, *slow;
    Judge *judge;
    double low, high;
    double hard[3];
} rows[] = {
    {"sin",
     math_sin,
     accurate_sin,
     BY(sin),
     -1e-9,
     1e9,
     {0x1.598bae9e632f6p-7, 0x1.1fa4f6c3eb138p+10, 0x1.1c63df63d59dp-2}},
    {"sin",
     math_sin,
     accurate_sin,
     BY(sin),
     -1e-300,
     1e308,
     {0x1.6ac5b262ca1ffp+849, 0x1p+1023, 0x1.921fb54442d18p+1}},
    {"cos",
     math_cos,
     accurate_cos,
     BY(cos),
     -1e-9,
     1e9,
     {0x1.34ec2f9fc9cp+1, 0x1.6b8a6273d7c21p+0, 0x1.f849414ea93b6p-6}},
    {"cos",
     math_cos,
     accurate_cos,
     BY(cos),
     -1e9,
     1e308,
     {0x1.6ac5b262ca1ffp+849, 0x1p+1023, 0x1.921fb54442d18p+0}},
    {"asin",
     math_asin,
     slow_asin,
     BY(asin),
     -1e-9,
     1,
     {0x1.c373ff4aad79bp-14, 0x1.a4816b2066707p-5, 0x1.7137449123ef6p-26}},
    {"acos",
     math_acos,
     slow_acos,
     BY(acos),
     -1e-9,
     1,
     {0x1.53ea6c7255e88p-4, 0x1.cf37d41c69889p-24, 0x1.2c759e3848cc8p-13}},
    {"atan",
     math_atan,
     slow_atan,
     BY(atan),
     -1e-9,
     1e9,
     {0x1.6298b5896ed3cp+1, 0x1.22e8d75e2bc7fp-11, 0x1.ccda26ad0cd1cp+47}},
    {"atan", math_atan, slow_atan, BY(atan), -1e-310, 1e308, {0x1p-1074, 0x1p-1022, 0x1p+1023}},
    {"sinh",
     math_sinh,
     accurate_sinh,
     BY(sinh),
     -1e-9,
     711,
     {0x1.897374d74de2ap-13, 0x1.bcee70ebe7ec9p-25, 0x1.e72460254649ap-19}},
    {"cosh",
     math_cosh,
     accurate_cosh,
     BY(cosh),
     -1e-9,
     711,
     {0x1.ea5f2f2e4b0c5p+1, 0x1.da5df035e5e8dp-22, 0x1p-26}},
    {"exp",
     math_exp,
     accurate_exp,
     BY(exp),
     -1e-9,
     745,
     {-0x1.12d31a20fb38bp+5, 0x1.9e9cbbfd6080bp-31, 0x1.ffff7fffe0001p-36}},
    {"expm1",
     math_expm1,
     accurate_expm1,
     BY(expm1),
     -1e-300,
     37,
     {0x1.274bbf1efb1a2p-10, 0x1.51fce10251a48p-16, 0x1.a31972381bd0cp-23}},
    {"log",
     math_log,
     slow_log,
     BY(log),
     1e-310,
     1e308,
     {0x1.fd15daa6ce332p+732, 0x1.62a88613629b6p+678, 0x1.be87838f1a47cp+774}},
    {"log",
     math_log,
     slow_log,
     BY(log),
     0.5,
     2,
     {0x1.0000000000001p+0, 0x1.fffffffffffffp-1, 0x1.0020000000001p+0}},
    {"log10",
     math_log10,
     slow_log10,
     BY(log10),
     1e-310,
     1e308,
     {0x1.e12d66744ff81p+429, 0x1.ed8c87c3bf5cfp-49, 0x1.c295d530e7d8fp+184}},
    {"log1p", math_log1p, slow_log1p, BY(log1p), -1e-300, 0.99, {-0x1.fffffffffffffp-1, 0x1p-52, 0x1p-53}},
    {"log1p", math_log1p, slow_log1p, BY(log1p), 0.1, 1e308, {0x1p+53, 0x1.fffffffffffffp-1, 1}},
    {"erf",
     math_erf,
     accurate_erf,
     BY(erf),
     -1e-9,
     5.9,
     {0x1.51f3182edb17ap-36, 0x1.52b76545cc8efp-6, 0x1.2759b6d41c68ep-29}},
};

static const struct {
    const char *name;
    FunctionOfTwo *function, *slow;
    JudgeOfTwo *judge;
    double low, high, low_2, high_2;
    double hard[3][2];
} rows_of_two[] = {
    {"pow",
     math_pow,
     slow_pow,
     BY(pow),
     1e-3,
     1e3,
     -1e-3,
     1e2,
     {{0x1.ffffffffffffcp-1, 0x1.fffffffffffffp-2},
      {0x1.ffffffffffff8p-1, -0x1.ffffffffffffbp-3},
      {0x1.8000001p+26, 2}}},
    {"pow", math_pow, slow_pow, BY(pow), 0.999, 1.001, -1, 1e5, {{10, -308}, {10, 22}, {10, -5}}},
    {"pow", math_pow, slow_pow, BY(pow), 1e-200, 1e200, 2, 2, {{3e-160, 2}, {1e154, 2}, {0x1p-538, 2}}},
    {"pow", math_pow, slow_pow, BY(pow), 1e-100, 1e100, 4, 4, {{3e-80, 4}, {1e77, 4}, {0x1.8p13, 4}}},
    {"atan2",
     math_atan2,
     slow_atan2,
     BY(atan2),
     -1e-6,
     1e6,
     -1e-6,
     1e6,
     {{0x1.07a11ffd843abp+53, 0x1.f9982dddc9cccp+52},
      {0x1.fffffffffffffp-542, 0x1p+481},
      {0x1.8c48c7e9f59bbp+69, 0x1.4c7775f720a8dp+53}}},
    {"hypot",
     math_hypot,
     accurate_hypot,
     BY(hypot),
     -1e-6,
     1e6,
     -1e-6,
     1e6,
     {{0x1.1732e04bf1488p-1, 0x1.0b590d18d9545p-27},
      {0x1.ebb047b11d3ccp-1, 0x1.62c8eb079b539p-27},
      {0x1.9a4d68bfabb24p-1, 0x1.441841c2157f4p-27}}},
};

/* --- by MPFR --------------------------------------------------------------------------------------- */

#ifdef HAVE_MPFR
/* doubles: 53 bits, exponents to 1024, subnormal ones from -1073 */
static double judged(int k, bool of_two, double x, double y)
{
    static mpfr_t a, b, result;
    static bool ready;
    if (!ready)
        mpfr_inits2(53, a, b, result, (mpfr_ptr)0), ready = true;
    mpfr_set_emin(-1073), mpfr_set_emax(1024);
    mpfr_set_d(a, x, MPFR_RNDN);
    mpfr_set_d(b, y, MPFR_RNDN);
    const int side =
        of_two ? rows_of_two[k].judge(result, a, b, MPFR_RNDN) : rows[k].judge(result, a, MPFR_RNDN);
    mpfr_subnormalize(result, side, MPFR_RNDN);
    return mpfr_get_d(result, MPFR_RNDN);
}
#endif

/* --- cases ----------------------------------------------------------------------------------------- */

static void expect(int k, double x)
{
    const double got = rows[k].function(x);
#ifdef HAVE_MPFR
    const double wanted = judged(k, false, x, 0);
#else
    const double wanted = rows[k].slow(x);
#endif
    ck_assert_msg(same(got, wanted), "%s(%a) is %a, not %a", rows[k].name, x, got, wanted);
}

static void expect_of_two(int k, double x, double y)
{
    const double got = rows_of_two[k].function(x, y);
#ifdef HAVE_MPFR
    const double wanted = judged(k, true, x, y);
#else
    const double wanted = rows_of_two[k].slow(x, y);
#endif
    ck_assert_msg(same(got, wanted), "%s(%a, %a) is %a, not %a", rows_of_two[k].name, x, y, got, wanted);
}

START_TEST(functions_are_correctly_rounded)
{
    for (long i = 0; i < arguments(); i++)
        expect(_i, drawn(rows[_i].low, rows[_i].high));
    for (int i = 0; i < 3; i++)
        expect(_i, rows[_i].hard[i]);
}
END_TEST

START_TEST(functions_of_two_are_correctly_rounded)
{
    for (long i = 0; i < arguments(); i++)
        expect_of_two(_i, drawn(rows_of_two[_i].low, rows_of_two[_i].high),
                      drawn(rows_of_two[_i].low_2, rows_of_two[_i].high_2));
    for (int i = 0; i < 3; i++)
        expect_of_two(_i, rows_of_two[_i].hard[i][0], rows_of_two[_i].hard[i][1]);
}
END_TEST

/* the slow way decides one call in a thousand: here all, where MPFR may be missing too */
START_TEST(both_ways_agree)
{
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++)
        for (int i = 0; i < 100; i++) {
            const double x = drawn(rows[k].low, rows[k].high), quick = rows[k].function(x),
                         slow = rows[k].slow(x);
            ck_assert_msg(same(quick, slow), "%s(%a) is %a, slowly %a", rows[k].name, x, quick, slow);
        }
    for (size_t k = 0; k < sizeof rows_of_two / sizeof *rows_of_two; k++)
        for (int i = 0; i < 100; i++) {
            const double x = drawn(rows_of_two[k].low, rows_of_two[k].high);
            const double y = drawn(rows_of_two[k].low_2, rows_of_two[k].high_2);
            ck_assert(same(rows_of_two[k].function(x, y), rows_of_two[k].slow(x, y)));
        }
}
END_TEST

/* digits to compare with where there is no MPFR: its own, of the hardest arguments known */
START_TEST(hardest_arguments)
{
    static const struct {
        Function *function;
        double x, value;
    } known[] = {
        {math_sin, 0x1.598bae9e632f6p-7, 0x1.598a0aea48996p-7},
        {math_cos, 0x1.34ec2f9fc9cp+1, -0x1.7e2a5c30e1d6dp-1},
        {math_asin, 0x1.c373ff4aad79bp-14, 0x1.c373ff594d65bp-14},
        {math_acos, 0x1.53ea6c7255e88p-4, 0x1.7cdacb6bbe707p+0},
        {math_atan, 0x1.6298b5896ed3cp+1, 0x1.3970e827504c7p+0},
        {math_sinh, 0x1.897374d74de2ap-13, 0x1.897374fe073e2p-13},
        {math_cosh, 0x1.ea5f2f2e4b0c5p+1, 0x1.710db0cd0fed6p+4},
        {math_exp, -0x1.12d31a20fb38bp+5, 0x1.5b0bf3244820ap-50},
        {math_expm1, 0x1.274bbf1efb1a2p-10, 0x1.2776572c2512ap-10},
        {math_log, 0x1.fd15daa6ce332p+732, 0x1.fc12387d0632ap+8},
        {math_log10, 0x1.e12d66744ff81p+429, 0x1.02d4f53729e45p+7},
        {math_erf, 0x1.51f3182edb17ap-36, 0x1.7d55d48a2fd8dp-36},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        ck_assert_msg(known[i].function(known[i].x) == known[i].value, "row %zu: %a", i,
                      known[i].function(known[i].x));
    ck_assert(math_atan2(0x1.07a11ffd843abp+53, 0x1.f9982dddc9cccp+52) == 0x1.9cdc92285bd59p-1);
    ck_assert(math_hypot(0x1.1732e04bf1488p-1, 0x1.0b590d18d9545p-27) == 0x1.1732e04bf1488p-1);
    ck_assert(math_hypot(3, 4) == 5 && math_hypot(3e-320, 4e-320) == 5e-320);
    for (int n = -323; n <= 308; n++) {
        char text[16];
        snprintf(text, sizeof text, "1e%d", n);
        ck_assert_msg(math_pow(10, n) == strtod(text, NULL), "%s", text);
    }
}
END_TEST

/* C17, annex F.10: what the values are where there is no number to round */
START_TEST(limits_are_those_of_the_standard)
{
    const double inf = INFINITY;
    const struct {
        double got, wanted;
    } limits[] = {
        {math_sin(-0.0), -0.0},
        {math_sin(inf), NAN},
        {math_cos(inf), NAN},
        {math_cos(0), 1},
        {math_asin(1), pi.high / 2},
        {math_asin(-0.0), -0.0},
        {math_asin(1.5), NAN},
        {math_acos(1), 0},
        {math_acos(-1), pi.high},
        {math_acos(0), pi.high / 2},
        {math_acos(-2), NAN},
        {math_atan(-0.0), -0.0},
        {math_atan(-inf), -pi.high / 2},
        {math_atan2(0, -0.0), pi.high},
        {math_atan2(-0.0, 1), -0.0},
        {math_atan2(-0.0, -1), -pi.high},
        {math_atan2(2, 0), pi.high / 2},
        {math_atan2(inf, inf), pi.high / 4},
        {math_atan2(-inf, -inf), -0.75 * pi.high},
        {math_atan2(1, -inf), pi.high},
        {math_atan2(-1, inf), -0.0},
        {math_atan2(1, NAN), NAN},
        {math_sinh(-0.0), -0.0},
        {math_sinh(-inf), -inf},
        {math_sinh(720), inf},
        {math_cosh(-inf), inf},
        {math_cosh(0), 1},
        {math_exp(0), 1},
        {math_exp(-inf), 0},
        {math_exp(inf), inf},
        {math_exp(-800), 0},
        {math_exp(0x1.62e42fefa39efp+9), 0x1.fffffffffff2ap+1023},
        {math_exp(-745.1), 0x1p-1074},
        {math_expm1(-0.0), -0.0},
        {math_expm1(-inf), -1},
        {math_expm1(inf), inf},
        {math_log(0), -inf},
        {math_log(-0.0), -inf},
        {math_log(1), 0},
        {math_log(-1), NAN},
        {math_log(inf), inf},
        {math_log10(1000), 3},
        {math_log10(1e-5), -5},
        {math_log1p(-0.0), -0.0},
        {math_log1p(-1), -inf},
        {math_log1p(-2), NAN},
        {math_log1p(inf), inf},
        {math_pow(NAN, 0), 1},
        {math_pow(1, NAN), 1},
        {math_pow(-0.0, -3), -inf},
        {math_pow(0, -2), inf},
        {math_pow(-0.0, 3), -0.0},
        {math_pow(-1, inf), 1},
        {math_pow(0.5, -inf), inf},
        {math_pow(-inf, -3), -0.0},
        {math_pow(-inf, 3), -inf},
        {math_pow(-8, 3), -512},
        {math_pow(-8, 0.5), NAN},
        {math_pow(2, 2000), inf},
        {math_pow(2, -1074), 0x1p-1074},
        {math_pow(2, -1080), 0},
        {math_pow(3, 1e-200), 1},
        {math_pow(-1, 0x1p60), 1},
        {math_hypot(-inf, NAN), inf},
        {math_hypot(NAN, 1), NAN},
        {math_hypot(-3, 0), 3},
        {math_hypot(0, -0.0), 0},
        {math_erf(-0.0), -0.0},
        {math_erf(-inf), -1},
        {math_erf(7), 1},
    };
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++)
        ck_assert_msg(same(limits[i].got, limits[i].wanted), "row %zu: %a, not %a", i, limits[i].got,
                      limits[i].wanted);
    static Function *const of_nan[] = {math_sin,   math_cos,   math_asin, math_acos,  math_atan,
                                       math_sinh,  math_cosh,  math_exp,  math_expm1, math_log,
                                       math_log10, math_log1p, math_erf};
    for (size_t i = 0; i < sizeof of_nan / sizeof *of_nan; i++)
        ck_assert(isnan(of_nan[i](NAN)));
}
END_TEST

/* --- the quick way's errors ------------------------------------------------------------------------ */

#ifdef HAVE_MPFR
static DoubleDouble quick_sine(double x)
{
    return sine(reduced(x), 0);
}
static DoubleDouble quick_cosine(double x)
{
    return sine(reduced(x), 1);
}
static DoubleDouble quick_exp(double x)
{
    return exponential(exact(x));
}
static DoubleDouble quick_log(double x)
{
    return logarithm(exact(x));
}
static DoubleDouble quick_atan(double x)
{
    return angle_of(exact(x), exact(1));
}
static DoubleDouble quick_acos(double x)
{
    return angle_of(other_leg(x), exact(x));
}
static DoubleDouble quick_sinh(double x)
{
    return dd_scaled(double_sinh(x), 0.5);
}
static DoubleDouble quick_cosh(double x)
{
    return dd_scaled(double_cosh(x), 0.5);
}
static const struct {
    const char *name;
    DoubleDouble (*quick)(double);
    Judge *judge;
    double low, high, bound;
} errors[] = {
    {"sin", quick_sine, BY(sin), 1e-3, 1e9, ERROR_SINE},
    {"sin", quick_sine, BY(sin), 1e-3, 1, ERROR_SINE},
    {"cos", quick_cosine, BY(cos), 1e-3, 1e9, ERROR_SINE},
    {"exp", quick_exp, BY(exp), -1e-6, 680, ERROR_EXP},
    {"expm1", small_expm1, BY(expm1), -1e-6, 0.34, ERROR_EXPM1},
    {"sinh", quick_sinh, BY(sinh), 1e-6, 0.34, ERROR_EXPM1},
    {"sinh", quick_sinh, BY(sinh), 0.34, 680, ERROR_SINH},
    {"cosh", quick_cosh, BY(cosh), 1e-6, 680, ERROR_EXP},
    {"erf", double_erf, BY(erf), 1e-6, 5.9, ERROR_ERF},
    {"log", quick_log, BY(log), 1e-300, 1e300, ERROR_LOG},
    {"log", quick_log, BY(log), 0.7, 1.4, ERROR_LOG},
    {"atan", quick_atan, BY(atan), 1e-6, 1e6, ERROR_ANGLE},
    {"acos", quick_acos, BY(acos), 1e-6, 1, ERROR_ANGLE},
};

START_TEST(quick_results_are_better_than_they_claim)
{
    mpfr_t x, wanted, got;
    mpfr_inits2(200, x, wanted, got, (mpfr_ptr)0);
    mpfr_set_emin(mpfr_get_emin_min()), mpfr_set_emax(mpfr_get_emax_max());
    double worst = 0;
    for (long i = 0; i < arguments(); i++) {
        mpfr_set_d(x, drawn(errors[_i].low, errors[_i].high), MPFR_RNDN);
        const DoubleDouble value = errors[_i].quick(mpfr_get_d(x, MPFR_RNDN));
        if (isnan(value.high))
            continue;
        errors[_i].judge(wanted, x, MPFR_RNDN);
        mpfr_set_d(got, value.high, MPFR_RNDN);
        mpfr_add_d(got, got, value.low, MPFR_RNDN);
        mpfr_reldiff(got, wanted, got, MPFR_RNDN);
        worst = fmax(worst, mpfr_get_d(got, MPFR_RNDN));
    }
    mpfr_clears(x, wanted, got, (mpfr_ptr)0);
    ck_assert_msg(worst > 0 && worst < errors[_i].bound / 2, "%s: 2^%.2f, claimed 2^%.2f", errors[_i].name,
                  math_log(worst) / M_LN2, math_log(errors[_i].bound) / M_LN2);
}
END_TEST
#endif

#ifdef HAVE_MPFR
/* near multiples of pi/2, where of x - k pi/2 little is left */
START_TEST(angles_are_reduced_to_the_last_bits)
{
    mpfr_t x, wanted, got;
    mpfr_inits2(200, x, wanted, got, (mpfr_ptr)0);
    mpfr_set_emin(mpfr_get_emin_min()), mpfr_set_emax(mpfr_get_emax_max());
    long judged = 0;
    for (long i = 0; i < arguments(); i++) {
        const double k = floor(drawn(1, 6e8)), at = k * (pi.high / 2);
        const DoubleDouble value = sine(reduced(at), (int)((long)k & 1));
        if (isnan(value.high))
            continue;
        mpfr_set_d(x, at, MPFR_RNDN);
        (long)k & 1 ? mpfr_cos(wanted, x, MPFR_RNDN) : mpfr_sin(wanted, x, MPFR_RNDN);
        mpfr_set_d(got, value.high, MPFR_RNDN);
        mpfr_add_d(got, got, value.low, MPFR_RNDN);
        mpfr_reldiff(got, wanted, got, MPFR_RNDN);
        const double error = mpfr_get_d(got, MPFR_RNDN);
        ck_assert_msg(error < ERROR_SINE, "%a: 2^%.2f", at, math_log(error) / M_LN2);
        judged++;
    }
    mpfr_clears(x, wanted, got, (mpfr_ptr)0);
    ck_assert_int_gt(judged, arguments() / 2);
}
END_TEST
#endif

void add_cases(Suite *suite)
{
    TCase *rounding = tcase_create("rounding");
    tcase_add_loop_test(rounding, functions_are_correctly_rounded, 0, (int)(sizeof rows / sizeof *rows));
    tcase_add_loop_test(rounding, functions_of_two_are_correctly_rounded, 0,
                        (int)(sizeof rows_of_two / sizeof *rows_of_two));
    tcase_add_test(rounding, both_ways_agree);
    tcase_add_test(rounding, hardest_arguments);
    tcase_add_test(rounding, limits_are_those_of_the_standard);
#ifdef HAVE_MPFR
    tcase_add_test(rounding, angles_are_reduced_to_the_last_bits);
    tcase_add_loop_test(rounding, quick_results_are_better_than_they_claim, 0,
                        (int)(sizeof errors / sizeof *errors));
#endif
    suite_add_tcase(suite, rounding);
}
