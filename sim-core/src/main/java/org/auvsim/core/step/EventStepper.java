package org.auvsim.core.step;

/**
 * The default step: one frame of the wanted length, in which every collision is met at its own
 * instant and only the bodies that it concerns are moved there.
 *
 * <p>All bodies are integrated over the frame; their swept boxes go through the broad phase, pairs
 * whose boxes overlap get the first instant at which they touch on their trajectories, and these
 * instants are taken in order, in large worlds region by region and in order within each. What
 * collides begins a new segment and is predicted again; a prediction whose bodies have changed
 * since is void (Mirtich 1996; Bannerman, Sargant &amp; Lue 2011 for the queue).
 */
public record EventStepper() implements Stepper {
    /** The usual one. */
    public static EventStepper standard() {
        return new EventStepper();
    }

    @Override
    public StepResult advance(Motion motion, double wanted) {
        Frame frame = motion.frame();
        try {
            frame.begin(wanted);
            while (frame.hasNextEvent()) {
                frame.next();
            }
            return frame.end();
        } catch (RuntimeException e) {
            frame.undo();
            throw e;
        }
    }
}
