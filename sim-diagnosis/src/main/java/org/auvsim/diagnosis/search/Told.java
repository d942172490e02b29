package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.cause.Quantity;

import java.util.ArrayList;
import java.util.List;

/**
 * The numbers of a cause as a fit leaves them. It moves each of which the data tells anything,
 * however little; one that stands at 0 but for rounding, and could have gone to either side, is not
 * determined: a current along an axis along which a mount holds the body.
 */
public final class Told {
    /** Of a parameter's scale. */
    private static final double ROUNDING = 1e-12;

    private Told() {}

    /** As people know them, NaN of those that are not determined. */
    public static List<Quantity> of(Cause cause, double[] theta) {
        List<Quantity> told = new ArrayList<>(cause.quantities(theta));
        for (int i = 0; i < theta.length && i < told.size(); i++) {
            Quantity of = told.get(i);
            if (isLeft(cause.parameters().get(i), theta[i], of)) {
                told.set(i, new Quantity(of.name(), of.unit(), Double.NaN));
            }
        }
        return told;
    }

    private static boolean isLeft(Parameter parameter, double theta, Quantity told) {
        boolean isItself = parameter.name().equals(told.name());
        boolean isAt0 = Math.abs(theta) <= ROUNDING * parameter.scale();
        return isItself && isAt0 && parameter.lowest() < 0 && parameter.highest() > 0;
    }
}
