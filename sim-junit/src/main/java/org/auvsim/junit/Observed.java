package org.auvsim.junit;

import org.auvsim.auvsml.document.Scenario;

import java.util.List;
import java.util.Optional;

/**
 * What a replay showed; shared by all tests that ask for it.
 *
 * @param source the file that was replayed
 * @param ofRecording whether it was a recording, not a scenario alone
 * @param end world time (s) at the end
 * @param tracks in order of ids
 * @param encounters in order of time
 * @param divergence where it first differed from the recording
 */
record Observed(
        String source,
        boolean ofRecording,
        Scenario scenario,
        double end,
        List<Track> tracks,
        List<Encounter> encounters,
        Optional<String> divergence) {
    Observed {
        tracks = List.copyOf(tracks);
        encounters = List.copyOf(encounters);
    }
}
