package org.auvsim.diagnosis.shooting;

import java.util.List;

/**
 * How much a slight turn at a start grows through windows that follow one another: by the product
 * of their transitions (Lyapunov 1892). What rights itself forgets it, what goes straight on keeps
 * it; a heading that nothing steadies makes it grow without end.
 */
public final class Growth {
    private static final int TURN = 3;
    private static final int AXES = 3;

    private Growth() {}

    /**
     * The largest turn (rad) at the end for one of 1 rad at the start, as far as it is linear.
     *
     * @param windows one at least
     */
    public static double of(List<WindowDerivatives> windows) {
        double[][] carried = windows.getFirst().endByStart;
        for (WindowDerivatives window : windows.subList(1, windows.size())) {
            carried = product(carried, window.endByStart);
        }
        double largest = 0;
        for (int from = TURN; from < TURN + AXES; from++) {
            for (int to = TURN; to < TURN + AXES; to++) {
                largest = Math.max(largest, Math.abs(carried[from][to]));
            }
        }
        return largest;
    }

    /** By number of the first start, then of the last end. */
    private static double[][] product(double[][] before, double[][] after) {
        int size = after.length;
        double[][] product = new double[size][size];
        for (int from = 0; from < size; from++) {
            for (int to = 0; to < size; to++) {
                for (int between = 0; between < size; between++) {
                    product[from][to] += before[from][between] * after[between][to];
                }
            }
        }
        return product;
    }
}
