package org.auvsim.diagnosis.result;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.run.Channel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;

class SentenceTest {
    private static final Finding DRAG =
            found("quadratic_drag", List.of(new Quantity("k", "kg/m", 12.43)), List.of(0.31));
    private static final Finding CURRENT =
            found(
                    "current_constant",
                    List.of(
                            new Quantity("u.x", "m/s", 0.2),
                            new Quantity("u.y", "m/s", -0.1),
                            new Quantity("u.z", "m/s", 0)),
                    List.of(0.004, 0.004, 0.004));
    private final Sentences sentences =
            new Sentences(
                    Map.of(
                            Channel.POSITION, new Gain(0.83, 0.0112, 0.01),
                            Channel.ORIENTATION, new Gain(0.1, 0.1, 0.1)),
                    false,
                    true);

    private static Finding found(String cause, List<Quantity> quantities, List<Double> deviations) {
        return new Finding(cause, Optional.empty(), quantities, deviations, 0.99, true);
    }

    @Test
    void oneCause() {
        assertThat(sentences.explained(List.of(DRAG), 0.991, List.of()).text())
                .isEqualTo(
                        "Quadratic drag is missing: 12.4 +- 0.3 kg/m; it explains 99.1 % of the"
                                + " misfit; held-out position error 0.83 m -> 0.011 m, noise is"
                                + " 0.010 m");
    }

    /** Of waves of 2 rad/s in deep water the wave number is 0.41 rad/m. */
    @ParameterizedTest
    @CsvSource({
        "0.40, 0.02, The force of waves is missing",
        "0.01, 0.02, 'An oscillating force, the same everywhere, is missing'",
        "0.10, 0.30, The force of waves is missing",
        "0.10, 0.02, The force of waves is missing",
    })
    void wavesThatDoNotRun(double waveNumber, double deviation, String words) {
        List<Quantity> numbers =
                List.of(
                        new Quantity("amplitude", "N", 3),
                        new Quantity("omega", "rad/s", 2),
                        new Quantity("wave_number", "rad/m", waveNumber));
        assertThat(Phrases.of(found("wave_forcing", numbers, List.of(0.1, 0.01, deviation))))
                .isEqualTo(words);
    }

    /** Where its source is says nothing of what it does. */
    @ParameterizedTest
    @CsvSource({
        "-2.0, 3, A magnetic attraction is missing",
        "2.0, 3, A magnetic attraction is missing",
        "2.0, -3, A magnetic repulsion is missing",
    })
    void aMagnetAttractsByItsStrength(double x, double strength, String words) {
        List<Quantity> numbers =
                List.of(
                        new Quantity("source.x", "m", x),
                        new Quantity("source.y", "m", 0),
                        new Quantity("source.z", "m", 0),
                        new Quantity("strength", "N m^4", strength));
        assertThat(Phrases.of(found("magnetic", numbers, List.of()))).isEqualTo(words);
    }

    @Test
    void aCauseThatMattersToNoHeldOutRun() {
        Sentences same =
                new Sentences(
                        Map.of(Channel.POSITION, new Gain(0.01001, 0.01, 0.01)), false, false);
        assertThat(same.explained(List.of(DRAG), 0.991, List.of()).text())
                .endsWith(
                        "; held-out position error 0.010 m -> 0.010 m, noise is 0.010 m; but begun"
                                + " otherwise these runs are predicted just as well without it");
        assertThat(same.explained(List.of(DRAG, CURRENT), 0.991, List.of()).text())
                .endsWith(
                        "; but begun otherwise these runs are predicted just as well without them");
    }

    /** Of what was not tried nothing is said. */
    @Test
    void aSearchThatWasStopped() {
        assertThat(sentences.explained(List.of(DRAG), 0.991, List.of()).stopped().text())
                .startsWith(
                        "Stopped before the end; the best so far: quadratic drag is missing: 12.4");
        assertThat(sentences.none().stopped().text())
                .startsWith(
                        "Stopped before the end; the best so far: the model as it is; no cause"
                                + " tried so far gains enough; held-out position error 0.83 m");
        Discrepancy seen =
                new Discrepancy(
                        Channel.POSITION,
                        new Axis(Frame.WORLD, 'x'),
                        "run1",
                        3,
                        Vec3.ZERO,
                        OptionalDouble.empty(),
                        0.4);
        assertThat(sentences.unexplained(Optional.of(seen)).stopped().text())
                .startsWith(
                        "Stopped before the end; the best so far: the model lacks something that no"
                            + " cause tried so far explains; the best of these remove 40.0 % of it,"
                            + " and what they leave shows most in the position along x, at 3.00 s"
                            + " of run1;")
                .doesNotContain("known");
        assertThat(Sentences.stoppedAtOnce().text())
                .startsWith("Stopped before any cause was fitted");
    }

    @Test
    void aSearchForSomeCausesSaysNothingOfOthers() {
        Discrepancy seen =
                new Discrepancy(
                        Channel.POSITION,
                        new Axis(Frame.WORLD, 'x'),
                        "run1",
                        3,
                        Vec3.ZERO,
                        OptionalDouble.empty(),
                        0.4);

        assertThat(sentences.unexplained(Optional.of(seen)).ofSome().text())
                .startsWith(
                        "The model lacks something that none of the requested causes explains;"
                                + " the best of these remove 40.0 % of it, and what they leave"
                                + " shows most in the position along x, at 3.00 s of run1;");
        assertThat(sentences.none().ofSome().text()).isEqualTo(sentences.none().text());
    }

    /** What was tried of them before it was stopped is fewer still. */
    @Test
    void aSearchForSomeCausesThatWasStopped() {
        Sentence unexplained = sentences.unexplained(Optional.empty());

        assertThat(List.of(unexplained.stopped().ofSome(), unexplained.ofSome().stopped()))
                .extracting(Sentence::text)
                .allMatch(
                        text ->
                                text.startsWith(
                                        "Stopped before the end; the best so far: the model lacks"
                                                + " something that no cause tried so far explains;"
                                                + " held-out"));
    }

    @Test
    void doubtfulDataIsNotBelievedWithoutAWord() {
        assertThat(sentences.none().doubted().text())
                .startsWith(sentences.none().text())
                .endsWith("; but the notices cast doubt on the data: read them first");
    }

    @Test
    void twoCauses() {
        assertThat(sentences.explained(List.of(DRAG, CURRENT), 0.9, List.of()).text())
                .startsWith(
                        "Quadratic drag is missing: 12.4 +- 0.3 kg/m, and a constant current is"
                                + " missing: (0.200 +- 0.004, -0.100 +- 0.004, 0.000 +- 0.004) m/s;"
                                + " together they explain 90.0 % of the misfit; held-out");
    }

    @Test
    void aCauseWithSeveralNumbers() {
        Finding periodic =
                found(
                        "periodic_force",
                        List.of(
                                new Quantity("force.x", "N", 2),
                                new Quantity("force.y", "N", 0),
                                new Quantity("omega", "rad/s", 1.5)),
                        List.of(0.1, 0.1, 0.002));
        assertThat(sentences.explained(List.of(periodic), 1, List.of()).text())
                .startsWith(
                        "A periodic force is missing: force (2.00 +- 0.10, 0.00 +- 0.10) N, omega"
                                + " 1.500 +- 0.002 rad/s; it explains more than 99.9 %");
    }

    /** Of a pure number neither the words nor the unit say what it is. */
    @ParameterizedTest
    @CsvSource({
        "thruster_gain, factor, 1, 'The thrust of all thrusters is wrong: 0.85 +- 0.02 times what"
                + " the model has'",
        "sensor_scale, scale.x, 1, 'The scale of the measured positions is wrong: 0.85 +- 0.02"
                + " times the true one along x'",
        "sensor_offset, offset.z, m, 'The measured positions have a constant offset: 0.85 +- 0.02 m"
                + " along z'",
        "thruster_deadzone, width, 1, 'A dead zone of all thrusters is missing: width 0.85 +-"
                + " 0.02'",
        "restitution, e, 1, 'The restitution of impacts is wrong: e 0.85 +- 0.02'",
        "thruster_misalignment, tilt, rad, 'The direction of all thrusters is wrong: tilt 0.85 +-"
                + " 0.02 rad'",
        "thruster_advance, loss, s/m, 'The thrust of all thrusters falls with speed: loss 0.85 +-"
                + " 0.02 s/m'",
        "thruster_astern, factor, 1, 'The thrust of all thrusters astern is wrong: 0.85 +- 0.02"
                + " times what the model has'",
        "thruster_fade, fade, 1/s, 'The thrust of all thrusters fades: fade 0.85 +- 0.02 1/s'",
        "thruster_lag, tau, s, 'A lag of all thrusters is missing: 0.85 +- 0.02 s'"
    })
    void theOnlyNumberSaysWhatItIs(String cause, String name, String unit, String words) {
        Finding one = found(cause, List.of(new Quantity(name, unit, 0.85)), List.of(0.02));
        assertThat(sentences.explained(List.of(one), 0.9, List.of()).text())
                .startsWith(words + "; it ");
    }

    @Test
    void theAnglesOfAThrusterAreToldApart() {
        Finding angle =
                found(
                        "thruster_misalignment",
                        List.of(new Quantity("angle", "rad", 0.1)),
                        List.of(0.004));
        Alternative tilt =
                new Alternative(List.of("thruster_misalignment (tilt of port)"), true, "", "");
        assertThat(sentences.explained(List.of(angle), 0.9, List.of(tilt)).text())
                .contains("or the tilt of 'port' is wrong");
    }

    @Test
    void whatTheDataCannotTellApart() {
        Finding mass =
                found("mass_error", List.of(new Quantity("factor", "1", 1.2)), List.of(0.004));
        Alternative gain =
                new Alternative(List.of("thruster_gain"), true, "mass 1.20, or gain 0.83", "");
        Alternative worse = new Alternative(List.of("magnus"), false, "", "");
        assertThat(sentences.explained(List.of(mass), 0.9, List.of(gain, worse)).text())
                .startsWith(
                        "The mass is wrong: 1.200 +- 0.004 times what the model has; it explains"
                                + " 90.0 %")
                .endsWith(
                        "; this data cannot tell apart: the mass is wrong, or the thrust of all"
                                + " thrusters is wrong; it could be mass 1.20, or gain 0.83");
    }

    /** What both have is not in question. */
    @Test
    void whatAlternativesShareIsLeftOut() {
        Finding drag =
                found("quadratic_drag", List.of(new Quantity("k", "kg/m", 12.4)), List.of(0.3));
        Alternative drift =
                new Alternative(List.of("position_drift", "quadratic_drag"), true, "", "");
        Alternative fewer = new Alternative(List.of("quadratic_drag"), true, "", "");
        List<Finding> both = List.of(drag, CURRENT);
        assertThat(sentences.explained(both, 0.9, List.of(drift)).text())
                .endsWith(
                        "; this data cannot tell apart: a constant current is missing, or the"
                                + " measured position drifts");
        assertThat(sentences.explained(both, 0.9, List.of(fewer)).text())
                .endsWith(
                        "; this data cannot tell apart: quadratic drag is missing and a constant"
                                + " current is missing, or quadratic drag is missing");
    }

    /** The page lists them all. */
    @Test
    void ofManyThatCannotBeToldApartTheMostProbableIsNamed() {
        List<Alternative> many =
                Stream.of("position_drift", "mass_error", "magnus")
                        .map(cause -> new Alternative(List.of(cause), true, "", ""))
                        .toList();
        assertThat(sentences.explained(List.of(CURRENT), 0.9, many).text())
                .endsWith(
                        "; this data cannot tell apart: a constant current is missing, or the"
                                + " measured position drifts, and 2 more sets of causes");
    }

    @Test
    void nothing() {
        assertThat(
                        new Sentences(
                                        Map.of(Channel.POSITION, new Gain(0.011, 0.011, 0.01)),
                                        false,
                                        false)
                                .none()
                                .text())
                .isEqualTo(
                        "This data shows nothing missing from the model; held-out position error"
                                + " 0.011 m, noise is 0.010 m");
    }

    @Test
    void somethingOfWhichNoCauseTakesAnything() {
        Discrepancy seen =
                new Discrepancy(
                        Channel.POSITION,
                        new Axis(Frame.WORLD, 'x'),
                        "run1",
                        3,
                        Vec3.ZERO,
                        OptionalDouble.empty(),
                        0);

        assertThat(sentences.unexplained(Optional.of(seen)).text())
                .contains(
                        "at 3.00 s of run1; no cause removes enough of it to be"
                                + " believed; held-out");
    }

    @Test
    void causesThatWereNotTriedAreNotSaidToTakeNothing() {
        Discrepancy seen =
                new Discrepancy(
                        Channel.POSITION,
                        new Axis(Frame.WORLD, 'x'),
                        "run1",
                        3,
                        Vec3.ZERO,
                        OptionalDouble.empty(),
                        0);
        Sentence unexplained = sentences.unexplained(Optional.of(seen));

        assertThat(List.of(unexplained.stopped().text(), unexplained.ofSome().text()))
                .allMatch(s -> s.contains("; none of these removes enough of it to be believed;"))
                .noneMatch(s -> s.contains("no cause removes"));
    }

    @Test
    void whatPredictsHeldOutRunsWorseIsToldSo() {
        Sentences worse =
                new Sentences(Map.of(Channel.POSITION, new Gain(0.83, 2.1, 0.01)), false, false);

        assertThat(worse.unexplained(Optional.empty()).text())
                .endsWith(
                        "error 0.83 m -> 2.1 m, noise is 0.010 m; these causes make the prediction"
                                + " worse");
    }

    @Test
    void somethingUnknown() {
        Discrepancy seen =
                new Discrepancy(
                        Channel.ORIENTATION,
                        new Axis(Frame.WORLD, 'z'),
                        "run2",
                        12.44,
                        Vec3.ZERO,
                        OptionalDouble.of(0.312),
                        0.41);
        assertThat(sentences.unexplained(Optional.of(seen)).text())
                .isEqualTo(
                        "The model lacks something that no known cause explains; the best known"
                                + " causes remove 41.0 % of it, and what they leave shows most in"
                                + " the orientation about z, at 12.4 s of run2, mostly at 0.31 Hz;"
                                + " held-out position error 0.83 m -> 0.011 m, noise is 0.010 m");
    }

    /** Speeds of a log are those along the vehicle. */
    @ParameterizedTest
    @CsvSource({
        "VELOCITY, x, the velocity along the body's x (ahead)",
        "VELOCITY, y, the velocity along the body's y (left)",
        "ANGULAR_VELOCITY, z, the angular velocity about the body's z (up)",
    })
    void whatIsMeasuredInTheBodysAxesIsToldSo(Channel channel, char axis, String words) {
        Discrepancy seen =
                new Discrepancy(
                        channel,
                        new Axis(Frame.BODY, axis),
                        "run1",
                        3,
                        Vec3.ZERO,
                        OptionalDouble.empty(),
                        0);

        assertThat(sentences.unexplained(Optional.of(seen)).text())
                .contains("it shows most in " + words + ", at 3.00 s of run1;");
    }

    /** A compass that is off changes no position. */
    @Test
    void theChannelThatGainsIsTold() {
        Map<Channel, Gain> gains =
                Map.of(
                        Channel.POSITION, new Gain(0.23, 0.23, 0.23),
                        Channel.ORIENTATION, new Gain(0.07, 0.02, 0.02));

        assertThat(new Sentences(gains, false, true).explained(List.of(DRAG), 1, List.of()).text())
                .endsWith(
                        "; held-out orientation error 0.070 rad -> 0.020 rad, noise is 0.020 rad");
    }

    /** As many who predict as well by other numbers of noise do. */
    @Test
    void aLittleMoreErrorIsNotWorse() {
        Sentences same =
                new Sentences(
                        Map.of(Channel.POSITION, new Gain(0.0100, 0.0101, 0.01)), false, false);

        assertThat(same.unexplained(Optional.empty()).text()).doesNotContain("worse");
    }

    @Test
    void otherChannelsAndRunsLeftOut() {
        Sentences depth = new Sentences(Map.of(Channel.VELOCITY, new Gain(2, 1, 0.5)), true, true);
        assertThat(depth.unexplained(Optional.empty()).text())
                .isEqualTo(
                        "The model lacks something that no known cause explains; left-out velocity"
                                + " error 2.0 m/s -> 1.0 m/s, noise is 0.50 m/s");
        assertThat(new Sentences(Map.of(), false, false).none().text())
                .isEqualTo("This data shows nothing missing from the model");
    }

    /** A vehicle with a rudder and elevators has two lifts of its hull. */
    @ParameterizedTest
    @ValueSource(strings = {"sway and yaw", "heave and pitch"})
    void theLiftOfAHullSaysInWhichPlane(String plane) {
        Finding lift =
                new Finding(
                        "hull_lift",
                        Optional.of(plane),
                        List.of(new Quantity("Yuv", "kg/m", 3)),
                        List.of(0.1),
                        0.99,
                        true);

        assertThat(Phrases.of(lift)).isEqualTo("Lift of the hull in " + plane + " is missing");
        assertThat(Phrases.of(lift.name())).isEqualTo(Phrases.of(lift));
    }

    /** Who reads of a measurement clock looks at sensors, and not at the log of commands. */
    @Test
    void measurementsThatAreAheadOfTheCommandsAreCalledSo() {
        Finding ahead =
                found("clock_offset", List.of(new Quantity("offset", "s", -0.398)), List.of(0.002));

        assertThat(sentences.explained(List.of(ahead), 0.9, List.of()).text())
                .startsWith(
                        "The measurements are ahead of the commands, which may be stamped late:"
                                + " 0.398 +- 0.002 s; ");
    }

    @Test
    void aThrusterWithAFactorBelow0RunsBackwards() {
        List<Quantity> factor = List.of(new Quantity("factor", "1", -1.02));
        Finding all = found("thruster_gain", factor, List.of(0.02));
        Finding one =
                new Finding("thruster_gain", Optional.of("port"), factor, List.of(0.02), 0.9, true);

        assertThat(sentences.explained(List.of(one), 0.9, List.of()).text())
                .startsWith("'port' runs backwards: -1.02 +- 0.02 times what the model has; ");
        assertThat(sentences.explained(List.of(all), 0.9, List.of()).text())
                .startsWith("All thrusters run backwards: -1.02 +- 0.02 times what the model has");
    }

    @Test
    void whatThereIsTooMuchOfAndWhoseItIs() {
        Finding less = found("linear_drag", List.of(new Quantity("c", "N s/m", -3)), List.of(0.1));
        assertThat(sentences.explained(List.of(less), 0.9, List.of()).text())
                .startsWith("There is too much linear drag: 3.00 +- 0.10 N s/m; ");
        assertThat(Phrases.of("thruster_gain (port)")).isEqualTo("The thrust of 'port' is wrong");
        assertThat(Phrases.of("eddy_wash")).isEqualTo("Eddy wash is missing");
        assertThat(Phrases.of("eddy_wash (fin)")).isEqualTo("Eddy wash of 'fin' is missing");
    }
}
