package org.auvsim.diagnosis.online;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.entity.ReviseWorldObjectCommand;
import org.auvsim.auvsml.message.learning.ModelCorrection;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Conclusion;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Evidence;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Identifiability;
import org.auvsim.diagnosis.result.Prediction;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.result.Sentence;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.server.simulator.StepMade;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/** What the running world has of what was learned, one diagnosis after the other. */
@Timeout(60)
class LearnedWorldTest {
    private static final LearningPlan PLAN = new LearningPlan(true, 30, 1000, 1, Method.SHOOTING);
    private static final List<Quantity> NUMBERS = List.of(new Quantity("k", "1", 1));

    private final World measured = Heard.world();
    private final ObedientWorld running = new ObedientWorld(Heard.world());
    private final BlockingQueue<Function<BelievedModel, Diagnosis>> script =
            new LinkedBlockingQueue<>();
    private final BlockingQueue<Diagnosis> made = new LinkedBlockingQueue<>();
    private final Learner learner =
            new Learner(1, Belief.of(measured, 1), PLAN, running, this::diagnosis);

    @AfterEach
    void close() {
        learner.close();
    }

    /** A drag (kg/m), and a current along x (m/s). */
    private static Diagnosis found(BelievedModel model, double drag, double current) {
        return diagnosis(
                Verdict.EXPLAINED,
                List.of("quadratic_drag", "current_constant"),
                model.extended(
                        model.variant()
                                .with(body -> body.effect(new IsotropicDrag(0, drag, 0)))
                                .in(
                                        new UniformCurrent(
                                                1_000_001,
                                                "found current 1",
                                                new Vec3(current, 0, 0)))),
                true);
    }

    private Diagnosis nothing() {
        return diagnosis(Verdict.NONE, List.of(), Scenario.of(measured), true);
    }

    private static Diagnosis diagnosis(
            Verdict verdict, List<String> causes, Scenario extended, boolean isComplete) {
        Ranked chosen =
                new Ranked(
                        causes, causes.stream().map(_ -> NUMBERS).toList(), 0, 1, Optional.empty());
        return new Diagnosis(
                "body",
                new Conclusion(
                        verdict,
                        Sentence.of("what is to be said"),
                        causes.stream().map(LearnedWorldTest::finding).toList()),
                new Evidence(
                        2,
                        List.of(chosen),
                        List.of(),
                        new Identifiability(List.of(), List.of(), List.of(), List.of()),
                        Optional.empty()),
                new Prediction(Map.of(), Map.of(), List.of(), false),
                List.of(),
                extended,
                List.of(),
                1,
                isComplete);
    }

    private static Finding finding(String cause) {
        return new Finding(cause, Optional.empty(), NUMBERS, List.of(), 1, true);
    }

    private Diagnosis diagnosis(Investigation of) {
        Diagnosis next = script.remove().apply(of.model());
        made.add(next);
        return next;
    }

    /** Just enough is measured for a diagnosis, which says this. */
    private void diagnosed(Function<BelievedModel, Diagnosis> saying) throws InterruptedException {
        script.add(saying);
        int seconds = measured.time() == 0 ? 48 : 30;
        for (int i = 0; i < seconds; i++) {
            measured.advanceTimestep();
            double now = measured.time();
            learner.corrected(Heard.feedback(now), Heard.applied(Heard.feedback(now)));
            learner.stepMade(new StepMade(0, Math.round(now), measured));
        }
        assertThat(made.poll(30, TimeUnit.SECONDS)).as("a diagnosis").isNotNull();
    }

    /** The same, which announces something. */
    private ModelCorrection announced(Function<BelievedModel, Diagnosis> saying)
            throws InterruptedException {
        diagnosed(saying);
        ModelCorrection next = running.announced().poll(30, TimeUnit.SECONDS);
        assertThat(next).as("an announcement").isNotNull();
        return next;
    }

    private List<Effect> effects() {
        return running.world().object(1).effects();
    }

    private List<Double> currents() {
        return running.world().fields().stream()
                .map(field -> ((UniformCurrent) field).velocity().x())
                .toList();
    }

    @Test
    void whatIsAcceptedIsSaidToBeInTheWorld() throws Exception {
        ModelCorrection said = announced(model -> found(model, 7, 0.1));

        assertThat(said.extended()).isTrue();
        assertThat(effects()).containsExactly(new IsotropicDrag(0, 7, 0));
        assertThat(currents()).containsExactly(0.1);
    }

    @Test
    void nothingIsLeftOfWhatIsRefusedInPart() throws Exception {
        running.refuse(ReviseWorldObjectCommand.class::isInstance);

        ModelCorrection said = announced(model -> found(model, 7, 0.1));

        assertThat(said.extended()).isFalse();
        assertThat(effects()).isEmpty();
        assertThat(currents()).isEmpty();
    }

    @Test
    void whatWasRefusedIsSentAgainWhenItIsFoundAgain() throws Exception {
        running.refuse(ReviseWorldObjectCommand.class::isInstance);
        announced(model -> found(model, 7, 0.1));
        running.refuse(_ -> false);

        ModelCorrection said = announced(model -> found(model, 7, 0.1));

        assertThat(said.extended()).isTrue();
        assertThat(effects()).containsExactly(new IsotropicDrag(0, 7, 0));
        assertThat(currents()).containsExactly(0.1);
    }

    @Test
    void whatWasLearnedBeforeStaysWhereWhatTakesItsPlaceIsRefused() throws Exception {
        announced(model -> found(model, 7, 0.1));
        running.refuse(ReviseWorldObjectCommand.class::isInstance);

        ModelCorrection said = announced(model -> found(model, 8, 0.2));

        assertThat(said.extended()).isFalse();
        assertThat(effects()).containsExactly(new IsotropicDrag(0, 7, 0));
        assertThat(currents()).containsExactly(0.1);

        running.refuse(_ -> false);
        assertThat(announced(model -> found(model, 9, 0.3)).extended()).isTrue();
        assertThat(effects()).containsExactly(new IsotropicDrag(0, 9, 0));
        assertThat(currents()).containsExactly(0.3);
    }

    @Test
    void whatMoreDataDoesNotBearOutIsTakenBack() throws Exception {
        announced(model -> found(model, 7, 0.1));

        ModelCorrection said = announced(_ -> nothing());

        assertThat(said.cause()).isEmpty();
        assertThat(said.extended()).isTrue();
        assertThat(said.evidence()).isZero();
        assertThat(effects()).isEmpty();
        assertThat(currents()).isEmpty();
        assertThat(announced(model -> found(model, 9, 0.3)).extended()).isTrue();
        assertThat(currents()).containsExactly(0.3);
    }

    @Test
    void whatCannotBeTakenBackIsTriedAgain() throws Exception {
        announced(model -> found(model, 7, 0.1));
        running.refuse(ReviseWorldObjectCommand.class::isInstance);
        diagnosed(_ -> nothing());

        ModelCorrection said =
                announced(
                        _ -> {
                            running.refuse(_ -> false);
                            return nothing();
                        });

        assertThat(said.cause()).isEmpty();
        assertThat(effects()).isEmpty();
        assertThat(currents()).isEmpty();
    }

    /** A search that was stopped has not looked at all that may be missing. */
    @Test
    void aStoppedSearchTakesNothingBack() throws Exception {
        announced(model -> found(model, 7, 0.1));
        diagnosed(_ -> diagnosis(Verdict.NONE, List.of(), Scenario.of(measured), false));

        assertThat(announced(model -> found(model, 8, 0.2)).cause()).hasSize(2);
        assertThat(currents()).containsExactly(0.2);
    }

    @Test
    void thatNothingIsMissingIsNoNews() throws Exception {
        diagnosed(_ -> nothing());

        assertThat(announced(model -> found(model, 7, 0.1)).cause()).hasSize(2);
    }
}
