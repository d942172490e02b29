package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** What holds for each cause of the library. */
class LibraryCausesTest {
    private static final int SAMPLES = 40;

    static Stream<Arguments> causes() {
        return Stream.of(Tank.vehicle(), Tank.steered(), Tank.pendulum())
                .flatMap(model -> library(model).stream().map(c -> Arguments.of(c, model)));
    }

    private static List<Cause> library(BelievedModel model) {
        return Library.of(model, List.of(Tank.run(model, SAMPLES)));
    }

    /**
     * Its section has the parameters by the names that reports use, and a picture that is there.
     */
    @ParameterizedTest(name = "{0}")
    @MethodSource("causes")
    void thePageOfCausesHasIt(Cause cause, BelievedModel model) throws Exception {
        Path docs = Path.of("..", "docs");
        String page = Files.readString(docs.resolve("causes.md"), StandardCharsets.UTF_8);
        int from = page.indexOf("\n## " + cause.id() + "\n");
        assertThat(from).as("a section of docs/causes.md").isPositive();
        String section = page.substring(from + 1).split("\n##? ", 2)[0];
        double[] theta = numbers(cause.guesses(List.of()).getFirst());
        for (Quantity quantity : cause.quantities(theta)) {
            assertThat(section).contains("`" + quantity.name().replaceAll("[.][yz]", ".x"));
            assertThat(section.contains(quantity.unit()) || quantity.unit().equals("1")).isTrue();
        }
        assertThat(section).contains("(images/causes/" + cause.id() + ".svg)");
        assertThat(docs.resolve("images/causes/" + cause.id() + ".svg")).exists();
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("causes")
    void guessesAreNumbersWithWhichItDoesNothing(Cause cause, BelievedModel model) {
        List<Guess> guesses = cause.guesses(List.of());
        assertThat(guesses).isNotEmpty();
        for (Guess guess : guesses) {
            assertThat(guess.theta()).hasSameSizeAs(cause.parameters());
            assertThat(guess.columns()).isNotEmpty().hasSameSizeAs(guess.steps());
            double[] theta = numbers(guess);
            for (int i = 0; i < theta.length; i++) {
                Parameter parameter = cause.parameters().get(i);
                assertThat(parameter.clipped(theta[i])).isEqualTo(theta[i]);
                assertThat(parameter.scale()).isPositive().isFinite();
            }
            assertThat(guess.columns()).allMatch(c -> theta[c] == 0);
            assertThat(cause.in(model.variant(), theta)).isEqualTo(model.variant());
        }
        assertThat(cause.quantities(numbers(guesses.getFirst())))
                .allMatch(q -> Double.isFinite(q.value()));
    }

    /** What a cause changes is in the model's motion, or in what is told of it. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("causes")
    void aStepOfAGuessCanBeSimulated(Cause cause, BelievedModel model) {
        List<Ensemble.Entrant> moved =
                cause.guesses(List.of()).stream()
                        .map(guess -> cause.in(model.variant(), moved(cause, guess)))
                        .map(variant -> new Ensemble.Entrant(variant, Tank.START))
                        .toList();
        RigidMotion[][] motions =
                Ensemble.simulate(model, Tank.times(SAMPLES), 0, SAMPLES - 1, moved);
        for (RigidMotion[] motion : motions) {
            RigidMotion end = motion[SAMPLES - 1];
            assertThat(end.position().isFinite() && end.velocity().isFinite()).isTrue();
        }
    }

    /** All but what sensors do, which no scenario states, comes back from a text. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("causes")
    void whatItAddsCanBeWrittenAndRead(Cause cause, BelievedModel model) throws Exception {
        Guess guess = cause.guesses(List.of()).getFirst();
        Variant moved = cause.in(model.variant(), moved(cause, guess));
        Scenario extended = with(model.scenario(), moved);
        byte[] text =
                AuvsmlMapper.load(getClass().getClassLoader())
                        .encode(extended)
                        .getBytes(StandardCharsets.UTF_8);
        assertThat(ScenarioLoader.load(getClass().getClassLoader()).parse(text))
                .isEqualTo(extended);
        boolean isOfSensors = !moved.sensing().equals(model.variant().sensing());
        assertThat(extended.equals(model.scenario())).isEqualTo(isOfSensors);
    }

    private static double[] numbers(Guess guess) {
        return guess.theta().stream().mapToDouble(Double::doubleValue).toArray();
    }

    private static double[] moved(Cause cause, Guess guess) {
        double[] theta = numbers(guess);
        for (int i = 0; i < guess.columns().size(); i++) {
            int column = guess.columns().get(i);
            theta[column] += guess.steps().get(i);
            assertThat(cause.parameters().get(column).clipped(theta[column]))
                    .isEqualTo(theta[column]);
        }
        return theta;
    }

    private static Scenario with(Scenario scenario, Variant variant) {
        List<Field<?>> fields = new ArrayList<>(scenario.field());
        fields.addAll(variant.currents());
        List<WorldObjectDefinition> objects = new ArrayList<>(scenario.worldObject());
        objects.replaceAll(o -> o.name().equals(variant.body().name()) ? variant.body() : o);
        return new Scenario(
                scenario.startTime(),
                scenario.boundingSpheres(),
                scenario.allowOverlaps(),
                scenario.feedbackHorizon(),
                scenario.timeStep(),
                scenario.stepper(),
                scenario.integrator(),
                scenario.feedbackTimestepping(),
                scenario.feedbackProcessor(),
                scenario.releasedObject(),
                scenario.datum(),
                fields,
                objects);
    }
}
