package org.auvsim.diagnosis.shooting;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Windows that follow one another without a gap, with one free start (Bock's condensing): a change
 * of the start, or of a parameter, runs through all of them along the measured motion. With x = (12
 * numbers of the start, parameters, 1) the misses are linear; the start is then projected out.
 */
public final class WindowBlock {
    private static final int START = RigidMotion.SIZE;

    /** So far off (m, rad, m/s, rad/s) a start that is not known may be. */
    private static final double[] UNKNOWN = {1e3, 1e1, 1e2, 1e2};

    /** By so much a number of a start moves that the run does not show. */
    public static final double NOTHING = 1e-6;

    private final BelievedModel model;
    private final List<WindowDerivatives> windows;
    private final int columns;

    /** By window: its start's 12 numbers as a linear function of x; at last, the end of all. */
    private final List<double[][]> chain = new ArrayList<>();

    /** Rows of misses as a linear function of x, then made triangular in its first 12. */
    private final double[][] rows;

    /**
     * A block of windows.
     *
     * @param shown whether the run tells anything of each number of a start; the others stay
     * @param known of the first window's start
     */
    public WindowBlock(
            BelievedModel model,
            List<WindowDerivatives> windows,
            boolean[] shown,
            Optional<KnownStart> known) {
        this.model = model;
        this.windows = windows;
        columns = START + windows.getFirst().byParameter.length + 1;
        int count = START;
        for (WindowDerivatives window : windows) {
            count += window.misses.length;
        }
        rows = new double[columns][count];
        startRows(shown, known);
        int row = START;
        double[][] at = identity();
        for (int w = 0; w < windows.size(); w++) {
            chain.add(at);
            WindowDerivatives window = windows.get(w);
            row = missRows(window, at, row);
            boolean isLast = w + 1 == windows.size();
            at = next(window, at, isLast ? window.end : windows.get(w + 1).window.start());
        }
        chain.add(at);
        triangulate(count);
    }

    /** The same; of its rows those of the start, which alone change, come first. */
    private WindowBlock(WindowBlock of, double damping) {
        model = of.model;
        windows = of.windows;
        columns = of.columns;
        chain.addAll(of.chain);
        int others = of.rows[0].length - START;
        rows = new double[columns][2 * START + others];
        for (int c = 0; c < columns; c++) {
            System.arraycopy(of.rows[c], 0, rows[c], 0, START);
            System.arraycopy(of.rows[c], START, rows[c], 2 * START, others);
        }
        for (int i = 0; i < START; i++) {
            double square = 0;
            for (int k = 0; k <= i; k++) {
                square += of.rows[i][k] * of.rows[i][k];
            }
            rows[i][START + i] = Math.sqrt(damping * square);
        }
        triangulate(2 * START);
    }

    /**
     * The same, its start held back.
     *
     * @param damping share of the size of each of its columns (Marquardt 1963)
     */
    public WindowBlock damped(double damping) {
        return new WindowBlock(this, damping);
    }

    private double[][] identity() {
        double[][] at = new double[START][columns];
        for (int i = 0; i < START; i++) {
            at[i][i] = 1;
        }
        return at;
    }

    private void startRows(boolean[] shown, Optional<KnownStart> known) {
        double[] off =
                known.map(k -> windows.getFirst().window.start().minus(k.motion()))
                        .orElse(new double[START]);
        for (int i = 0; i < START; i++) {
            int index = i;
            double stated =
                    known.map(k -> k.deviations().get(index)).orElse(Double.POSITIVE_INFINITY);
            boolean stays = !shown[i] && Double.isInfinite(stated);
            double deviation = Math.min(stays ? NOTHING : UNKNOWN[i / 3], stated);
            rows[i][i] = 1 / deviation;
            rows[columns - 1][i] = off[i] / deviation;
        }
    }

    /** Misses of a window: by its start, which depends on x, and by the parameters. */
    private int missRows(WindowDerivatives window, double[][] at, int row) {
        int count = window.misses.length;
        for (int c = 0; c < columns; c++) {
            double[] column = rows[c];
            for (int i = 0; i < START; i++) {
                double factor = at[i][c];
                if (factor != 0) {
                    double[] by = window.byStart[i];
                    for (int k = 0; k < count; k++) {
                        column[row + k] += factor * by[k];
                    }
                }
            }
            double[] own =
                    c < START
                            ? NONE
                            : c == columns - 1 ? window.misses : window.byParameter[c - START];
            for (int k = 0; k < own.length; k++) {
                column[row + k] += own[k];
            }
        }
        return row + count;
    }

    private static final double[] NONE = {};

    /** The next window's start as a linear function of x: where this one ends, and the gap. */
    private double[][] next(WindowDerivatives window, double[][] at, RigidMotion nextStart) {
        double[] gap = window.end.minus(nextStart);
        double[][] next = new double[START][columns];
        for (int i = 0; i < START; i++) {
            for (int c = 0; c < columns; c++) {
                double sum = 0;
                for (int j = 0; j < START; j++) {
                    sum += window.endByStart[j][i] * at[j][c];
                }
                next[i][c] = sum;
            }
            for (int p = 0; p < window.endByParameter.length; p++) {
                next[i][START + p] += window.endByParameter[p][i];
            }
            next[i][columns - 1] += gap[i];
        }
        return next;
    }

    /** Householder reflections on the start's columns in the first rows, applied to all columns. */
    private void triangulate(int count) {
        for (int c = 0; c < START; c++) {
            double[] pivot = rows[c];
            double norm = 0;
            for (int k = c; k < count; k++) {
                norm += pivot[k] * pivot[k];
            }
            norm = Math.sqrt(norm);
            double alpha = pivot[c] > 0 ? -norm : norm;
            double[] v = new double[count];
            System.arraycopy(pivot, c, v, c, count - c);
            v[c] -= alpha;
            double size = 0;
            for (int k = c; k < count; k++) {
                size += v[k] * v[k];
            }
            if (size == 0) {
                continue;
            }
            for (int other = c; other < columns; other++) {
                double[] column = rows[other];
                double dot = 0;
                for (int k = c; k < count; k++) {
                    dot += v[k] * column[k];
                }
                double factor = 2 * dot / size;
                for (int k = c; k < count; k++) {
                    column[k] -= factor * v[k];
                }
            }
        }
    }

    /** Logarithm of the determinant of what is known of the start, parameters given. */
    public double fineness() {
        double sum = 0;
        for (int i = 0; i < START; i++) {
            sum += 2 * StrictMath.log(Math.abs(rows[i][i]));
        }
        return sum;
    }

    /**
     * A sum and the product of two columns, the starts projected out: parameters first, then the
     * misses. Four rows at a time, to the bit as {@code Gram} makes the products of all.
     */
    public double plusProduct(double before, int a, int b) {
        double[] one = rows[START + a];
        double[] other = rows[START + b];
        double sum = before;
        int k = START;
        for (; k + 3 < one.length; k += 4) {
            sum +=
                    one[k] * other[k]
                            + one[k + 1] * other[k + 1]
                            + one[k + 2] * other[k + 2]
                            + one[k + 3] * other[k + 3];
        }
        double rest = 0;
        for (; k < one.length; k++) {
            rest += one[k] * other[k];
        }
        return sum + rest;
    }

    /** The starts projected out: row by row the parameters' numbers, then the misses. */
    public double[][] projectedRows() {
        double[][] projected = new double[rows[0].length - START][columns - START];
        for (int c = START; c < columns; c++) {
            double[] column = rows[c];
            for (int k = 0; k < projected.length; k++) {
                projected[k][c - START] = column[START + k];
            }
        }
        return projected;
    }

    /**
     * The windows with the starts that fit best when parameters change so.
     *
     * @param share of the way that is gone, above 0 and up to 1
     */
    public List<Window> moved(double[] parameters, double share) {
        double[] x = solved(parameters);
        List<Window> moved = new ArrayList<>();
        for (int w = 0; w < windows.size(); w++) {
            double[] change = product(chain.get(w), x);
            for (int i = 0; i < START; i++) {
                change[i] *= share;
            }
            Window window = windows.get(w).window;
            moved.add(window.startingAt(window.start().plus(model.startable(change))));
        }
        return moved;
    }

    /** By how much (rad) the window that turns most does so, at its start or its end. */
    public double largestTurn(double[] parameters) {
        double[] x = solved(parameters);
        double largest = 0;
        for (double[][] at : chain) {
            double[] change = product(at, x);
            largest =
                    Math.max(
                            largest,
                            Math.sqrt(
                                    change[3] * change[3]
                                            + change[4] * change[4]
                                            + change[5] * change[5]));
        }
        return largest;
    }

    /** The start that fits best when parameters change so, they themselves, and 1. */
    private double[] solved(double[] parameters) {
        double[] x = new double[columns];
        System.arraycopy(parameters, 0, x, START, parameters.length);
        x[columns - 1] = 1;
        for (int i = START - 1; i >= 0; i--) {
            double sum = 0;
            for (int c = i + 1; c < columns; c++) {
                sum += rows[c][i] * x[c];
            }
            x[i] = -sum / rows[i][i];
        }
        return x;
    }

    private static double[] product(double[][] matrix, double[] x) {
        double[] result = new double[matrix.length];
        for (int i = 0; i < matrix.length; i++) {
            for (int c = 0; c < x.length; c++) {
                result[i] += matrix[i][c] * x[c];
            }
        }
        return result;
    }
}
