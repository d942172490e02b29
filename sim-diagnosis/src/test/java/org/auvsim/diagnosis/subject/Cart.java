package org.auvsim.diagnosis.subject;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.search.Search;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.diagnosis.shooting.Stepping;

import java.util.List;
import java.util.Random;

/**
 * A cart of 10 kg with a motor of 20 N, of which only the way ahead is measured.
 *
 * @param gain of the motor, 1 as believed
 * @param drag N s/m; there is none in the model
 * @param current m/s; likewise
 */
public record Cart(double gain, double drag, double current) {
    private static final double MASS = 10;
    private static final double THRUST = 20;
    private static final double SPACING = 0.1;
    private static final int SAMPLES = 400;
    private static final double NOISE = 0.002;

    public static BelievedModel believed() throws AuvsmlException {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="cart" mass="10"><sphere radius="0.2"/>
                    <propulsor name="motor" maximum-thrust="20"/>
                  </world-object>
                </scenario>
                """,
                "cart");
    }

    /** The same, held but for the way along x. */
    public static BelievedModel onRails() throws AuvsmlException {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="cart" mass="10"><sphere radius="0.2"/>
                    <held y="1" z="1" turn-x="1" turn-y="1" turn-z="1"/>
                    <propulsor name="motor" maximum-thrust="20"/>
                  </world-object>
                </scenario>
                """,
                "cart");
    }

    /**
     * Under constant thrust, speed approaches a steady one exponentially: of the speed at one row a
     * share is kept at the next, and a mean share on the way.
     */
    public MeasuredRun run() {
        return run(0);
    }

    /** The same by a clock that is at a time (s) where the run begins. */
    public MeasuredRun run(double begin) {
        return run(MeasuredRun.named("run"), begin);
    }

    /** The same, of which the way is told with an error that lasts. */
    public MeasuredRun run(LastingError error) {
        return run(MeasuredRun.named("run").lastingError(Channel.POSITION, 0, error), 0);
    }

    private MeasuredRun run(MeasuredRunBuilder begun, double begin) {
        Random random = new Random(3);
        MeasuredRunBuilder run = begun.commands(List.of("motor"));
        double x = 0;
        double v = 0;
        double level = 0;
        double lost = drag / MASS * SPACING;
        double kept = Math.exp(-lost);
        double meanKept = lost > 0 ? -Math.expm1(-lost) / lost : 1;
        double wayGained = wayGained(lost, meanKept);
        for (int k = 0; k < SAMPLES; k++) {
            level = k % 25 == 0 ? random.nextDouble(-1, 1) : level;
            double measured = x + NOISE * random.nextGaussian();
            run.at(begin + k * SPACING)
                    .measured(Channel.POSITION, measured, Double.NaN, Double.NaN);
            run.command(0, level);
            double gained = (gain * THRUST * level + drag * current) / MASS * SPACING;
            x += SPACING * (v * meanKept + gained * wayGained);
            v = v * kept + gained * meanKept;
        }
        return run.build();
    }

    /**
     * The way made in a row (1 = its time by what speed grows in it without drag) from rest: (e^-z
     * - 1 + z) / z^2 of what is lost, by powers where differences would lose its digits.
     */
    private static double wayGained(double lost, double meanKept) {
        return lost < 1e-3 ? 0.5 - lost / 6 + lost * lost / 24 : (1 - meanKept) / lost;
    }

    /** A cause of the library. */
    public Cause cause(String id) throws AuvsmlException {
        return cause(id, run());
    }

    /** The same for a run. */
    public static Cause cause(String id, MeasuredRun run) throws AuvsmlException {
        return Library.of(believed(), List.of(run)).stream()
                .filter(cause -> cause.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    /** What the search finds among some causes. */
    public Search.Found found(List<Cause> causes) throws AuvsmlException {
        Course course = new Course(Progress.SILENT);
        return new Search(believed(), List.of(run()), causes, Way.THOROUGH, course).found();
    }

    /** A fit whose windows follow the run under a hypothesis. */
    public Fit fit(Hypothesis hypothesis) throws AuvsmlException {
        return fit(hypothesis, run());
    }

    /** The same of one of its runs. */
    public static Fit fit(Hypothesis hypothesis, MeasuredRun run) throws AuvsmlException {
        Noise noise = Noise.of(List.of(run));
        List<Misses> data = Misses.of(List.of(run), noise);
        return Following.of(Stepping.longer(believed()).getFirst(), hypothesis, data, noise);
    }
}
