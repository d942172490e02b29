package org.auvsim.bench;

import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.FirstOrderIntegrator;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;

/**
 * A diagnosis of three runs of 60 s, 20 rows a second, one of them held out: a survey vehicle with
 * two propulsors ahead and one upward, whose model lacks the drag with the square of the speed.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
public class DiagnosisBenchmark {
    private static final double MASS = 30;
    private static final double YAW_INERTIA = MASS / 12 * (0.8 * 0.8 + 0.5 * 0.5);
    private static final double LINEAR_DRAG = 8;
    private static final double YAW_DAMPING = 2;
    private static final double THRUST = 20;
    private static final double LIFT = 15;
    private static final double ARM = 0.25;
    private static final String SCENARIO =
            """
            <scenario><time-step delta="0.05"/>
              <world-object name="Surveyor" mass="30"><box><size x="0.8" y="0.5" z="0.3"/></box>
                <damping><linear x="8" y="8" z="8"/><angular-linear x="2" y="2" z="2"/></damping>
                <propulsor name="port" maximum-thrust="20">
                  <position x="-0.4" y="0.25" z="0"/></propulsor>
                <propulsor name="starboard" maximum-thrust="20">
                  <position x="-0.4" y="-0.25" z="0"/></propulsor>
                <propulsor name="vertical" maximum-thrust="15">
                  <direction x="0" y="0" z="1"/></propulsor>
              </world-object></scenario>
            """;

    /** What its model lacks (kg/m). */
    private static final double QUADRATIC_DRAG = 12.4;

    private static final long SEED = 7;
    private static final int ROWS_A_SECOND = 20;
    private static final int ROWS = 60 * ROWS_A_SECOND + 1;
    private static final double POSITION_NOISE = 0.01;
    private static final double YAW_NOISE = 0.005;

    private static final Vec3 UP = new Vec3(0, 0, 1);

    /** Levels of port, starboard and vertical change every so many rows. */
    private static final int HELD = 12 * ROWS_A_SECOND;

    private final Investigation investigation;

    /** Of the model as believed, and the runs. */
    public DiagnosisBenchmark() {
        BelievedModel model = believed();
        Random random = new Random(SEED);
        List<MeasuredRun> fit = List.of(run("run 1", random), run("run 2", random));
        List<MeasuredRun> heldOut = List.of(run("run 3", random));
        investigation =
                new Investigation(
                        model, fit, heldOut, Library.of(model, fit), SEED, Progress.SILENT);
    }

    private static BelievedModel believed() {
        try {
            ScenarioLoader loader = ScenarioLoader.load(DiagnosisBenchmark.class.getClassLoader());
            return new BelievedModel(
                    loader.parse(SCENARIO.getBytes(StandardCharsets.UTF_8)), "Surveyor");
        } catch (AuvsmlException e) {
            throw new IllegalStateException(e);
        }
    }

    private static MeasuredRun run(String name, Random random) {
        FirstOrderIntegrator integrator = new DormandPrince853Integrator(1e-6, 0.1, 1e-9, 1e-9);
        MeasuredRunBuilder run =
                MeasuredRun.named(name).commands(List.of("port", "starboard", "vertical"));
        double[] state = {0, 0, -5, 0, 0, 0, 0, 0};
        double[] levels = new double[3];
        for (int k = 0; k < ROWS; k++) {
            if (k % HELD == 0) {
                levels = new double[] {level(random), level(random), level(random)};
            }
            run.at((double) k / ROWS_A_SECOND)
                    .position(
                            state[0] + POSITION_NOISE * random.nextGaussian(),
                            state[1] + POSITION_NOISE * random.nextGaussian(),
                            state[2] + POSITION_NOISE * random.nextGaussian())
                    .orientation(
                            Quat.ofAxisAngle(UP, state[3] + YAW_NOISE * random.nextGaussian()),
                            false,
                            false,
                            true);
            for (int i = 0; i < levels.length; i++) {
                run.command(i, levels[i]);
            }
            integrator.integrate(new Truth(levels), 0, state, 1.0 / ROWS_A_SECOND, state);
        }
        return run.build();
    }

    private static double level(Random random) {
        return random.nextDouble(-0.5, 1);
    }

    /** How it really moves: x, y, z, yaw and their rates, in the axes of the world. */
    private static final class Truth implements FirstOrderDifferentialEquations {
        private final double[] levels;

        Truth(double[] levels) {
            this.levels = levels;
        }

        @Override
        public int getDimension() {
            return 8;
        }

        @Override
        public void computeDerivatives(double t, double[] y, double[] rates) {
            System.arraycopy(y, 4, rates, 0, 4);
            double ahead = THRUST * (levels[0] + levels[1]);
            double drag =
                    LINEAR_DRAG
                            + QUADRATIC_DRAG * Math.sqrt(y[4] * y[4] + y[5] * y[5] + y[6] * y[6]);
            rates[4] = (ahead * Math.cos(y[3]) - drag * y[4]) / MASS;
            rates[5] = (ahead * Math.sin(y[3]) - drag * y[5]) / MASS;
            rates[6] = (LIFT * levels[2] - drag * y[6]) / MASS;
            rates[7] = (ARM * THRUST * (levels[1] - levels[0]) - YAW_DAMPING * y[7]) / YAW_INERTIA;
        }
    }

    /** The first of a process, as of a command: while machine code is still being made. */
    @Benchmark
    @Fork(5)
    @Warmup(iterations = 0)
    @Measurement(iterations = 1)
    public Diagnosis first() {
        return investigation.diagnose();
    }

    /** A later one, as in a server that learns. */
    @Benchmark
    @Fork(1)
    @Warmup(iterations = 8)
    @Measurement(iterations = 9)
    public Diagnosis later() {
        return investigation.diagnose();
    }
}
