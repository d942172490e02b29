package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.auvsml.message.feedback.Covariance;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Turns a measurement into the world's axes. */
final class WorldAxes {
    /** North, east, down into east, north, up: half a turn about the axis between x and y. */
    private static final Quat NED_TO_WORLD = new Quat(0, Math.sqrt(0.5), Math.sqrt(0.5), 0);

    /** The same, without rounding. */
    private static final Mat3 NED_AXES = new Mat3(0, 1, 0, 1, 0, 0, 0, 0, -1);

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
            case NED -> ofNed();
            case BODY -> ofBody();
        };
    }

    private Target ofNed() {
        Optional<Quat> orientation =
                measured.orientation().map(q -> NED_TO_WORLD.times(q).times(DOWNWARD).normalized());
        return turned(orientation, NED_AXES, NED_AXES);
    }

    /** Relative to the model's object, the velocities along the axes that the robot has. */
    private Target ofBody() {
        Quat body = model.orientation();
        Optional<Quat> robot = measured.orientation().map(q -> body.times(q).normalized());
        Target turned = turned(robot, body.toMatrix(), robot.orElse(body).toMatrix());
        return new Target(
                turned.position().map(p -> p.plus(model.position())),
                robot,
                turned.velocity(),
                turned.angularVelocity(),
                turned.covariance());
    }

    /**
     * All in the world's axes.
     *
     * @param place from the axes of the position, and of the error of the orientation
     * @param motion from the axes of the velocities
     */
    private Target turned(Optional<Quat> orientation, Mat3 place, Mat3 motion) {
        return new Target(
                measured.position().map(place::times),
                orientation,
                measured.velocity().map(motion::times),
                measured.angularVelocity().map(motion::times),
                measured.covariance().map(c -> turned(c, place, motion)));
    }

    private RealMatrix turned(Covariance covariance, Mat3 place, Mat3 motion) {
        List<Mat3> blocks = new ArrayList<>();
        measured.position().ifPresent(_ -> blocks.add(place));
        measured.orientation().ifPresent(_ -> blocks.add(place));
        measured.velocity().ifPresent(_ -> blocks.add(motion));
        measured.angularVelocity().ifPresent(_ -> blocks.add(motion));
        return Covariances.through(diagonal(blocks), matrix(covariance));
    }

    /** Zeros beside these blocks on the diagonal. */
    private static RealMatrix diagonal(List<Mat3> blocks) {
        RealMatrix diagonal = MatrixUtils.createRealMatrix(3 * blocks.size(), 3 * blocks.size());
        for (int k = 0; k < blocks.size(); k++) {
            Mat3 m = blocks.get(k);
            double[][] rows = {
                {m.xx(), m.xy(), m.xz()}, {m.yx(), m.yy(), m.yz()}, {m.zx(), m.zy(), m.zz()}
            };
            diagonal.setSubMatrix(rows, 3 * k, 3 * k);
        }
        return diagonal;
    }

    private static RealMatrix matrix(Covariance covariance) {
        return MatrixUtils.createRealMatrix(covariance.elements());
    }
}
