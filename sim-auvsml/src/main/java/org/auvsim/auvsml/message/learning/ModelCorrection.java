package org.auvsim.auvsml.message.learning;

import java.util.List;

/**
 * What was found that the model of a world object lacks.
 *
 * @param sentence for people
 * @param evidence natural logarithm of how much more likely the data is with it than without
 * @param extended whether the running world has it
 * @param cause what was found; none if what was found before is taken back
 * @param gain so far, on data that was not used to find it
 */
public record ModelCorrection(
        String sentence,
        double evidence,
        boolean extended,
        List<FoundCause> cause,
        List<MeasuredGain> gain) {}
