package org.auvsim.diagnosis.fit;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.diagnosis.model.BelievedModel;

/** A sphere of 1 kg on which, as its model has it, nothing acts. */
final class FreeSphere {
    private FreeSphere() {}

    /** Its model in steps of so many seconds. */
    static BelievedModel believed(double step) throws AuvsmlException {
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
