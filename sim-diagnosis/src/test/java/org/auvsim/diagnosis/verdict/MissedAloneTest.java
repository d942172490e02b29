package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.AsBelieved;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.Random;

/** A vehicle that the model predicts, some of its positions off as no cause has it. */
class MissedAloneTest {
    /** Positions swing by so many metres beside the body, and its heading by so many radians. */
    private static MeasuredRun run(double place, double turn) {
        MeasuredRun of = new Surveyor(0, Vec3.ZERO, 1, 0).run("run", new Random(4));
        return Surveyor.told(
                of,
                k ->
                        of.vector(Channel.POSITION, k)
                                .orElseThrow()
                                .plus(new Vec3(place * swing(of, k), 0, 0)),
                k ->
                        Quat.ofAxisAngle(new Vec3(0, 0, 1), turn * swing(of, k))
                                .times(of.orientation(k).orElseThrow()));
    }

    private static double swing(MeasuredRun of, int sample) {
        return Math.sin(0.7 * of.time(sample));
    }

    private static Optional<String> notice(MeasuredRun run) throws Exception {
        List<MeasuredRun> runs = List.of(run);
        Noise noise = Noise.of(runs);
        return MissedAlone.notice(AsBelieved.fitted(Surveyor.believed(), runs, noise), noise);
    }

    @Test
    void oneChannelIsNamedIfAllElseIsPredicted() throws Exception {
        assertThat(notice(run(0.05, 0)))
                .hasValueSatisfying(
                        said ->
                                assertThat(said)
                                        .startsWith(
                                                "the model as it is predicts everything but the"
                                                        + " position to the noise: either a force"
                                                        + " acts that does not turn the body, or"));
    }

    /** The fit follows a heading that is off, and with it the path. */
    @Test
    void oneThatPullsAtOthersIsNamedToo() throws Exception {
        assertThat(notice(run(0, 0.08)))
                .hasValueSatisfying(
                        said ->
                                assertThat(said)
                                        .contains("everything but the orientation", "torque"));
    }

    @Test
    void nothingIsSaidIfOthersAreMissedToo() throws Exception {
        assertThat(notice(run(0.05, 0.1))).isEmpty();
        assertThat(notice(run(0, 0))).isEmpty();
    }
}
