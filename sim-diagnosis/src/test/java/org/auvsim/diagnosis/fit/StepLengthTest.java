package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Kick;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** Steps are as long as the data allows, and those of differences longer where they can be. */
class StepLengthTest {
    /** Of a column's size. */
    private static final double SHARE = 0.03;

    /** Of that by the moment from which on a thruster fails: it falls anywhere within a step. */
    private static final double SHARE_OF_MOMENT = 0.15;

    private static final double SMALL = 1e-4;

    /** Of turns (rad). */
    private static final double NOISE = 1.5e-4;

    private static Fit following(BelievedModel model, MeasuredRun run) {
        Noise noise = Noise.of(List.of(run));
        List<Misses> data = Misses.of(List.of(run), noise);
        return Following.of(Stepping.exact(model), Hypothesis.NONE, data, noise);
    }

    private static double step(BelievedModel model) {
        return model.scenario().timeStep().delta();
    }

    @Test
    void aSmoothMotionIsDifferentiatedInLongerSteps() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);

        Stepping stepping = StepLength.converged(following(model, MeasuredVehicle.run(model)));

        assertThat(stepping.fine()).isEqualTo(model);
        assertThat(step(stepping.rough())).isGreaterThan(0.049);
    }

    /** Four rows a step, and no prediction that the data could tell from those of each row. */
    @Test
    void predictionsPassRowsByThatAreDenserThanTheMotionNeeds() throws Exception {
        BelievedModel model = FreeSphere.believed(0.025);
        Fit following = following(model, coasting());

        Stepping stepping = StepLength.converged(following);

        assertThat(stepping.fine()).isEqualTo(model);
        assertThat(step(stepping.model())).isGreaterThan(0.049);
        assertThat(doFor(following.in(stepping))).isTrue();
        assertThat(doFor(shaken(following.in(stepping), 40))).isFalse();
    }

    /** A search in shorter steps would end no better. */
    @Test
    void stepsDoWhereFarMoreIsMissedThanTheyMove() throws Exception {
        BelievedModel model = FreeSphere.believed(0.025);
        Fit following = following(model, coasting());
        Stepping stepping = StepLength.converged(following);

        assertThat(doFor(shaken(following.in(stepping), 3))).isTrue();
    }

    private static MeasuredRun coasting() {
        MeasuredRunBuilder run = MeasuredRun.named("coasting");
        Random random = new Random(2);
        for (int k = 0; k < 200; k++) {
            double t = 0.025 * k;
            run.at(t).position(t + 0.01 * random.nextGaussian(), Double.NaN, Double.NaN);
        }
        return run.build();
    }

    private static boolean doFor(Fit fit) {
        return StepLength.doFor(Judged.of(fit.whole()));
    }

    /** By what the steps were not chosen for: 20 N on 1 kg, at some rad/s. */
    private static Fit shaken(Fit fit, double omega) {
        Cause shaking =
                Library.of(fit.model(), List.of(fit.data().getFirst().run())).stream()
                        .filter(cause -> cause.id().equals("periodic_force"))
                        .findFirst()
                        .orElseThrow();
        double[] numbers = new double[shaking.parameters().size()];
        numbers[0] = 20;
        for (int p = 0; p < numbers.length; p++) {
            boolean isFrequency = shaking.parameters().get(p).name().equals("omega");
            numbers[p] = isFrequency ? omega : numbers[p];
        }
        return fit.with(Hypothesis.NONE.and(shaking, numbers), fit.windows());
    }

    @Test
    void stepsAreHalvedUntilThatMakesNoDifference() throws Exception {
        BelievedModel coarse = MeasuredVehicle.model(0.05);
        BelievedModel fine = MeasuredVehicle.model(0.005);
        MeasuredRun tumbling = MeasuredVehicle.run(fine, new Vec3(9, -2, 14));

        Stepping stepping = StepLength.converged(following(coarse, tumbling));

        assertThat(step(stepping.model())).isBetween(0.003, 0.026);
    }

    /** Each number by less than a tenth of the noise, but a thousand of them together by more. */
    @Test
    void stepsAreHalvedWhereAllNumbersTogetherTell() throws Exception {
        BelievedModel coarse = MeasuredVehicle.model(0.05);
        BelievedModel fine = MeasuredVehicle.model(0.005);
        MeasuredRun run = MeasuredVehicle.run(fine, new Vec3(2.43, -0.54, 3.78));
        Fit turning = following(coarse, noisier(run));

        Stepping stepping = StepLength.converged(turning);

        assertThat(step(stepping.fine())).isLessThan(0.026);
        assertThat(StepLength.areFine(turning)).isFalse();
        assertThat(StepLength.areFine(turning.in(stepping))).isTrue();
        assertThat(step(StepLength.finer(turning))).isEqualTo(0.025);
    }

    /** Its turns, by so much that no number tells of steps any more. */
    private static MeasuredRun noisier(MeasuredRun run) {
        Random random = new Random(4);
        MeasuredRunBuilder noisier = MeasuredRun.named("noisier");
        noisier.commands(run.commands().stream().map(Command::name).toList());
        for (int k = 0; k < run.size(); k++) {
            Vec3 p = run.vector(Channel.POSITION, k).orElseThrow();
            Quat turn =
                    Quat.ofAxisAngle(new Vec3(1, 0, 0), NOISE * random.nextGaussian())
                            .times(
                                    Quat.ofAxisAngle(
                                            new Vec3(0, 1, 0), NOISE * random.nextGaussian()))
                            .times(
                                    Quat.ofAxisAngle(
                                            new Vec3(0, 0, 1), NOISE * random.nextGaussian()));
            noisier.at(run.time(k))
                    .position(p.x(), p.y(), p.z())
                    .orientation(run.orientation(k).orElseThrow().times(turn));
            for (int c = 0; c < run.commands().size(); c++) {
                noisier.command(c, run.commands().get(c).level(k));
            }
        }
        return noisier.build();
    }

    /** An extended model may have a force that begins during the run. */
    @Test
    void stepsOfWhatSomethingAbruptActsOnAreHalved() throws Exception {
        BelievedModel coarse = kicked(MeasuredVehicle.model(0.05));
        MeasuredRun tumbling =
                MeasuredVehicle.run(MeasuredVehicle.model(0.005), new Vec3(9, -2, 14));

        Stepping stepping = StepLength.converged(following(coarse, tumbling));

        assertThat(step(stepping.model())).isBetween(0.003, 0.026);
    }

    private static BelievedModel kicked(BelievedModel model) {
        Effect kick = new Kick(new Vec3(1e-3, 0, 0), 1, 0.075);
        Variant kicked = model.variant().with(body -> body.effect(kick));
        return new BelievedModel(model.extended(kicked), model.body());
    }

    @Test
    void whatTheEngineMustCutAnywayIsNotMadeLonger() throws Exception {
        BelievedModel stiff = thick(MeasuredVehicle.model(0.025), 1500);

        Stepping stepping = StepLength.converged(following(stiff, MeasuredVehicle.run(stiff)));

        assertThat(step(stepping.rough())).isLessThan(0.026);
    }

    private static BelievedModel thick(BelievedModel model, double damping) {
        Vec3 all = new Vec3(damping, damping, damping);
        Effect water = new Damping(all, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);
        Variant thick = model.variant().with(body -> body.effect(water));
        return new BelievedModel(model.extended(thick), model.body());
    }

    @Test
    void whatComesAndGoesWithinMomentsIsDifferentiatedInThePredictionsSteps() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        Stepping longer = Stepping.longer(model).getFirst();
        Variant kicked = model.variant().with(body -> body.effect(new Kick(Vec3.ZERO, 1, 0.075)));

        assertThat(longer.of(model.variant())).isEqualTo(longer);
        assertThat(longer.of(kicked)).isEqualTo(Stepping.exact(model));
    }

    /** At where a search begins: one step of a guess away from it. */
    @Test
    void derivativesInLongerStepsAreThoseOfShortOnesForEveryCause() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        Fit fit = following(model, MeasuredVehicle.run(model));
        Stepping longer = StepLength.converged(fit);
        Misses data = fit.data().getFirst();
        Window window = fit.windows().getFirst().getFirst();
        for (Cause cause : Library.of(model, List.of(data.run()))) {
            Hypothesis begun = begun(cause, cause.guesses(List.of(data.run())).getFirst());
            Moves moves = begun.moves(model.variant());
            Variant variant = begun.in(model.variant());
            double[][] exact = columns(Stepping.exact(model), variant, data, window, moves);
            double[][] rough = columns(longer, variant, data, window, moves);
            for (int p = 0; p < exact.length; p++) {
                double size = distance(exact[p], new double[exact[p].length]);
                assertThat(distance(exact[p], rough[p]))
                        .as("%s, parameter %d", cause.name(), p)
                        .isLessThan(share(cause.parameters().get(p)) * size + SMALL);
            }
        }
    }

    private static double share(Parameter parameter) {
        return parameter.name().equals("from") ? SHARE_OF_MOMENT : SHARE;
    }

    private static Hypothesis begun(Cause cause, Guess guess) {
        double[] theta = guess.theta().stream().mapToDouble(Double::doubleValue).toArray();
        for (int c = 0; c < guess.columns().size(); c++) {
            theta[guess.columns().get(c)] += guess.steps().get(c);
        }
        return Hypothesis.NONE.and(cause, theta);
    }

    private static double[][] columns(
            Stepping stepping, Variant variant, Misses data, Window window, Moves moves) {
        return new Shooting(stepping, variant, data).derivatives(window, 1, moves).byParameter;
    }

    private static double distance(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return Math.sqrt(sum);
    }
}
