package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.run.Channel;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * How well held-out runs are predicted.
 *
 * @param noise standard deviation of each channel that was measured
 * @param gains errors by channel
 * @param horizons the same, by how far ahead is predicted
 * @param usedHeldOut whether held-out runs had to be used for the search, too: the gains are then
 *     those of leaving each run out in turn
 */
public record Prediction(
        Map<Channel, Double> noise,
        Map<Channel, Gain> gains,
        List<HorizonGain> horizons,
        boolean usedHeldOut) {
    /** The maps and the list cannot be changed; the maps are in the order of the channels. */
    public Prediction {
        noise = Collections.unmodifiableSortedMap(new TreeMap<>(noise));
        gains = Collections.unmodifiableSortedMap(new TreeMap<>(gains));
        horizons = List.copyOf(horizons);
    }
}
