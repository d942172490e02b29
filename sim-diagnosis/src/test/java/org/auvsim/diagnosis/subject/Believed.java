package org.auvsim.diagnosis.subject;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.diagnosis.verdict.Examination;

import java.util.List;

/** Models that tests believe, and what runs say of them. */
public final class Believed {
    private Believed() {}

    /** The model of a body in a scenario. */
    public static BelievedModel model(String scenario, String body) throws AuvsmlException {
        return new BelievedModel(
                ScenarioLoader.load(Believed.class.getClassLoader())
                        .parse(scenario.getBytes(UTF_8)),
                body);
    }

    /** What runs say of a model that may have one cause wrong and nothing else. */
    public static Diagnosis suspectedOf(
            String cause, BelievedModel model, List<MeasuredRun> fit, List<MeasuredRun> heldOut) {
        return suspectedOf(List.of(cause), model, fit, heldOut);
    }

    /** The same of some causes. */
    public static Diagnosis suspectedOf(
            List<String> causes,
            BelievedModel model,
            List<MeasuredRun> fit,
            List<MeasuredRun> heldOut) {
        return new Examination(
                        model,
                        fit,
                        heldOut,
                        Library.named(causes, Library.of(model, fit)),
                        1,
                        Way.THOROUGH,
                        Progress.SILENT)
                .diagnosis();
    }
}
