package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.AsBelieved;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.UnaryOperator;

/** A vehicle of which orientations were told otherwise than they are read. */
class MixedOrientationsTest {
    private static final double HALF = Math.sqrt(0.5);
    private static final Surveyor AS_BELIEVED = new Surveyor(0, Vec3.ZERO, 1, 0);

    private static Optional<String> notice(Surveyor of, UnaryOperator<Quat> told) throws Exception {
        return notice(of.run("run", new Random(4)).turned(told));
    }

    private static Optional<String> notice(MeasuredRun run) throws Exception {
        List<MeasuredRun> runs = List.of(run);
        Noise noise = Noise.of(runs);
        return new MixedOrientations(
                        AsBelieved.fitted(Surveyor.believed(), runs, noise), Course.UNHEARD)
                .notice();
    }

    @Test
    void thoseThatTurnTheWorldIntoTheBodyAre() throws Exception {
        assertThat(notice(AS_BELIEVED, Quat::conjugate))
                .hasValueSatisfying(said -> assertThat(said).contains("scale of -1"));
    }

    @Test
    void thoseInNorthEastAndDownAre() throws Exception {
        Quat axes = new Quat(0, HALF, HALF, 0);
        Quat body = new Quat(0, 1, 0, 0);

        assertThat(notice(AS_BELIEVED, q -> axes.times(q).times(body)))
                .hasValueSatisfying(said -> assertThat(said).contains("north, east, down"));
    }

    /** As by a compass that goes clockwise, and a gyro beside it. */
    @Test
    void thoseThatGrowTheOtherWayWithTheirRatesAre() throws Exception {
        MeasuredRun of = AS_BELIEVED.runWithRate("run", new Random(4));

        assertThat(notice(of.turned(Quat::conjugate).spinning(w -> w.times(-1))))
                .hasValueSatisfying(
                        said ->
                                assertThat(said)
                                        .contains(
                                                "orientations and rates are read the other way",
                                                "and rates about the same axes with a scale"));
        assertThat(notice(of)).isEmpty();
    }

    @Test
    void thoseClockwiseFromNorthWithTheirRatesAre() throws Exception {
        MeasuredRun of = AS_BELIEVED.runWithRate("run", new Random(4));
        Quat axes = new Quat(0, HALF, HALF, 0);
        Quat body = new Quat(0, 1, 0, 0);

        assertThat(
                        notice(
                                of.turned(q -> axes.times(q).times(body))
                                        .spinning(w -> new Vec3(w.x(), -w.y(), -w.z()))))
                .hasValueSatisfying(
                        said ->
                                assertThat(said)
                                        .contains(
                                                "orientations and rates", "clockwise from north"));
    }

    /** Of the four numbers that each row has. */
    @Test
    void thoseWhoseScalarIsLastAre() throws Exception {
        MeasuredRun of = AS_BELIEVED.run("run", new Random(4));
        MeasuredRunBuilder told =
                MeasuredRun.named("run")
                        .commands(of.commands().stream().map(Command::name).toList());
        for (int k = 0; k < of.size(); k++) {
            Vec3 p = of.vector(Channel.POSITION, k).orElseThrow();
            Quat q = of.orientation(k).orElseThrow();
            told.at(of.time(k))
                    .position(p.x(), p.y(), p.z())
                    .orientation(new Quat(q.x(), q.y(), q.z(), q.w()));
            for (int c = 0; c < of.commands().size(); c++) {
                told.command(c, of.commands().get(c).level(k));
            }
        }

        assertThat(notice(told.build()))
                .hasValueSatisfying(
                        said -> assertThat(said).contains("--rename qw=qx,qx=qy,qy=qz,qz=qw"));
    }

    @Test
    void otherMisfitsAreNotTakenForIt() throws Exception {
        assertThat(notice(AS_BELIEVED, q -> q)).isEmpty();
        assertThat(notice(new Surveyor(0, new Vec3(0, 0.3, 0), 1, 0), q -> q)).isEmpty();
        assertThat(notice(AS_BELIEVED, q -> Quat.ofAxisAngle(new Vec3(0, 0, 1), 0.5).times(q)))
                .isEmpty();
    }
}
