package org.auvsim.core.effect;

/** The power that quadratic damping of two coupled axes takes. */
final class CubicForm {
    /** What the form may be below zero by rounding, relative to its terms. */
    private static final double ROUNDING = 1e-12;

    private CubicForm() {}

    /**
     * Whether a |x| x^2 + c |x| x y + d |y| y x + b |y| y^2 is 0 or more for all x and y. With t =
     * |y/x| that is a + c t + d t^2 + b t^3 for two velocities of one sign, and the same with -c
     * and -d for two of opposite signs; both are tested at their lowest place.
     *
     * @param a own element of x, 0 or more
     * @param c of y's force by x
     * @param d of x's force by y
     * @param b own element of y, 0 or more
     */
    static boolean isNeverNegative(double a, double c, double d, double b) {
        if (b == 0) {
            return c == 0 && d == 0;
        }
        return isNeverNegativeAhead(a, c, d, b) && isNeverNegativeAhead(a, -c, -d, b);
    }

    /** a + c t + d t^2 + b t^3 for all t from 0 on. */
    private static boolean isNeverNegativeAhead(double a, double c, double d, double b) {
        double discriminant = d * d - 3 * b * c;
        double t = discriminant > 0 ? (Math.sqrt(discriminant) - d) / (3 * b) : 0;
        if (!(t > 0)) {
            return true;
        }
        double sum = a + t * (c + t * (d + t * b));
        double size = a + t * (Math.abs(c) + t * (Math.abs(d) + t * b));
        return sum >= -ROUNDING * size;
    }
}
