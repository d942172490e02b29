package org.auvsim.core.actuator;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Numbers;

/**
 * Thrust as a polynomial of the level, the same ahead and astern: sign(x) (c1 |x| + c2 |x|^2 + ...)
 * at level x. A propeller at rest in the water pushes with c2 x |x| (Fossen 2021, section 9.4).
 *
 * @param coefficients c1, c2, ... (N)
 */
public record PolynomialThrust(@Unit("N") Numbers coefficients) implements ThrustCurve {
    /**
     * A checked polynomial.
     *
     * @throws IllegalArgumentException if there is no coefficient, or one is not finite
     */
    public PolynomialThrust {
        if (coefficients.size() == 0) {
            throw new IllegalArgumentException(
                    "a polynomial thrust needs at least one coefficient, that of the level");
        }
        for (int i = 0; i < coefficients.size(); i++) {
            Domain.finite(
                    "a polynomial thrust", "coefficient " + (i + 1), coefficients.get(i), "N");
        }
    }

    @Override
    public double thrust(double level) {
        double x = Math.abs(level);
        double sum = 0;
        for (int k = coefficients.size() - 1; k >= 0; k--) {
            sum = (sum + coefficients.get(k)) * x;
        }
        return level < 0 ? -sum : sum;
    }
}
