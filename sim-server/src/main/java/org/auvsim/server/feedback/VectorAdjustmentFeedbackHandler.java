package org.auvsim.server.feedback;

import org.auvsim.auvsml.document.MomentumRule;

/**
 * Vector adjustment: finds forces and torques that, over this step alone and beside all that act
 * anyway, bring the object to where the robot is (thesis, section 7.2); collisions are met on the
 * way.
 *
 * <p>For a body of mass m without other influences, a constant force 2 m d / dt^2 moves the end of
 * the step by d. With two forces, one for each half h of the step, both the position and the
 * velocity at its end can be chosen: to move them by d and v, F1 = m (d / h^2 - v / (2 h)), F2 = m
 * v / h - F1; of turns the same holds with torques and the inertia tensor. From there they are
 * corrected through the real step until it ends as was measured; what was not measured ends as the
 * model has it. If that cannot be met, the object gets as near as was found, and the notification
 * says so.
 *
 * @param momentum what becomes of the velocity
 */
public record VectorAdjustmentFeedbackHandler(MomentumRule momentum) implements FeedbackProcessor {
    /** Keeps the projected velocity. */
    public VectorAdjustmentFeedbackHandler() {
        this(MomentumRule.PROJECTED);
    }

    @Override
    public Phase phase() {
        return Phase.BEFORE_STEP;
    }

    @Override
    public void process(Correction correction) {
        PushProblem problem = new PushProblem(correction, momentum);
        SecantSolver solution = SecantSolver.solve(problem::miss, problem.unknowns());
        problem.push(solution.found());
        if (!solution.isExact()) {
            correction.fellShort();
        }
    }
}
