package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.NextExperiment;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Optional;

/** What tells models of a cart apart. */
class MenuTest {
    private static final Cart CART = new Cart(0.8, 1e-5, 0);

    private static Judged judged(String id, double... numbers) throws Exception {
        return judged(CART.run(), id, numbers);
    }

    private static Judged judged(MeasuredRun run, String id, double... numbers) throws Exception {
        Hypothesis of = new Hypothesis(List.of(Cart.cause(id, run)), List.of(numbers));
        return Judged.of(Cart.fit(of, run).whole());
    }

    private static Optional<NextExperiment> next(Judged best, Judged other) {
        Fit fit = best.fit();
        return new Menu(fit, Noise.of(List.of(fit.data().getFirst().run())))
                .next(best, List.of(other));
    }

    /** The same motor on the same cart moves both alike; with a known load it does not. */
    @Test
    void aWeakMotorIsToldFromAHeavyCartByAKnownMass() throws Exception {
        NextExperiment next =
                next(judged("thruster_gain", -0.2), judged("mass_error", 0.25)).orElseThrow();

        assertThat(next.id()).isEqualTo("known_mass");
        assertThat(next.description()).endsWith(", for 30.0 s");
        assertThat(next.separates()).containsExactly("thruster_gain (motor)", "mass_error");
    }

    /** Sensors that err lastingly will do so again: another run tells less then. */
    @Test
    void errorsThatLastAreExpectedAgain() throws Exception {
        MeasuredRun erring = CART.run(new LastingError(0.5, 5));

        NextExperiment sharp =
                next(judged("thruster_gain", -0.2), judged("mass_error", 0.25)).orElseThrow();
        NextExperiment dull =
                next(judged(erring, "thruster_gain", -0.2), judged(erring, "mass_error", 0.25))
                        .orElseThrow();

        assertThat(dull.evidence()).isLessThan(sharp.evidence() / 10);
    }

    /** A proposed run at time 0 would be before what began in runs of UNIX time. */
    @Test
    void anotherRunTellsAsMuchWhateverTheClockOfTheRunsIs() throws Exception {
        double unixTime = 1.718e9;

        assertThat(evidenceOfLoss(unixTime))
                .isCloseTo(evidenceOfLoss(0), withinPercentage(5))
                .isPositive();
    }

    /** That the motor lost a fifth of its thrust soon after the beginning, or ever had less. */
    private static double evidenceOfLoss(double begin) throws Exception {
        MeasuredRun run = CART.run(begin);
        Judged gain = judged(run, "thruster_gain", -0.2);
        Judged loss = judged(run, "thruster_loss", 0.2, begin + 1);
        return next(gain, loss).orElseThrow().evidence();
    }

    /** Positions are told half a metre ahead. */
    private static final class Shifted implements Cause {
        @Override
        public String id() {
            return "shifted";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of();
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return model.sensed(sensing -> sensing.shifted(new Vec3(0.5, 0, 0)));
        }
    }

    /** Where it begins is known by that sensor alone. */
    @Test
    void whatAnotherStartExplainsTellsNothing() throws Exception {
        Judged best = judged("thruster_gain", -0.2);
        Hypothesis shifted = best.fit().hypothesis().and(new Shifted(), new double[0]);
        Judged other = Judged.of(best.fit().with(shifted, best.fit().windows()));

        assertThat(next(best, other)).isEmpty();

        Judged heavy = judged("mass_error", 0.25);
        Menu menu = new Menu(best.fit(), Noise.of(List.of(best.fit().data().getFirst().run())));
        assertThat(menu.next(best, List.of(other, heavy)).orElseThrow().separates())
                .as("what can be told is, though not all can")
                .containsExactly("thruster_gain (motor)", "mass_error");
    }

    /**
     * A current that grows with depth is told from none by going deeper; a rail lets none do so.
     */
    @Test
    void whatHoldsTheBodyLimitsTheMenu() throws Exception {
        assertThat(currents("").orElseThrow().id()).isEqualTo("another_depth");
        assertThat(currents("<held z=\"1\"/>")).isEmpty();
    }

    /** In a floor that is less than 5 m below nothing can begin. */
    @Test
    void whatIsInItsWayLimitsTheMenuToo() throws Exception {
        assertThat(currents("", floor(-30)).orElseThrow().id()).isEqualTo("another_depth");
        assertThat(currents("", floor(-3))).isEmpty();
    }

    private static String floor(double z) {
        return """
        <world-object name="floor" fixed="1"><position x="0" y="0" z="%s"/>
          <half-space/></world-object>
        """
                .formatted(z);
    }

    /**
     * Where nothing is driven nothing tells a weak motor from drag: not even the motor's level in
     * the scenario, or its plan, which is no part of the run that is described.
     */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "<propulsor name='motor' maximum-thrust='20' level='1'/>",
                "<propulsor name='motor' maximum-thrust='20' level='1' lag='5'/>",
                """
                <propulsor name='motor' maximum-thrust='20'/>
                <propulsor-schedule name='plan' propulsor='motor'>
                  <timed-level at='0' level='1'/>
                </propulsor-schedule>
                """
            })
    void whatIsNotDrivenIsAtRest(String motor) throws Exception {
        BelievedModel driven =
                Believed.model(
                        """
                        <scenario><time-step delta="0.05"/>
                          <world-object name="cart" mass="10"><sphere radius="0.2"/>
                            <held y="1" z="1" turn-x="1" turn-y="1" turn-z="1"/>
                            %s
                          </world-object>
                        </scenario>
                        """
                                .formatted(motor),
                        "cart");

        NextExperiment next =
                next(judged(driven, "thruster_gain", -0.2), judged(driven, "linear_drag", 0.02))
                        .orElseThrow();

        assertThat(next.description()).startsWith("drive 'motor' alone at 0.7 from rest");
    }

    /** The cart's speed alone is measured, along an axis of its own. */
    @ParameterizedTest
    @EnumSource(Frame.class)
    void whereVelocitiesAreMeasuredTheyTellModelsApart(Frame frame) throws Exception {
        MeasuredRun positions = CART.run();
        MeasuredRunBuilder speeds =
                MeasuredRun.named("speeds")
                        .commands(List.of("motor"))
                        .frame(Channel.VELOCITY, frame);
        for (int k = 1; k < positions.size(); k++) {
            double way =
                    positions.value(Channel.POSITION, k, 0)
                            - positions.value(Channel.POSITION, k - 1, 0);
            double time = positions.time(k) - positions.time(k - 1);
            speeds.at(positions.time(k))
                    .measured(Channel.VELOCITY, way / time, Double.NaN, Double.NaN);
            speeds.command(0, positions.commands().getFirst().level(k));
        }
        MeasuredRun run = speeds.build();

        NextExperiment next =
                next(judged(run, "thruster_gain", -0.2), judged(run, "mass_error", 0.25))
                        .orElseThrow();

        assertThat(next.id()).isEqualTo("known_mass");
    }

    private static Optional<NextExperiment> currents(String held) throws Exception {
        return currents(held, "");
    }

    private static Optional<NextExperiment> currents(String held, String floor) throws Exception {
        BelievedModel dragged =
                Believed.model(
                        """
                        <scenario><time-step delta="0.05"/>
                          <world-object name="cart" mass="10"><sphere radius="0.2"/>
                            <damping><linear x="2" y="2" z="2"/></damping>
                            <propulsor name="motor" maximum-thrust="20"/>
                            %s
                          </world-object>
                          %s
                        </scenario>
                        """
                                .formatted(held, floor),
                        "cart");
        return next(
                judged(dragged, "current_constant", 0, 0, 0),
                judged(dragged, "current_shear", 0.1, 0));
    }

    private static Judged judged(BelievedModel model, String id, double... numbers) {
        List<MeasuredRun> runs = List.of(CART.run());
        Cause cause =
                Library.of(model, runs).stream()
                        .filter(c -> c.id().equals(id))
                        .findFirst()
                        .orElseThrow();
        Noise noise = Noise.of(runs);
        Hypothesis of = new Hypothesis(List.of(cause), List.of(numbers));
        Stepping stepping = Stepping.longer(model).getFirst();
        return Judged.of(Following.of(stepping, of, Misses.of(runs, noise), noise).whole());
    }
}
