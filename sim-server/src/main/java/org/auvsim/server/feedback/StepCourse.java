package org.auvsim.server.feedback;

/**
 * How the model moves an object through a step, without corrections.
 *
 * @param startTime when the step begins (s)
 * @param endTime when it ends (s)
 */
record StepCourse(double startTime, RigidMotion start, double endTime, RigidMotion end) {
    /** An object that stands still at an instant. */
    static StepCourse at(double time, RigidMotion motion) {
        return new StepCourse(time, motion, time, motion);
    }

    /** The motion at a time, or at the nearer end of the step. */
    RigidMotion at(double time) {
        if (time >= endTime - CorrectiveFeedbackSystem.SAME_TIME) {
            return end;
        }
        if (time <= startTime) {
            return start;
        }
        double duration = endTime - startTime;
        return RigidMotion.between(start, end, duration, (time - startTime) / duration);
    }
}
