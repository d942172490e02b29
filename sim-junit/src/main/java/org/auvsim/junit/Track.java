package org.auvsim.junit;

import java.util.List;

/**
 * What is known of one body.
 *
 * @param samples as it moved in the replay, at the beginning and after each step; of a fixed body
 *     the first and the last
 * @param recorded as it moved when the recording was made
 */
record Track(long id, String name, List<Sample> samples, List<Pose> recorded) {
    Track {
        samples = List.copyOf(samples);
        recorded = List.copyOf(recorded);
    }
}
