package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Load;
import org.auvsim.diagnosis.cause.RigidBodyEquations.Now;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What falls and tumbles does so about its centre of mass, wherever its origin is. */
class CentreOfMassTest {
    private static final int SAMPLES = 41;
    private static final Vector3D CENTRE = new Vector3D(0.05, -0.02, 0.04);

    @Test
    void aBodyFallsAsItsCentreOfMassDoes() {
        BelievedModel model = Tank.model("", "<gravity/>");
        Cause cause =
                Library.of(model, List.of(Tank.run(model, SAMPLES))).stream()
                        .filter(one -> one.id().equals("cog_offset"))
                        .findFirst()
                        .orElseThrow();

        RigidMotion[] motion =
                Tank.motion(
                        model,
                        cause.in(
                                model.variant(),
                                new double[] {CENTRE.getX(), CENTRE.getY(), CENTRE.getZ()}),
                        SAMPLES);

        Now end =
                RigidBodyEquations.now(
                        0,
                        new RigidBodyEquations(
                                        new Vector3D(12, 12, 12),
                                        CauseCase.INERTIA,
                                        _ -> Load.force(new Vector3D(0, 0, -12 * CauseCase.G)))
                                .after((SAMPLES - 1) * Tank.SPACING, start()));
        Vector3D origin = end.place().subtract(end.toWorld(CENTRE));
        Vec3 reached = motion[SAMPLES - 1].position();
        assertThat(reached.x()).isCloseTo(origin.getX(), within(CauseCase.SMOOTH));
        assertThat(reached.y()).isCloseTo(origin.getY(), within(CauseCase.SMOOTH));
        assertThat(reached.z()).isCloseTo(origin.getZ(), within(CauseCase.SMOOTH));
    }

    /** How the centre of mass begins. */
    private static double[] start() {
        RigidMotion of = Tank.START;
        Vec3 arm = of.orientation().rotate(new Vec3(CENTRE.getX(), CENTRE.getY(), CENTRE.getZ()));
        Vec3 place = of.position().plus(arm);
        Vec3 velocity = of.velocity().plus(of.angularVelocity().cross(arm));
        Vec3 turning = of.orientation().rotateInverse(of.angularVelocity());
        return new double[] {
            place.x(),
            place.y(),
            place.z(),
            of.orientation().w(),
            of.orientation().x(),
            of.orientation().y(),
            of.orientation().z(),
            velocity.x(),
            velocity.y(),
            velocity.z(),
            turning.x(),
            turning.y(),
            turning.z()
        };
    }
}
