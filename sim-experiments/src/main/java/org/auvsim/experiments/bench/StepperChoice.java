package org.auvsim.experiments.bench;

import org.auvsim.core.step.EventStepper;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.step.Stepper;

/** The ways to make a step that can be measured. */
public enum StepperChoice {
    /** The usual one. */
    EVENT,
    /** The thesis' stages. */
    SNAPSHOT;

    /** Such a stepper. */
    public Stepper stepper() {
        return switch (this) {
            case EVENT -> EventStepper.standard();
            case SNAPSHOT -> SnapshotStepper.standard();
        };
    }
}
