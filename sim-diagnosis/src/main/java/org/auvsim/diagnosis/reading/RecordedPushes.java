package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.diagnosis.run.ScheduledForce;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The forces that clients of a recording let act on a body, from when until when. */
final class RecordedPushes implements RecordedFeedback.Listener {
    private final long id;
    private final List<ScheduledForce> ended = new ArrayList<>();
    private final Map<String, Push> acting = new LinkedHashMap<>();

    private record Push(double from, NamedForce force) {}

    RecordedPushes(long id) {
        this.id = id;
    }

    @Override
    public void sent(double time, Message message) {
        switch (message) {
            case ApplyForceCommand(long of, var name, var frame, var vector, var point)
                    when of == id ->
                    begin(time, new NamedForce(name, frame, vector, point));
            case ApplyDirectForceCommand(long of, var name, var frame, var vector) when of == id ->
                    begin(time, NamedForce.direct(name, frame, vector));
            case RemoveForceCommand(long of, var name) when of == id -> end(time, name);
            default -> {
                // of no interest here
            }
        }
    }

    private void begin(double time, NamedForce force) {
        end(time, force.name());
        acting.put(force.name(), new Push(time, force));
    }

    private void end(double time, String name) {
        Optional.ofNullable(acting.remove(name))
                .filter(push -> push.from() < time)
                .ifPresent(push -> ended.add(new ScheduledForce(push.from(), time, push.force())));
    }

    /** All of them; those that never ended go on beyond the run. */
    List<ScheduledForce> forces() {
        List<ScheduledForce> all = new ArrayList<>(ended);
        acting.values()
                .forEach(
                        push ->
                                all.add(
                                        new ScheduledForce(
                                                push.from(), Double.MAX_VALUE, push.force())));
        return all;
    }
}
