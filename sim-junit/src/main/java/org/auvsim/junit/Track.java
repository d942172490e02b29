package org.auvsim.junit;

import java.util.List;
import java.util.Optional;

/**
 * What is known of one body.
 *
 * @param samples as it moved in the replay, at the beginning and after each step; of a fixed body
 *     the first and the last
 * @param recorded as it moved when the recording was made, of a fixed body nothing; empty if it was
 *     not there
 */
record Track(long id, String name, List<Sample> samples, Optional<List<Pose>> recorded) {
    Track {
        samples = List.copyOf(samples);
    }
}
