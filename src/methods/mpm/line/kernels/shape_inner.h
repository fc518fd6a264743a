/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape functions of an inner cell at s in [0, 1), r = 1 - s; derivatives by s. Included by shape.h for
 * numbers and by the kernels for vectors of them (REAL), with the same operations.
 *
 *     hat        r, s
 *     bspline2   r^2/2, 1/2 + s r, s^2/2
 *     bspline3   r^3/6, 2/3 - s^2 (1 - s/2), 2/3 - r^2 (1 - r/2), s^3/6
 *     uGIMP      with L = max(h - s, 0), R = max(s - 1 + h, 0), the overlap with the neighbouring cells:
 *                L^2/4h, r - L^2/2h + R^2/4h, s + L^2/4h - R^2/2h, R^2/4h
 *     CPDI       with its own h of each particle, at most 1:
 *                L/2, r - L + R/2, s + L/2 - R, R/2;   derivatives as of uGIMP
 *
 * uGIMP is the hat averaged over the particle's width 2 h dx (Bardenhagen and Kober 2004): its corners are
 * rounded within h of a node. Written with L and R one formula serves inside and near either node; x + |x| is
 * exactly 2 max(x, 0). CPDI (Sadeghirad, Brannon and Burghardt 2011) takes the hat's mean from the two ends
 * of the particle's domain alone, N = (S(a) + S(b))/2 and N' = (S(b) - S(a))/(b - a), and lets the domain
 * follow the particle's stretch. */
static inline void SHAPE_INNER(MpmShape shape, const REAL *h_, const REAL *s_, REAL *n, REAL *dn)
{
    const REAL s = *s_, r = 1.0 - s;
    switch (shape) {
    case MPM_HAT:
        n[0] = r;
        n[1] = s;
        dn[0] = (REAL){0} - 1.0;
        dn[1] = (REAL){0} + 1.0;
        return;
    case MPM_GIMP: {
        const REAL h = *h_;
        REAL left = h - s, right = s - (1.0 - h);
        left = left + ABSOLUTE(left);
        right = right + ABSOLUTE(right);
        const REAL steepness = 0.25 / h;
        const REAL slope_left = left * steepness, slope_right = right * steepness;
        n[0] = 0.25 * (left * slope_left);
        n[3] = 0.25 * (right * slope_right);
        n[1] = r - 2.0 * n[0] + n[3];
        n[2] = s + n[0] - 2.0 * n[3];
        dn[0] = -slope_left;
        dn[3] = slope_right;
        dn[1] = 2.0 * slope_left + slope_right - 1.0;
        dn[2] = 1.0 - slope_left - 2.0 * slope_right;
        return;
    }
    case MPM_CPDI: {
        const REAL h = *h_;
        REAL left = h - s, right = s - (1.0 - h);
        left = left + ABSOLUTE(left);
        right = right + ABSOLUTE(right);
        const REAL steepness = 0.25 / h;
        const REAL slope_left = left * steepness, slope_right = right * steepness;
        n[0] = 0.25 * left;
        n[3] = 0.25 * right;
        n[1] = r - 2.0 * n[0] + n[3];
        n[2] = s + n[0] - 2.0 * n[3];
        dn[0] = -slope_left;
        dn[3] = slope_right;
        dn[1] = 2.0 * slope_left + slope_right - 1.0;
        dn[2] = 1.0 - slope_left - 2.0 * slope_right;
        return;
    }
    case MPM_BSPLINE2:
        n[0] = 0.5 * (r * r);
        n[1] = 0.5 + s * r;
        n[2] = 0.5 * (s * s);
        dn[0] = -r;
        dn[1] = r - s;
        dn[2] = s;
        return;
    case MPM_BSPLINE3: {
        const REAL ss = s * s, rr = r * r;
        n[0] = rr * r * (1.0 / 6.0);
        n[1] = (2.0 / 3.0) - ss * (1.0 - 0.5 * s);
        n[2] = (2.0 / 3.0) - rr * (1.0 - 0.5 * r);
        n[3] = ss * s * (1.0 / 6.0);
        dn[0] = -0.5 * rr;
        dn[1] = s * (1.5 * s - 2.0);
        dn[2] = r * (2.0 - 1.5 * r);
        dn[3] = 0.5 * ss;
        return;
    }
    }
}
