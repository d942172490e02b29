package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Quantity;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** How well the parameters of a fit are determined: the covariance at its optimum. */
final class Uncertainty {
    private final Judged fitted;
    private final double[][] information;

    /** That of a fit that has converged. */
    Uncertainty(Judged fitted) {
        this.fitted = fitted;
        Fit fit = fitted.fit();
        int size = fit.hypothesis().size();
        int[] all = IntStream.range(0, size).toArray();
        Gram gram = Gram.of(fit.blocks(fit.derivatives(), 1), size);
        information = gram.information(all);
        double excess = Math.max(1, fitted.cost() / fitted.outcome().count());
        for (double[] row : information) {
            for (int i = 0; i < row.length; i++) {
                row[i] /= excess;
            }
        }
    }

    /** What the fit says of its parameters to whoever looks at other runs. */
    Knowledge knowledge() {
        return new Knowledge(fitted.fit().hypothesis().numbers(), information);
    }

    private RealMatrix covariance() {
        return new SingularValueDecomposition(new Array2DRowRealMatrix(information))
                .getSolver()
                .getInverse();
    }

    /** Standard deviations of the quantities of one of the causes. */
    List<Double> deviations(int cause) {
        Hypothesis hypothesis = fitted.fit().hypothesis();
        int first = 0;
        for (int c = 0; c < cause; c++) {
            first += hypothesis.theta().get(c).length;
        }
        double[] theta = hypothesis.theta().get(cause);
        RealMatrix part =
                covariance()
                        .getSubMatrix(
                                first, first + theta.length - 1, first, first + theta.length - 1);
        RealMatrix slopes = slopes(hypothesis.causes().get(cause), theta);
        RealMatrix ofQuantities = slopes.multiply(part).multiply(slopes.transpose());
        return IntStream.range(0, ofQuantities.getRowDimension())
                .mapToObj(q -> Math.sqrt(Math.max(0, ofQuantities.getEntry(q, q))))
                .toList();
    }

    private static RealMatrix slopes(Cause cause, double[] theta) {
        List<Quantity> here = cause.quantities(theta);
        RealMatrix slopes = new Array2DRowRealMatrix(here.size(), theta.length);
        for (int p = 0; p < theta.length; p++) {
            double step = Cause.SMALL * cause.parameters().get(p).scale();
            double[] moved = theta.clone();
            moved[p] += step;
            List<Quantity> there = new ArrayList<>(cause.quantities(moved));
            for (int q = 0; q < here.size(); q++) {
                slopes.setEntry(q, p, (there.get(q).value() - here.get(q).value()) / step);
            }
        }
        return slopes;
    }
}
