package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.run.Channel;

import java.util.Collections;
import java.util.EnumMap;
import java.util.Map;

/**
 * How well held-out runs are predicted some time ahead, from states all along them that the model
 * with what was found is fitted to.
 *
 * @param ahead (s)
 * @param errors of what is measured, by channel; not empty
 */
public record HorizonGain(double ahead, Map<Channel, Gain> errors) {
    /** The errors cannot be changed and are in the order of the channels. */
    public HorizonGain {
        errors = Collections.unmodifiableMap(new EnumMap<>(errors));
    }
}
