package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.RunRole;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What was read from one file.
 *
 * @param runs one, or several if it has long gaps
 * @param sources where each of them stands in it
 * @param role what the document beside it says that it is there for
 * @param notices what was done to the data, and what looks wrong with it
 * @param doubt whether some of them doubt that the numbers are what they are taken for
 * @param settled what is left of some of them where a model explains the run
 * @param looksTurned whether the model moves as it tells if it is in other axes
 */
public record RunFile(
        Path file,
        List<MeasuredRun> runs,
        List<Source> sources,
        Optional<RunRole> role,
        List<String> notices,
        Doubt doubt,
        Map<String, String> settled,
        boolean looksTurned) {
    /** The lists and the map cannot be changed. */
    public RunFile {
        runs = List.copyOf(runs);
        sources = List.copyOf(sources);
        notices = List.copyOf(notices);
        settled = Map.copyOf(settled);
    }
}
