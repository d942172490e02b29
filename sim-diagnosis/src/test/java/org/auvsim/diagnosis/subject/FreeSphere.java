package org.auvsim.diagnosis.subject;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.diagnosis.model.BelievedModel;

/** A sphere of 1 kg on which, as its model has it, nothing acts. */
public final class FreeSphere {
    private FreeSphere() {}

    /** Its model in steps of so many seconds. */
    public static BelievedModel believed(double step) throws AuvsmlException {
        String scenario =
                """
                <scenario><time-step delta="%s"/>
                  <world-object name="sphere" mass="1"><sphere radius="0.1"/></world-object>
                </scenario>
                """
                        .formatted(step);
        return Believed.model(scenario, "sphere");
    }
}
