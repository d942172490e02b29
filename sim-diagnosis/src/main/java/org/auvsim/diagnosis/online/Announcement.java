package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.message.learning.FoundCause;
import org.auvsim.auvsml.message.learning.FoundQuantity;
import org.auvsim.auvsml.message.learning.MeasuredGain;
import org.auvsim.auvsml.message.learning.ModelCorrection;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.QuantityGroup;
import org.auvsim.diagnosis.result.Ranked;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/** Says in AUVSML what a diagnosis has found. */
final class Announcement {
    private Announcement() {}

    /**
     * What was found.
     *
     * @param isExtended whether the running world has it
     */
    static ModelCorrection of(Diagnosis diagnosis, boolean isExtended) {
        return new ModelCorrection(
                diagnosis.sentence(),
                evidence(diagnosis),
                isExtended,
                diagnosis.selected().stream().map(Announcement::cause).toList(),
                diagnosis.prediction().gains().entrySet().stream()
                        .map(
                                of ->
                                        new MeasuredGain(
                                                of.getKey().name(),
                                                of.getValue().before(),
                                                of.getValue().after(),
                                                of.getValue().noise()))
                        .toList());
    }

    /** By how much the chosen set's evidence is larger than that of no causes. */
    private static double evidence(Diagnosis diagnosis) {
        double none =
                diagnosis.evidence().ranked().stream()
                        .filter(set -> set.causes().isEmpty())
                        .mapToDouble(Ranked::logEvidence)
                        .max()
                        .orElse(Double.NEGATIVE_INFINITY);
        return diagnosis.evidence().ranked().getFirst().logEvidence() - none;
    }

    private static FoundCause cause(Finding finding) {
        List<FoundQuantity> quantities = new ArrayList<>();
        List<Double> deviations =
                QuantityGroup.of(finding).stream()
                        .flatMap(group -> group.toldDeviations().stream())
                        .toList();
        for (int i = 0; i < finding.quantities().size(); i++) {
            Quantity quantity = finding.quantities().get(i);
            quantities.add(
                    new FoundQuantity(
                            quantity.name(),
                            quantity.unit(),
                            quantity.value(),
                            deviations.isEmpty()
                                    ? OptionalDouble.empty()
                                    : told(deviations.get(i))));
        }
        return new FoundCause(finding.name(), finding.share(), quantities);
    }

    /** None of what the data does not determine. */
    private static OptionalDouble told(double deviation) {
        return Double.isFinite(deviation) ? OptionalDouble.of(deviation) : OptionalDouble.empty();
    }
}
