package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.SplittableRandom;

/**
 * A vehicle with two thrusters side by side, of which one is wired backwards. It moves in the
 * horizontal plane by equations of its own here.
 */
@Tag("whole-search")
class ReversedThrusterTest {
    private static final double MASS = 12;
    private static final double INERTIA = 1.1;
    private static final double THRUST = 20;
    private static final double SIDE = 0.15;

    /** N s^2/m^2 ahead and aside, N m s/rad. */
    private static final double AHEAD = 9;

    private static final double ASIDE = 30;
    private static final double TURNING = 1.5;

    private static final double INTERVAL = 0.1;
    private static final int SAMPLES = 120;
    private static final int SUBSTEPS = 200;
    private static final double NOISE = 0.01;

    private static BelievedModel model() throws AuvsmlException {
        String scenario =
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="vehicle" mass="12">
                    <box><size x="0.8" y="0.4" z="0.3"/></box>
                    <inertia xx="0.5" yy="0.9" zz="1.1"/>
                    <damping><quadratic x="9" y="30" z="30"/>
                      <angular-linear x="1.5" y="1.5" z="1.5"/></damping>
                    <propulsor name="port" maximum-thrust="20">
                      <position x="0" y="0.15" z="0"/>
                    </propulsor>
                    <propulsor name="starboard" maximum-thrust="20">
                      <position x="0" y="-0.15" z="0"/>
                    </propulsor>
                  </world-object>
                </scenario>
                """;
        return new BelievedModel(
                ScenarioLoader.load(ReversedThrusterTest.class.getClassLoader())
                        .parse(scenario.getBytes(UTF_8)),
                "vehicle");
    }

    /** Thrusters get other levels every 2 s, as drawn by a seed. */
    private static MeasuredRun run(long seed) {
        SplittableRandom lot = new SplittableRandom(seed);
        MeasuredRunBuilder run =
                MeasuredRun.named("run " + seed).commands(List.of("port", "starboard"));
        double[] state = new double[6]; // x, y, heading, ahead, aside, turning
        double port = 0;
        double starboard = 0;
        for (int k = 0; k < SAMPLES; k++) {
            if (k % 20 == 0) {
                port = 0.2 + 0.6 * lot.nextDouble();
                starboard = port + 0.2 * lot.nextDouble() - 0.1;
            }
            run.at(k * INTERVAL)
                    .position(
                            state[0] + NOISE * lot.nextGaussian(),
                            state[1] + NOISE * lot.nextGaussian(),
                            NOISE * lot.nextGaussian())
                    .orientation(
                            Quat.ofAxisAngle(
                                    new Vec3(0, 0, 1), state[2] + NOISE * lot.nextGaussian()))
                    .command(0, port)
                    .command(1, starboard);
            for (int j = 0; j < SUBSTEPS; j++) {
                move(state, -port, starboard);
            }
        }
        return run.build();
    }

    /** By the midpoint rule. */
    private static void move(double[] state, double port, double starboard) {
        double h = INTERVAL / SUBSTEPS;
        double[] half = state.clone();
        add(half, rates(state, port, starboard), h / 2);
        add(state, rates(half, port, starboard), h);
    }

    private static void add(double[] state, double[] rates, double time) {
        for (int i = 0; i < state.length; i++) {
            state[i] += time * rates[i];
        }
    }

    private static double[] rates(double[] s, double port, double starboard) {
        double cos = Math.cos(s[2]);
        double sin = Math.sin(s[2]);
        double ahead = s[3];
        double aside = s[4];
        double turning = s[5];
        return new double[] {
            cos * ahead - sin * aside,
            sin * ahead + cos * aside,
            turning,
            (THRUST * (port + starboard) - AHEAD * Math.abs(ahead) * ahead) / MASS
                    + turning * aside,
            -ASIDE * Math.abs(aside) * aside / MASS - turning * ahead,
            (THRUST * SIDE * (starboard - port) - TURNING * turning) / INERTIA
        };
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void isFound(long seed) throws Exception {
        BelievedModel model = model();
        List<MeasuredRun> fit = List.of(run(seed), run(seed + 10));

        Diagnosis of =
                new Investigation(
                                model,
                                fit,
                                List.of(run(seed + 20)),
                                Library.of(model, fit),
                                seed,
                                Progress.SILENT)
                        .diagnose();

        assertThat(of.verdict()).as(of.sentence()).isEqualTo(Verdict.EXPLAINED);
        assertThat(of.selected()).extracting(Finding::name).containsExactly("thruster_gain (port)");
        assertThat(of.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(-1, within(0.02));
        assertThat(of.sentence()).startsWith("'port' runs backwards: ");
        World served = of.extended().world();
        assertThat(
                        served.object("vehicle")
                                .component(Propulsor.class, "port")
                                .orElseThrow()
                                .commanded(0.5, 0)
                                .thrustAt(0))
                .isCloseTo(-THRUST / 2, within(0.2));
    }
}
