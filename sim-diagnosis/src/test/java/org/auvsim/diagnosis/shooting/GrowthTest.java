package org.auvsim.diagnosis.shooting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.stream.Stream;

/** A pendulum of 1 kg, half a metre long, that stands upright or hangs. */
class GrowthTest {
    private static final int SAMPLES = 41;
    private static final double SPACING = 0.05;
    private static final RigidMotion AT_REST =
            new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

    /** By cosh of the time, and by cos of it, over the time constant. */
    @ParameterizedTest(name = "centre of mass at {0} m, {1} windows")
    @CsvSource({"0.5, 1", "0.5, 2", "0.5, 4", "-0.5, 4"})
    void isThatOfTheLinearPendulum(double centre, int windows) throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.01"/>
                          <world-object name="Pole" mass="1">
                            <box><size x="0.1" y="0.1" z="2"/></box>
                            <inertia xx="0.25" yy="0.25" zz="0.1"/>
                            <centre-of-mass x="0" y="0" z="%s"/>
                            <pinned><axis x="0" y="1" z="0"/></pinned><gravity/>
                          </world-object>
                        </scenario>
                        """
                                .formatted(centre),
                        "Pole");
        MeasuredRun run = still();
        Shooting shooting =
                new Shooting(
                        Stepping.exact(model),
                        model.variant(),
                        new Misses(run, Noise.of(List.of(run))));
        int length = (SAMPLES - 1) / windows;

        double growth =
                Growth.of(
                        Stream.iterate(0, from -> from + length)
                                .limit(windows)
                                .map(from -> new Window(from, from + length, AT_REST))
                                .map(window -> shooting.derivatives(window, 1, Moves.NONE))
                                .toList());

        double time = (SAMPLES - 1) * SPACING * Math.sqrt(9.80665);
        assertThat(growth)
                .isCloseTo(centre > 0 ? Math.cosh(time) : Math.abs(Math.cos(time)), within(0.5));
    }

    private static MeasuredRun still() {
        MeasuredRunBuilder run = MeasuredRun.named("still");
        for (int k = 0; k < SAMPLES; k++) {
            double told = k % 2 == 0 ? 1e-3 : -1e-3;
            run.at(k * SPACING)
                    .orientation(Quat.ofAxisAngle(new Vec3(0, 1, 0), told), false, true, false);
        }
        return run.build();
    }
}
