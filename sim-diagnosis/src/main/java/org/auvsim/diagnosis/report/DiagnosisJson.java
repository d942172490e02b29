package org.auvsim.diagnosis.report;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.report.DiagnosisDocument.AlternativePart;
import org.auvsim.diagnosis.report.DiagnosisDocument.ApproximationPart;
import org.auvsim.diagnosis.report.DiagnosisDocument.DiscrepancyPart;
import org.auvsim.diagnosis.report.DiagnosisDocument.ForcePart;
import org.auvsim.diagnosis.report.DiagnosisDocument.HorizonPart;
import org.auvsim.diagnosis.report.DiagnosisDocument.RankedPart;
import org.auvsim.diagnosis.report.DiagnosisDocument.RunPart;
import org.auvsim.diagnosis.report.DiagnosisDocument.SelectedPart;
import org.auvsim.diagnosis.result.Conclusion;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Evidence;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Prediction;
import org.auvsim.diagnosis.result.QuantityGroup;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.MapperFeature;
import tools.jackson.databind.PropertyNamingStrategies;
import tools.jackson.databind.SerializationContext;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.module.SimpleModule;
import tools.jackson.databind.ser.std.StdSerializer;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A diagnosis for machines; {@code docs/diagnosis.schema.json} has the form. */
final class DiagnosisJson {
    private static final JsonMapper MAPPER =
            JsonMapper.builder()
                    .propertyNamingStrategy(PropertyNamingStrategies.SNAKE_CASE)
                    .disable(MapperFeature.SORT_PROPERTIES_ALPHABETICALLY)
                    .enable(SerializationFeature.INDENT_OUTPUT)
                    .addModule(finiteNumbers())
                    .build();

    private DiagnosisJson() {}

    private static SimpleModule finiteNumbers() {
        FiniteOrNull form = new FiniteOrNull();
        return new SimpleModule()
                .addSerializer(Double.class, form)
                .addSerializer(Double.TYPE, form);
    }

    /** JSON has no number for what is not finite. */
    private static final class FiniteOrNull extends StdSerializer<Double> {
        FiniteOrNull() {
            super(Double.class);
        }

        @Override
        public void serialize(Double value, JsonGenerator out, SerializationContext context) {
            if (Double.isFinite(value)) {
                out.writeNumber(value);
            } else {
                out.writeNull();
            }
        }
    }

    static String text(Diagnosis diagnosis, List<NamedRun> runs) {
        return MAPPER.writeValueAsString(document(diagnosis, runs)) + "\n";
    }

    private static DiagnosisDocument document(Diagnosis of, List<NamedRun> runs) {
        Conclusion conclusion = of.conclusion();
        Evidence evidence = of.evidence();
        Prediction prediction = of.prediction();
        Optional<Gain> position = Optional.ofNullable(prediction.gains().get(Channel.POSITION));
        return new DiagnosisDocument(
                Names.of(conclusion.verdict()),
                conclusion.selected().stream().map(DiagnosisJson::selected).toList(),
                evidence.ranked().stream().map(DiagnosisJson::ranked).toList(),
                evidence.alternatives().stream()
                        .map(
                                a ->
                                        new AlternativePart(
                                                a.causes(),
                                                a.isIndistinguishable(),
                                                a.determined(),
                                                a.otherSensor()))
                        .toList(),
                byName(prediction.noise()),
                position.map(Gain::before),
                position.map(Gain::after),
                byName(prediction.gains()),
                evidence.nextExperiment(),
                of.seed(),
                DiagnosisDocument.VERSION,
                of.sentence(),
                of.body(),
                of.isComplete(),
                prediction.usedHeldOut(),
                evidence.candidates(),
                prediction.horizons().stream()
                        .map(h -> new HorizonPart(h.ahead(), byName(h.errors())))
                        .toList(),
                conclusion
                        .discrepancy()
                        .map(
                                d ->
                                        new DiscrepancyPart(
                                                Names.of(d.channel()),
                                                String.valueOf(d.axis().letter()),
                                                Names.of(d.axis().frame()),
                                                d.run(),
                                                d.time(),
                                                List.of(
                                                        d.place().x(),
                                                        d.place().y(),
                                                        d.place().z()),
                                                d.frequency().stream().boxed().findFirst(),
                                                d.share())),
                conclusion
                        .approximation()
                        .map(
                                near ->
                                        new ApproximationPart(
                                                near.causes().stream()
                                                        .map(DiagnosisJson::selected)
                                                        .toList(),
                                                Report.APPROXIMATE)),
                conclusion.proposal(),
                evidence.identifiability(),
                runs.stream().map(file -> run(file, prediction.noise())).toList(),
                of.notices());
    }

    private static <V> Map<String, V> byName(Map<Channel, V> values) {
        Map<String, V> byName = new LinkedHashMap<>();
        values.forEach((channel, value) -> byName.put(Names.of(channel), value));
        return byName;
    }

    private static SelectedPart selected(Finding finding) {
        Map<String, Object> params = new LinkedHashMap<>();
        finding.subject().ifPresent(name -> params.put(role(finding.cause()), name));
        Map<String, Object> sigma = new LinkedHashMap<>();
        Map<String, String> unit = new LinkedHashMap<>();
        for (QuantityGroup group : QuantityGroup.of(finding)) {
            params.put(group.name(), numbers(group, group.values()));
            unit.put(group.name(), group.unit());
            if (!group.deviations().isEmpty()) {
                sigma.put(group.name(), numbers(group, group.toldDeviations()));
            }
        }
        return new SelectedPart(finding.cause(), params, sigma, unit, finding.share());
    }

    /** What a cause calls what it is about. */
    private static String role(String cause) {
        return cause.startsWith("thruster_") ? "thruster" : "subject";
    }

    private static Object numbers(QuantityGroup group, List<Double> values) {
        return group.isVector() ? values : values.getFirst();
    }

    private static RankedPart ranked(Ranked of) {
        List<Map<String, Object>> params = new ArrayList<>();
        for (List<Quantity> quantities : of.quantities()) {
            Map<String, Object> numbers = new LinkedHashMap<>();
            for (QuantityGroup group : QuantityGroup.of(quantities, List.of())) {
                numbers.put(group.name(), numbers(group, group.values()));
            }
            params.add(numbers);
        }
        return new RankedPart(
                of.name(), of.logEvidence(), of.probability(), of.causes(), params, of.behind());
    }

    private static RunPart run(NamedRun file, Map<Channel, Double> noise) {
        DiagnosedRun of = file.run();
        MeasuredRun run = of.run();
        MeasuredRun counted = of.counted();
        Map<Channel, Gain> errors = new LinkedHashMap<>();
        for (Channel channel : Channel.values()) {
            if (counted.measures(channel)) {
                errors.put(
                        channel,
                        new Gain(
                                new Residuals(counted, of.before()).rootMeanSquare(channel),
                                new Residuals(counted, of.after()).rootMeanSquare(channel),
                                noise.getOrDefault(channel, Double.NaN)));
            }
        }
        return new RunPart(
                run.name(),
                of.isHeldOut(),
                run.size(),
                run.duration(),
                byName(errors),
                of.isHeldOut() ? Optional.of("predictions/" + file.name()) : Optional.empty(),
                "residuals/" + file.name(),
                of.forces().stream().map(DiagnosisJson::force).toList());
    }

    private static ForcePart force(ForceResidual of) {
        return new ForcePart(of.time(), list(of.before()), list(of.after()));
    }

    private static List<Double> list(Vec3 v) {
        return List.of(v.x(), v.y(), v.z());
    }
}
