package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.experiments.hidden.CaseBook;
import org.auvsim.experiments.hidden.HiddenCase;
import org.auvsim.experiments.hidden.SparseRegression;
import org.auvsim.experiments.scoreboard.Plan.Drawing;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** Has cases diagnosed, one after another. */
public final class Scoreboard {
    private Scoreboard() {}

    /**
     * Draws the cases of a plan and judges what the diagnosis says of them.
     *
     * @param told is told each outcome as it comes
     * @param stop whether to end early
     * @return all outcomes so far
     */
    public static List<Outcome> of(Plan plan, Consumer<Outcome> told, BooleanSupplier stop) {
        List<Outcome> outcomes = new ArrayList<>();
        for (Drawing drawing : plan.drawings()) {
            if (stop.getAsBoolean()) {
                break;
            }
            HiddenCase of = CaseBook.draw(drawing.kind(), drawing.noise(), drawing.seed());
            long began = System.nanoTime();
            Diagnosis diagnosis =
                    diagnosis(of, drawing.method(), (stage, share) -> !stop.getAsBoolean());
            double seconds = (System.nanoTime() - began) * 1e-9;
            if (!diagnosis.isComplete()) {
                break;
            }
            Outcome outcome =
                    Referee.outcome(
                            of, drawing.method(), diagnosis, SparseRegression.causes(of), seconds);
            outcomes.add(outcome);
            told.accept(outcome);
        }
        return outcomes;
    }

    /** What the diagnosis says of a case; nothing of what is hidden is told to it. */
    public static Diagnosis diagnosis(HiddenCase of, Progress progress) {
        return diagnosis(of, Method.SHOOTING, progress);
    }

    private static Diagnosis diagnosis(HiddenCase of, Method method, Progress progress) {
        BelievedModel model = of.model();
        return new Investigation(
                        model,
                        of.fit(),
                        of.heldOut(),
                        Library.of(model, of.fit()),
                        of.seed(),
                        progress)
                .by(method)
                .diagnose();
    }

    /** What a diagnosis of a case is worth. */
    public static Outcome judged(HiddenCase of, Diagnosis diagnosis) {
        return Referee.outcome(of, Method.SHOOTING, diagnosis, SparseRegression.causes(of), 0);
    }

    /** The outcome of one case. */
    public static Outcome outcome(HiddenCase of) {
        return judged(of, diagnosis(of, Progress.SILENT));
    }
}
