package org.auvsim.server.feedback;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * Vector adjustment: finds forces that, over this step alone and beside all that act anyway, bring
 * the object to where the robot is (thesis, section 7.2); collisions are met on the way.
 *
 * <p>For a body of mass m without other influences, a constant force 2 m d / dt^2 moves the end of
 * the step by d. With two forces, one for each half h of the step, both the position and the
 * momentum p at its end can be chosen: F1 = m d / h^2 - p / (2 h), F2 = p / h - F1. From there the
 * forces are corrected through the real step until the position is met. If it cannot be met, the
 * object gets as near as was found.
 *
 * @param momentum what becomes of the momentum
 */
public record VectorAdjustmentFeedbackHandler(MomentumRule momentum) implements FeedbackProcessor {
    /** Keeps the projected momentum. */
    public VectorAdjustmentFeedbackHandler() {
        this(MomentumRule.PROJECTED);
    }

    @Override
    public Phase phase() {
        return Phase.BEFORE_STEP;
    }

    @Override
    public void process(DifferentPositionFeedbackMessage feedback, Correction correction) {
        if (correction.object().isFixed()) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "no force moves '%s', which is fixed".formatted(correction.object().name()));
        }
        Problem problem = new Problem(correction, momentum);
        problem.push(SecantSolver.solve(problem::miss, problem.unknowns()));
    }

    /**
     * The equations, all in metres: the unknowns are by how much the forces would shift the end of
     * the step of a free body, in position, and in momentum times h / m.
     */
    private record Problem(Correction correction, MomentumRule rule) {
        int unknowns() {
            return rule == MomentumRule.PROJECTED ? 6 : 3;
        }

        private double half() {
            return correction.duration() / 2;
        }

        private double mass() {
            return correction.object().mass();
        }

        /** By how much the step ends beside what is wanted; empty if it cannot be made. */
        Optional<double[]> miss(double[] shift) {
            return correction.tried(firstForce(shift), secondForce(shift)).map(this::miss);
        }

        private double[] miss(MovementState end) {
            Vec3 position = end.position().minus(correction.target());
            if (rule == MomentumRule.AS_THESIS) {
                return new double[] {position.x(), position.y(), position.z()};
            }
            Vec3 momentum =
                    end.linearMomentum()
                            .minus(correction.projected().linearMomentum())
                            .times(half() / mass());
            return new double[] {
                position.x(), position.y(), position.z(), momentum.x(), momentum.y(), momentum.z()
            };
        }

        void push(double[] shift) {
            correction.push(firstForce(shift), secondForce(shift));
        }

        private Vec3 firstForce(double[] shift) {
            Vec3 position = new Vec3(shift[0], shift[1], shift[2]);
            double scale = mass() / (half() * half());
            if (rule == MomentumRule.AS_THESIS) {
                return position.times(scale / 2);
            }
            return position.minus(momentum(shift).times(0.5)).times(scale);
        }

        private Vec3 secondForce(double[] shift) {
            if (rule == MomentumRule.AS_THESIS) {
                return firstForce(shift);
            }
            double scale = mass() / (half() * half());
            return momentum(shift).times(scale).minus(firstForce(shift));
        }

        private static Vec3 momentum(double[] shift) {
            return new Vec3(shift[3], shift[4], shift[5]);
        }
    }
}
