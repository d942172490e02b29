package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.apache.commons.math3.util.FastMath;
import org.assertj.core.data.Offset;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * Balls that are thrown without spin and bounce, by parabolas and impulses in closed form. What
 * swings or blows promises more than a contact does, as impacts tell little to first order.
 */
@Tag("whole-search")
class BouncesTest {
    private static final double RADIUS = 0.1;
    private static final double GRAVITY = 9.80665;
    private static final double NOISE = 0.01;
    private static final double SPACING = 0.02;
    private static final int SAMPLES = 70;

    private static BelievedModel model() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.005"/>
                  <world-object name="floor" fixed="1" restitution="1" friction="0.3"><half-space/></world-object>
                  <world-object name="ball" mass="0.4" restitution="0.75" friction="0.3">
                    <position x="0" y="0" z="1"/><sphere radius="0.1"/><gravity acceleration="9.80665"/>
                  </world-object>
                </scenario>
                """,
                "ball");
    }

    /**
     * A solid ball's run.
     *
     * @param e restitution
     * @param mu friction of ball and floor together
     */
    private static MeasuredRun run(int seed, double e, double mu) {
        Random random = new Random(seed);
        double x = 0;
        double z = 0.6 + 0.4 * random.nextDouble();
        double vx = 3 + random.nextDouble();
        double vz = random.nextDouble();
        double turned = 0;
        double spin = 0; // about y
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed);
        for (int k = 0; k < SAMPLES; k++) {
            Quat attitude =
                    Quat.ofAxisAngle(new Vec3(0, 1, 0), turned + NOISE * random.nextGaussian());
            run.at(k * SPACING)
                    .position(
                            x + NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian(),
                            z + NOISE * random.nextGaussian())
                    .orientation(attitude);
            double left = SPACING;
            while (left > 0) {
                double down = vz + FastMath.sqrt(vz * vz + 2 * GRAVITY * (z - RADIUS));
                double until = FastMath.min(left, down / GRAVITY);
                x += vx * until;
                turned += spin * until;
                z += vz * until - 0.5 * GRAVITY * until * until;
                vz -= GRAVITY * until;
                if (until < left) {
                    double normal = -(1 + e) * vz;
                    double slip = vx - spin * RADIUS;
                    double grip = -2.0 / 7 * slip;
                    double push =
                            FastMath.copySign(FastMath.min(FastMath.abs(grip), mu * normal), grip);
                    vx += push;
                    spin -= 2.5 * push / RADIUS;
                    vz *= -e;
                }
                left -= until;
            }
        }
        return run.build();
    }

    private static Diagnosis diagnosis(double e, double mu) throws Exception {
        BelievedModel model = model();
        List<MeasuredRun> runs = IntStream.range(0, 4).mapToObj(s -> run(s, e, mu)).toList();
        List<Cause> library = Library.of(model, runs);
        return new Investigation(
                        model, runs.subList(0, 2), runs.subList(2, 4), library, 1, Progress.SILENT)
                .diagnose();
    }

    private static double only(Diagnosis diagnosis, String cause) {
        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly(cause);
        return diagnosis.selected().getFirst().quantities().getFirst().value();
    }

    @Test
    void restitutionIsFound() throws Exception {
        assertThat(only(diagnosis(0.64, 0.3), "restitution")).isEqualTo(0.64, Offset.offset(0.01));
    }

    /** Of two bodies the geometric mean counts: 0.1 of 0.3 and 0.033. */
    @Test
    void frictionIsFoundThoughTheModelGrips() throws Exception {
        assertThat(only(diagnosis(0.75, 0.1), "contact_friction"))
                .isEqualTo(0.0333, Offset.offset(0.004));
    }

    /**
     * It slips at its first bounces alone, as it would with a little more friction at none. The
     * turn about one axis is all that its attitudes tell: a heading that is off by half a turn
     * would make any such turn look right, were it taken for a part of a whole rotation.
     */
    @Test
    void frictionIsFoundThatHardlyLetsItSlip() throws Exception {
        assertThat(only(diagnosis(0.75, 0.152), "contact_friction"))
                .isEqualTo(0.077, Offset.offset(0.002));
    }

    @Test
    void nothingIsMissingOfWhatIsBelieved() throws Exception {
        assertThat(diagnosis(0.75, 0.3).selected()).isEmpty();
    }
}
