package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A magnet that is far away pulls alike everywhere: it is no magnet that runs can tell. */
class FarMagnetTest {
    /** From x = 10 m to 20 m. */
    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("along");
        for (int k = 0; k <= 100; k++) {
            run.at(0.1 * k).position(10 + 0.1 * k, 5, -2);
        }
        return run.build();
    }

    @Test
    void isLookedForWithinThreeTimesThePathsExtent() throws Exception {
        Cause magnet =
                Library.named(
                                List.of("magnetic"),
                                Library.of(FreeSphere.believed(0.1), List.of(run())))
                        .getFirst();

        Vec3 middle = new Vec3(15, 5, -2);
        double[] along = {middle.x(), middle.y(), middle.z()};
        for (int axis = 0; axis < along.length; axis++) {
            Parameter source = magnet.parameters().get(axis);
            assertThat(source.clipped(1e6)).isCloseTo(along[axis] + 30, within(1e-9));
            assertThat(source.clipped(-1e6)).isCloseTo(along[axis] - 30, within(1e-9));
        }
    }
}
