package org.auvsim.diagnosis.fit;

import org.auvsim.core.math.Cholesky;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.shooting.WindowBlock;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * All products of columns with one another and with the misses, the starts projected out: what any
 * set of columns explains follows from it by a small solve.
 */
public final class Gram {
    /**
     * Share of a column's size that is added to it, so that columns that are alike can be solved.
     */
    private static final double RIDGE = 1e-10;

    private static final double MOST_SCALES = 30;

    /** So many columns are worked on together, so that their products stay near. */
    private static final int TILE = 32;

    private final double[][] products;
    private final int misses;

    /** Of products of columns with one another, those with the misses last. */
    public Gram(double[][] products) {
        this.products = products;
        this.misses = products.length - 1;
    }

    /** Of blocks of windows of all runs. */
    public static Gram of(List<List<WindowBlock>> blocks, int columns) {
        double[][] products = new double[columns + 1][columns + 1];
        List<double[][]> rows =
                blocks.stream().flatMap(List::stream).map(WindowBlock::projectedRows).toList();
        int tiles = columns / TILE + 1;
        IntStream.range(0, tiles)
                .parallel()
                .forEach(
                        tile -> {
                            int to = Math.min((tile + 1) * TILE, columns + 1);
                            rows.forEach(ofBlock -> add(ofBlock, products, tile * TILE, to));
                        });
        for (int a = 0; a <= columns; a++) {
            for (int b = 0; b < a; b++) {
                products[a][b] = products[b][a];
            }
        }
        return new Gram(products);
    }

    /** Of some of the columns alone. */
    public static Gram of(List<List<WindowBlock>> blocks, int[] some, int columns) {
        int[] all = Arrays.copyOf(some, some.length + 1);
        all[some.length] = columns;
        double[][] products = new double[all.length][all.length];
        for (List<WindowBlock> ofRun : blocks) {
            for (WindowBlock block : ofRun) {
                for (int a = 0; a < all.length; a++) {
                    for (int b = 0; b <= a; b++) {
                        products[a][b] = block.plusProduct(products[a][b], all[a], all[b]);
                        products[b][a] = products[a][b];
                    }
                }
            }
        }
        return new Gram(products);
    }

    /**
     * Adds the products of some columns with themselves and all after them, four rows at a time.
     */
    private static void add(double[][] rows, double[][] products, int from, int to) {
        double[] none = new double[products.length];
        for (int k = 0; k < rows.length; k += 4) {
            double[] r0 = rows[k];
            double[] r1 = k + 1 < rows.length ? rows[k + 1] : none;
            double[] r2 = k + 2 < rows.length ? rows[k + 2] : none;
            double[] r3 = k + 3 < rows.length ? rows[k + 3] : none;
            for (int a = from; a < to; a++) {
                add(products[a], a, r0, r1, r2, r3);
            }
        }
    }

    private static void add(
            double[] sums, int a, double[] r0, double[] r1, double[] r2, double[] r3) {
        double f0 = r0[a];
        double f1 = r1[a];
        double f2 = r2[a];
        double f3 = r3[a];
        for (int b = a; b < sums.length; b++) {
            sums[b] += f0 * r0[b] + f1 * r1[b] + f2 * r2[b] + f3 * r3[b];
        }
    }

    /** The same with what is known of parameters otherwise. */
    Gram with(Knowledge knowledge, double[] theta) {
        double[][] sum = copy();
        knowledge.addTo(sum, theta);
        return new Gram(sum);
    }

    private double[][] copy() {
        return Arrays.stream(products).map(double[]::clone).toArray(double[][]::new);
    }

    /** The same with other misses, of which the products with each column are given. */
    public Gram missing(double[] withColumns) {
        double[][] other = products.clone();
        other[misses] = Arrays.copyOf(withColumns, misses + 1);
        return new Gram(other);
    }

    /** Sum of the squared misses that no change of the starts explains. */
    double cost() {
        return products[misses][misses];
    }

    /** How many columns there are. */
    public int columns() {
        return misses;
    }

    /** Size of a column: root of its sum of squares, the starts projected out. */
    public double norm(int column) {
        return Math.sqrt(Math.max(0, products[column][column]));
    }

    /** The product of two columns. */
    public double product(int a, int b) {
        return products[a][b];
    }

    /** Whether all products are numbers. */
    boolean isFinite() {
        return Arrays.stream(products).flatMapToDouble(Arrays::stream).allMatch(Double::isFinite);
    }

    private boolean isFinite(int column, int[] others) {
        double[] ofColumn = products[column];
        return Double.isFinite(products[misses][column])
                && Arrays.stream(others).allMatch(other -> Double.isFinite(ofColumn[other]));
    }

    /** The change of these parameters, within their bounds, that explains most. */
    public double[] solve(int[] columns, Bounds bounds) {
        return solve(columns, bounds, RIDGE, new double[columns.length]);
    }

    /**
     * The same, damped. What would go beyond its bounds stops there, and the others make up for it;
     * what is out of all bounds, so that its products are no numbers, stays where it is.
     *
     * @param damping share of a column's size that is added to it (Marquardt 1963)
     * @param least sizes that are damped: a column that is 0 just here is not to go anywhere
     */
    double[] solve(int[] columns, Bounds bounds, double damping, double[] least) {
        boolean[] isFree = new boolean[columns.length];
        for (int i = 0; i < isFree.length; i++) {
            isFree[i] = isFinite(columns[i], columns);
        }
        double[] change = new double[columns.length];
        boolean goesOn = true;
        while (goesOn) {
            solveFree(columns, isFree, damping, least, change);
            goesOn = false;
            for (int i = 0; i < change.length; i++) {
                double clipped = bounds.clipped(i, change[i]);
                if (isFree[i] && clipped != change[i]) {
                    change[i] = clipped;
                    isFree[i] = false;
                    goesOn = true;
                }
            }
        }
        return change;
    }

    /** Solves for those changes that are free, where the others are what they are. */
    private void solveFree(
            int[] columns, boolean[] isFree, double damping, double[] least, double[] change) {
        int[] free = IntStream.range(0, columns.length).filter(i -> isFree[i]).toArray();
        int n = free.length;
        double[][] matrix = new double[n][n];
        double[] right = new double[n];
        double[] scale = new double[n];
        for (int a = 0; a < n; a++) {
            double norm = norm(columns[free[a]]);
            scale[a] = norm > 0 ? norm : 1;
        }
        for (int a = 0; a < n; a++) {
            double[] ofColumn = products[columns[free[a]]];
            for (int b = 0; b < a; b++) {
                matrix[a][b] = ofColumn[columns[free[b]]] / scale[a] / scale[b];
            }
            double damped = Math.max(1, least[free[a]] / scale[a]);
            matrix[a][a] = 1 + damping * damped * damped;
            double missed = products[misses][columns[free[a]]];
            for (int i = 0; i < columns.length; i++) {
                missed += isFree[i] || change[i] == 0 ? 0 : ofColumn[columns[i]] * change[i];
            }
            right[a] = -missed / scale[a];
        }
        double[] solution = new Cholesky(matrix).solve(right);
        for (int a = 0; a < n; a++) {
            change[free[a]] = solution[a] / scale[a];
        }
    }

    /**
     * Adds a weak prior with a deviation of 30 scales to each parameter, so that data which hardly
     * determines it does not move it.
     *
     * @param parameters that the first columns are of
     */
    public Gram cautious(List<Parameter> parameters) {
        double[][] sum = copy();
        for (int i = 0; i < parameters.size(); i++) {
            double most = MOST_SCALES * parameters.get(i).scale();
            sum[i][i] += 1 / (most * most);
        }
        return new Gram(sum);
    }

    /** By how much the cost falls with a change of these parameters. */
    public double drop(int[] columns, double[] change) {
        double drop = 0;
        int[] changed = IntStream.range(0, columns.length).filter(i -> change[i] != 0).toArray();
        for (int a : changed) {
            drop -= 2 * change[a] * products[misses][columns[a]];
            for (int b : changed) {
                drop -= change[a] * products[columns[a]][columns[b]] * change[b];
            }
        }
        return drop;
    }

    /** The products of these columns: the inverse of their parameters' covariance. */
    double[][] information(int[] columns) {
        double[][] matrix = new double[columns.length][columns.length];
        for (int a = 0; a < columns.length; a++) {
            for (int b = 0; b < columns.length; b++) {
                matrix[a][b] = products[columns[a]][columns[b]];
            }
        }
        return matrix;
    }
}
