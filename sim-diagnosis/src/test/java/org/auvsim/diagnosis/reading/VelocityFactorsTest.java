package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Random;

/** A body that goes round, its place fixed once a second, its velocities ten times as often. */
class VelocityFactorsTest {
    private static final int SAMPLES = 601;
    private static final double NOISE = 0.1;

    /** Ahead at 0.7 m/s and to the left at 0.3 to -0.3 m/s, each told so many times as large. */
    private static MeasuredRun run(double u, double v, double pitch, boolean tellsTilt) {
        Random random = new Random(7);
        MeasuredRunBuilder run = MeasuredRun.named("run").frame(Channel.VELOCITY, Frame.BODY);
        Vec3 place = Vec3.ZERO;
        for (int k = 0; k < SAMPLES; k++) {
            double t = 0.1 * k;
            double yaw = 0.1 * t;
            Quat level = Quat.ofAxisAngle(new Vec3(0, 0, 1), yaw);
            Quat turned = level.times(Quat.ofAxisAngle(new Vec3(0, 1, 0), pitch));
            double left = 0.3 * Math.cos(0.05 * t);
            place = place.plus(turned.rotate(new Vec3(0.7, left, 0)).times(k == 0 ? 0 : 0.1));
            run.at(t)
                    .measured(
                            Channel.VELOCITY,
                            u * 0.7 + 0.05 * random.nextGaussian(),
                            v * left + 0.05 * random.nextGaussian(),
                            0.02 * random.nextGaussian());
            if (tellsTilt) {
                run.orientation(turned);
            } else {
                run.orientation(level, false, false, true);
            }
            if (k % 10 == 0) {
                run.position(
                        place.x() + NOISE * random.nextGaussian(),
                        place.y() + NOISE * random.nextGaussian(),
                        place.z() + NOISE * random.nextGaussian());
            }
        }
        return run.build();
    }

    @ParameterizedTest(name = "{0} and {1} times")
    @CsvSource({
        "3.6, 3.6, km/h",
        "1.944, 1.944, knots",
        "2.237, 2.237, mph",
        "3.281, 3.281, feet per second",
        "100, 100, cm/s"
    })
    void anotherUnitIsSuspected(double u, double v, String unit) {
        assertThat(new VelocityFactors(run(u, v, 0, true)).suspicions())
                .hasSize(2)
                .allMatch(seen -> seen.what().contains("are they in " + unit + "?"));
    }

    @Test
    void oneThatIsPositiveTheOtherWayIsTold() {
        assertThat(new VelocityFactors(run(1, -1, 0, true)).suspicions())
                .singleElement()
                .matches(seen -> seen.axis() == 1)
                .matches(seen -> seen.what().contains("a scale of -1"));
    }

    /** A sensor may be off by a scale that is no unit's. */
    @ParameterizedTest(name = "{0} times")
    @CsvSource({"1", "1.1", "0.8", "1.5"})
    void otherFactorsAreOfNoUnit(double factor) {
        assertThat(new VelocityFactors(run(factor, 1, 0, true)).suspicions()).isEmpty();
    }

    /** It dives by what its velocity upwards does not say, as it is not known that it pitches. */
    @Test
    void whatTiltsUnseenTellsNothingOfItsVelocityUpwards() {
        assertThat(new VelocityFactors(run(1, 1, 0.4, false)).suspicions()).isEmpty();
    }
}
