package org.auvsim.cli.feed;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * What became of a log's samples.
 *
 * @param heldBack never sent, so that the simulated path can be compared with them
 * @param sent as feedback
 * @param applied by the simulator
 * @param refused by it, mostly because they came too late
 * @param refusal what it said the first time
 * @param skipped movements that it did not send since this side was slow
 * @param moved whether the object moved at all
 * @param time world time (s) that was reached
 * @param end time (s) of the log's last sample
 * @param comparison held-back samples against the simulated path; empty: there were none
 */
public record FeedTally(
        int heldBack,
        int sent,
        int applied,
        int refused,
        Optional<String> refusal,
        long skipped,
        boolean moved,
        double time,
        double end,
        Optional<PathError> comparison) {
    /** Sent samples of which fewer than this share were applied make a run doubtful. */
    private static final double ENOUGH = 0.95;

    /**
     * Distance of a simulated path from samples.
     *
     * @param samples how many
     * @param rms root of the mean square (m)
     * @param largest (m)
     */
    public record PathError(int samples, double rms, double largest) {
        @Override
        public String toString() {
            return String.format(
                    Locale.ROOT,
                    "error: RMS %.4f m, largest %.4f m, at %d samples held back",
                    rms,
                    largest,
                    samples);
        }
    }

    /** Whether so many samples went unused that the comparison says little. */
    public boolean isDoubtful() {
        return applied < ENOUGH * sent;
    }

    /** All of it in lines, for people. */
    public List<String> report() {
        List<String> lines = new ArrayList<>();
        lines.add(
                "samples: %d sent (%d applied, %d refused), %d held back"
                        .formatted(sent, applied, refused, heldBack));
        refusal.ifPresent(text -> lines.add("first refusal: " + text));
        lines.add(
                comparison
                        .map(PathError::toString)
                        .orElse("error: no samples were held back and passed, none to compare"));
        if (time < end - MeasuredLog.SAME_TIME) {
            lines.add("the simulation ended at %s s, before the log (%s s)".formatted(time, end));
        }
        if (skipped > 0) {
            lines.add("warning: the simulator left out %d movements".formatted(skipped));
        }
        if (isDoubtful()) {
            lines.add("warning: %d of %d samples were not applied".formatted(sent - applied, sent));
        }
        if (isDoubtful() && refusal.filter(text -> text.contains("too late")).isPresent()) {
            lines.add("give the scenario's feedback time-stepper a longer wait");
        }
        return lines;
    }
}
