package org.auvsim.experiments.bench;

import org.auvsim.core.step.EventStepper;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.step.Stepper;

import java.util.function.Supplier;

/** The ways to make a step that can be measured. */
public enum StepperChoice {
    /** The usual one. */
    EVENT(EventStepper::standard),
    /** The thesis' stages. */
    SNAPSHOT(SnapshotStepper::standard);

    private final Supplier<Stepper> stepper;

    StepperChoice(Supplier<Stepper> stepper) {
        this.stepper = stepper;
    }

    /** Such a stepper. */
    public Stepper stepper() {
        return stepper.get();
    }
}
