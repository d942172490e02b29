package org.auvsim.diagnosis.shooting;

import org.auvsim.diagnosis.model.Variant;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Arrays;
import java.util.List;

/**
 * What a window misses of the measurement, and how that and its end depend on its start and on
 * parameters of causes.
 */
public final class WindowDerivatives {
    /** The window that was simulated. */
    public final Window window;

    /** Of the samples, row by row, in standard deviations. */
    public final double[] misses;

    /** Derivatives of the misses by each number of the start. */
    public final double[][] byStart;

    /** The same by each parameter. */
    public final double[][] byParameter;

    /** At each sample, the first of the next window included. */
    public final RigidMotion[] motion;

    /** The window's end, and its derivatives. */
    public final RigidMotion end;

    final double[][] endByStart;
    final double[][] endByParameter;

    /**
     * What is moved to find derivatives by parameters.
     *
     * @param variants the model with one parameter moved, each
     * @param steps by how much
     */
    public record Moves(List<Variant> variants, List<Double> steps) {
        /** No parameter is moved. */
        public static final Moves NONE = new Moves(List.of(), List.of());

        /** How many parameters are moved. */
        public int size() {
            return steps.size();
        }
    }

    /**
     * Of a window.
     *
     * @param slopes derivatives of the misses, those by the numbers of the start first
     * @param endSlopes those of the end alike
     */
    WindowDerivatives(
            Window window,
            RigidMotion[] motion,
            double[] misses,
            double[][] slopes,
            double[][] endSlopes) {
        this.window = window;
        this.motion = motion;
        this.misses = misses;
        this.end = motion[window.length()];
        byStart = Arrays.copyOf(slopes, RigidMotion.SIZE);
        endByStart = Arrays.copyOf(endSlopes, RigidMotion.SIZE);
        byParameter = Arrays.copyOfRange(slopes, RigidMotion.SIZE, slopes.length);
        endByParameter = Arrays.copyOfRange(endSlopes, RigidMotion.SIZE, slopes.length);
    }

    private WindowDerivatives(
            WindowDerivatives of, double[][] byParameter, double[][] endByParameter) {
        window = of.window;
        misses = of.misses;
        byStart = of.byStart;
        motion = of.motion;
        end = of.end;
        endByStart = of.endByStart;
        this.byParameter = byParameter;
        this.endByParameter = endByParameter;
    }

    private WindowDerivatives(
            WindowDerivatives of, Window window, RigidMotion[] motion, double[] misses) {
        this.window = window;
        this.misses = misses;
        this.motion = motion;
        end = motion[window.length()];
        byStart = of.byStart;
        endByStart = of.endByStart;
        byParameter = of.byParameter;
        endByParameter = of.endByParameter;
    }

    /** The same with derivatives by other parameters. */
    public WindowDerivatives by(double[][] byParameter, double[][] endByParameter) {
        return new WindowDerivatives(this, byParameter, endByParameter);
    }

    /** The same derivatives where the window is elsewhere. */
    WindowDerivatives at(Window elsewhere, RigidMotion[] itsMotion, double[] itsMisses) {
        return new WindowDerivatives(this, elsewhere, itsMotion, itsMisses);
    }

    /** Square of how much a parameter moves all numbers together (standard deviations a unit). */
    public double squares(int parameter) {
        double sum = 0;
        for (double slope : byParameter[parameter]) {
            sum += slope * slope;
        }
        return sum;
    }

    /** Whether its motion got out of all bounds. */
    public boolean isLost() {
        return Double.isNaN(end.position().x());
    }
}
