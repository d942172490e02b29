package org.auvsim.diagnosis.shooting;

import org.auvsim.core.actuator.Battery;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Component;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;

import java.util.List;

/**
 * A model whose body does nothing of its own accord, and whose propulsors have long been at rest,
 * whatever the scenario has them do: as one has it before a run of one's own.
 */
final class Idle {
    /** World time (s) so long ago that no lag remembers it. */
    private static final double LONG_AGO = -1e9;

    private Idle() {}

    /** The same model, idle. */
    static BelievedModel of(BelievedModel model) {
        Variant believed = model.variant();
        List<Component> components =
                believed.body().component().stream()
                        .filter(c -> !(c instanceof Behavior) || c instanceof Battery)
                        .map(c -> c instanceof Propulsor p ? p.commanded(0, LONG_AGO) : c)
                        .toList();
        Variant idle = believed.with(body -> body.components(components));
        return new BelievedModel(model.extended(idle), model.body());
    }
}
