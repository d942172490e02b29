package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.Covariance;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Turns a measurement into the world's axes. */
final class WorldAxes {
    /** North, east, down into east, north, up: half a turn about the axis between x and y. */
    private static final Quat NED_TO_WORLD =
            new Quat(0, Math.sqrt(0.5), Math.sqrt(0.5), 0);

    /** Half a turn about x: from axes forward, left, up to axes forward, right, down. */
    private static final Quat DOWNWARD = new Quat(0, 1, 0, 0);

    private final Measurement measured;
    private final RigidMotion model;

    /** For a measurement while the model moves so. */
    WorldAxes(Measurement measured, RigidMotion model) {
        this.measured = measured;
        this.model = model;
    }

    Target target() {
        return switch (measured.frame()) {
            case WORLD ->
                    new Target(
                            measured.position(),
                            measured.orientation(),
                            measured.velocity(),
                            measured.angularVelocity(),
                            measured.covariance().map(WorldAxes::matrix));
            case NED -> turned(NED_TO_WORLD, NED_TO_WORLD);
            case BODY -> ofBody();
        };
    }

    /** Relative to the model's object, the velocities along the axes that the robot has. */
    private Target ofBody() {
        Quat body = model.orientation();
        Quat robot = measured.orientation().map(q -> body.times(q).normalized()).orElse(body);
        Target turned = turned(body, robot);
        return new Target(
                turned.position().map(p -> p.plus(model.position())),
                measured.orientation().map(_ -> robot),
                turned.velocity(),
                turned.angularVelocity(),
                turned.covariance());
    }

    private Target turned(Quat place, Quat motion) {
        return new Target(
                measured.position().map(p -> turn(place, p)),
                measured.orientation().map(q -> place.times(q).times(DOWNWARD).normalized()),
                measured.velocity().map(v -> turn(motion, v)),
                measured.angularVelocity().map(w -> turn(motion, w)),
                measured.covariance().map(c -> turned(c, place, motion)));
    }

    private Vec3 turn(Quat turn, Vec3 v) {
        return turn == NED_TO_WORLD ? new Vec3(v.y(), v.x(), -v.z()) : turn.rotate(v);
    }

    private Matrix turned(Covariance covariance, Quat place, Quat motion) {
        List<Mat3> blocks = new ArrayList<>();
        measured.position().ifPresent(_ -> blocks.add(place.toMatrix()));
        measured.orientation().ifPresent(_ -> blocks.add(place.toMatrix()));
        measured.velocity().ifPresent(_ -> blocks.add(motion.toMatrix()));
        measured.angularVelocity().ifPresent(_ -> blocks.add(motion.toMatrix()));
        return matrix(covariance).within(Matrix.blocks(blocks));
    }

    private static Matrix matrix(Covariance covariance) {
        return Matrix.of(covariance.elements(), covariance.size());
    }
}
