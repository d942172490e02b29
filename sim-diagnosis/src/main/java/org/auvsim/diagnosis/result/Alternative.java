package org.auvsim.diagnosis.result;

import java.util.List;

/**
 * Causes that explain the data about as well as those selected.
 *
 * @param causes names as {@link Finding#name}
 * @param isIndistinguishable whether no amount of such data could tell them apart
 * @param determined what the data leaves possible, in words, as {@code a sensor delay of 0.700 s,
 *     or a clock offset of 0.700 s, or parts of both: only their sum is told}; or empty
 * @param otherSensor what was not measured and would tell them apart, as {@code velocity along x,
 *     by 0.30 m/s (root mean square)}; empty if nothing would, or the data can tell them apart
 */
public record Alternative(
        List<String> causes, boolean isIndistinguishable, String determined, String otherSensor) {
    /** The list cannot be changed. */
    public Alternative {
        causes = List.copyOf(causes);
    }
}
