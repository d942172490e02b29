package org.auvsim.diagnosis.genetic;

import org.apache.commons.math3.stat.regression.SimpleRegression;

import java.util.List;

/**
 * A formula in the scale that fits best: the search has to find its form alone (Keijzer 2003).
 *
 * @param share of the variance that it imitates, 0 to 1
 */
record Formula(Expression form, double offset, double factor, double share) {
    /** A form scaled to samples; a constant if it is the same in all of them. */
    static Formula scaled(Expression form, List<Sample> samples) {
        SimpleRegression line = new SimpleRegression();
        for (Sample sample : samples) {
            line.addData(form.at(sample.variables()), sample.force());
        }
        double share = line.getRSquare();
        return Double.isFinite(share)
                ? new Formula(form, line.getIntercept(), line.getSlope(), share)
                : new Formula(form, mean(samples), 0, 0);
    }

    private static double mean(List<Sample> samples) {
        return samples.stream().mapToDouble(Sample::force).average().orElse(0);
    }

    /** A force (N) and what is known where it was missing. */
    static final class Sample {
        private final double[] variables;
        private final double force;

        Sample(double[] variables, double force) {
            this.variables = variables;
            this.force = force;
        }

        /** In the order of their names; not to be changed. */
        double[] variables() {
            return variables;
        }

        double force() {
            return force;
        }
    }

    double at(double[] variables) {
        return offset + factor * form.at(variables);
    }

    /** Share of the variance of other samples that it imitates; below 0 if it makes them worse. */
    double shareOf(List<Sample> others) {
        double mean = mean(others);
        double left = 0;
        double all = 0;
        for (Sample sample : others) {
            double miss = sample.force() - at(sample.variables());
            left += miss * miss;
            all += (sample.force() - mean) * (sample.force() - mean);
        }
        return all > 0 ? 1 - left / all : 0;
    }

    String text() {
        return "%s + %s * %s"
                .formatted(
                        Expression.Constant.text(offset, 3),
                        Expression.Constant.text(factor, 3),
                        form.text());
    }
}
