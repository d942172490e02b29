package org.auvsim.diagnosis.fit;

/** How much the steps of a descent need to be damped: it goes by how the last ones did. */
final class Damping {
    /** Steps that gain less of what they should are too long. */
    private static final double TOO_LITTLE = 0.25;

    /** Those that gain more of it may be longer. */
    private static final double NEARLY_ALL = 0.75;

    private static final double LEAST = 1e-3;
    private static final double MOST = 10;
    private static final double LESS = 0.1;

    private final Way way;
    private double last;

    Damping(Way way) {
        this.way = way;
    }

    /** How a step is damped. */
    @FunctionalInterface
    interface Way {
        Step damped(Step step, double damping);
    }

    /**
     * The best of where a step leads that is damped more and more, as long as that helps; the same
     * place if it leads nowhere.
     *
     * @param isExact whether its derivatives were taken there: else it is not worth more than one
     *     trial
     * @param worth what a step must promise to be worth more than that
     */
    Place next(Place from, Step step, boolean isExact, double worth) {
        Place reached = from;
        boolean helps = false;
        boolean goesOn = true;
        for (double by = last; goesOn; by = Math.max(LEAST, by / LESS)) {
            Step damped = by == 0 ? step : way.damped(step, by);
            double promise = from.cost() - damped.least();
            Place tried = Place.of(damped.end());
            double gain = from.cost() - tried.cost();
            boolean isBetter = tried.cost() < reached.cost();
            goesOn =
                    isExact
                            && by < MOST
                            && promise > worth
                            && gain < TOO_LITTLE * promise
                            && (isBetter || !helps);
            if (isBetter) {
                reached = tried;
                helps = true;
                last = gain > NEARLY_ALL * promise ? less(by) : by;
            }
        }
        return reached;
    }

    private static double less(double damping) {
        return damping > LEAST ? LESS * damping : 0;
    }
}
