package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.shooting.WindowBlock;
import org.auvsim.diagnosis.shooting.WindowDerivatives;

import java.util.List;

/** What a model asks of the starts of the runs. */
public final class Starts {
    private Starts() {}

    /**
     * How finely the starts must be chosen for a fit: twice the logarithm of their Occam factor (in
     * Laplace's approximation of the evidence; MacKay 2003, section 28.1), up to what is the same
     * for all models. One in which a start never fades fits noise with it. Infinite if a motion got
     * lost.
     */
    public static double fineness(Fit fit) {
        Fit whole = fit.whole();
        List<List<WindowDerivatives>> derivatives = whole.derivatives();
        if (derivatives.stream().flatMap(List::stream).anyMatch(WindowDerivatives::isLost)) {
            return Double.POSITIVE_INFINITY;
        }
        return whole.blocks(derivatives, 1).stream()
                .flatMap(List::stream)
                .mapToDouble(WindowBlock::fineness)
                .sum();
    }
}
