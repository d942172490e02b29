package org.auvsim.diagnosis.report;

import com.fasterxml.jackson.annotation.JsonProperty;

import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Identifiability;
import org.auvsim.diagnosis.result.NextExperiment;
import org.auvsim.diagnosis.result.Proposal;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * {@code diagnosis.json}, member by member; names are written with underscores.
 *
 * @param heldoutRmseBefore of the position (m)
 * @param version of this form
 */
record DiagnosisDocument(
        String verdict,
        List<SelectedPart> selected,
        List<RankedPart> ranked,
        List<AlternativePart> alternatives,
        Map<String, Double> noise,
        Optional<Double> heldoutRmseBefore,
        Optional<Double> heldoutRmseAfter,
        Map<String, Gain> heldout,
        Optional<NextExperiment> nextExperiment,
        long seed,
        int version,
        String sentence,
        String body,
        boolean complete,
        boolean usedHeldout,
        int candidates,
        List<HorizonPart> horizons,
        Optional<DiscrepancyPart> discrepancy,
        Optional<ApproximationPart> approximation,
        Optional<Proposal> proposal,
        Identifiability identifiability,
        List<RunPart> runs,
        List<String> notices) {
    static final int VERSION = 1;

    /** A cause that was found; numbers or lists of them, and in {@code params} names. */
    record SelectedPart(
            String name,
            Map<String, Object> params,
            Map<String, Object> sigma,
            Map<String, String> unit,
            double share) {}

    /** A set of causes that was tried. */
    record RankedPart(
            String name,
            double logEvidence,
            double probability,
            List<String> causes,
            List<Map<String, Object>> params,
            Optional<String> behind) {}

    record AlternativePart(
            List<String> names, boolean indistinguishable, String determined, String otherSensor) {}

    /** Errors so far ahead (s). */
    record HorizonPart(double ahead, Map<String, Gain> errors) {}

    record DiscrepancyPart(
            String channel,
            String axis,
            String frame,
            String run,
            double time,
            List<Double> place,
            Optional<Double> frequency,
            double share) {}

    /** A model that explains nothing but is much nearer, and the file that it is in. */
    record ApproximationPart(List<SelectedPart> causes, String scenario) {}

    /** A run, the errors of both models, and where its tables are. */
    record RunPart(
            String name,
            @JsonProperty("heldout") boolean isHeldOut,
            int samples,
            double duration,
            Map<String, Gain> errors,
            Optional<String> prediction,
            String residuals,
            List<ForcePart> forces) {}

    record ForcePart(double time, List<Double> before, List<Double> after) {}
}
