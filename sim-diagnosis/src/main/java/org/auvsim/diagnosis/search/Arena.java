package org.auvsim.diagnosis.search;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.SingularValueDecomposition;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Measured runs cut into windows that the believed model can follow, in which variants of it
 * compete, side by side. Each window may begin otherwise, as far as its samples leave that open: so
 * a variant is not blamed for a start that was fitted under the model.
 */
public final class Arena {
    /** Singular values below this share of the largest are those of rounding. */
    private static final double ROUNDED = 1e-9;

    /** Of a whole search, the competition is this part. */
    private static final double BEGIN = 0.2;

    private static final double END = 0.4;

    private final Fit base;
    private final Course course;
    private final List<Ground> grounds = new ArrayList<>();

    /**
     * A window.
     *
     * @param starts orthonormal columns: what another start would change of its misses
     */
    private record Ground(int run, Window window, int samples, List<double[]> starts) {}

    /** On the windows of a fit. */
    Arena(Fit base, Course course) {
        this.base = base;
        this.course = course;
        List<List<WindowDerivatives>> derivatives = base.derivatives(WindowDerivatives.Moves.NONE);
        for (int r = 0; r < derivatives.size(); r++) {
            List<WindowDerivatives> ofRun = derivatives.get(r);
            for (int w = 0; w < ofRun.size(); w++) {
                Window window = ofRun.get(w).window;
                int samples = window.length() + (w == ofRun.size() - 1 ? 1 : 0);
                grounds.add(new Ground(r, window, samples, basis(ofRun.get(w).byStart)));
            }
        }
    }

    /** Orthonormal columns that span others (Golub and Van Loan 2013, section 2.4). */
    private static List<double[]> basis(double[][] columns) {
        RealMatrix matrix = new Array2DRowRealMatrix(columns).transpose();
        SingularValueDecomposition svd = new SingularValueDecomposition(matrix);
        double[] sizes = svd.getSingularValues();
        List<double[]> basis = new ArrayList<>();
        for (int i = 0; i < sizes.length && sizes[i] > ROUNDED * sizes[0]; i++) {
            basis.add(svd.getU().getColumn(i));
        }
        return basis;
    }

    /** The model as it is believed. */
    public BelievedModel model() {
        return base.model();
    }

    /**
     * Tells how far the competition is, and whether to go on.
     *
     * @param share of it that is over, 0 to 1
     */
    public boolean goesOn(double share) {
        return course.at("letting models compete", BEGIN + (END - BEGIN) * share);
    }

    /** The runs. */
    public List<MeasuredRun> runs() {
        return base.data().stream().map(Misses::run).toList();
    }

    /** How many samples the runs have. */
    public int samples() {
        return base.data().stream().mapToInt(misses -> misses.run().size()).sum();
    }

    /** How many numbers were measured. */
    public int count() {
        return base.data().stream().mapToInt(Misses::count).sum();
    }

    /** What the causes of a candidate must gain to be believed, as for all others. */
    public double price(Candidate candidate) {
        double independent = base.data().stream().mapToDouble(Misses::independent).sum();
        return candidate.hypothesis().price(count(), independent);
    }

    /**
     * What variants miss: sums of squares in standard deviations of the noise, infinite where a
     * motion gets out of all bounds.
     */
    public double[] misfits(List<Variant> variants) {
        List<double[]> byGround =
                grounds.parallelStream().map(ground -> misfits(ground, variants)).toList();
        double[] sum = new double[variants.size()];
        for (double[] misfits : byGround) {
            Arrays.setAll(sum, i -> sum[i] + misfits[i]);
        }
        return sum;
    }

    private double[] misfits(Ground ground, List<Variant> variants) {
        Misses of = base.data().get(ground.run());
        Window window = ground.window();
        RigidMotion[][] motions =
                Ensemble.simulate(
                        base.model(),
                        of.run(),
                        window.from(),
                        window.to(),
                        variants.stream().map(v -> new Entrant(v, window.start())).toList());
        double[] misfits = new double[variants.size()];
        for (int i = 0; i < misfits.length; i++) {
            double[] misses =
                    of.of(motions[i], variants.get(i).sensing(), window.from(), ground.samples());
            misfits[i] = squaresBeside(ground.starts(), misses);
        }
        return misfits;
    }

    /** Squares of what no other start could change. */
    private static double squaresBeside(List<double[]> basis, double[] misses) {
        double squares = 0;
        for (double miss : misses) {
            squares += miss * miss;
        }
        for (double[] column : basis) {
            double along = 0;
            for (int i = 0; i < misses.length; i++) {
                along += column[i] * misses[i];
            }
            squares -= along * along;
        }
        return Double.isNaN(squares) ? Double.POSITIVE_INFINITY : Math.max(0, squares);
    }

    /** Causes with numbers that do well in an arena. */
    public record Candidate(List<Cause> causes, List<double[]> theta) {
        /** The model with them. */
        public Variant in(Variant model) {
            return hypothesis().in(model);
        }

        private Hypothesis hypothesis() {
            return new Hypothesis(causes, theta);
        }
    }

    /** Another way to find sets of causes than by the columns of a screening. */
    @FunctionalInterface
    public interface Contest {
        /**
         * Sets of causes that are worth a closer look, the best first.
         *
         * @param causes to be chosen from
         */
        List<Candidate> candidates(Arena arena, List<Cause> causes);
    }
}
