package org.auvsim.viz.source;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.LoadScenarioCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.RestoreSnapshotCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;
import org.auvsim.auvsml.message.control.TakeSnapshotCommand;
import org.auvsim.auvsml.message.entity.AddFieldCommand;
import org.auvsim.auvsml.message.entity.AddWorldObjectCommand;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/** What clients' commands do to a chronicle. */
final class ClientDeeds {
    private final Chronicle chronicle;
    private final Map<String, WorldObjectDefinition> added = new HashMap<>();
    private final Map<String, Cut> snapshots = new HashMap<>();
    private final Map<Long, List<Consumer<Course>>> early = new HashMap<>();
    private long earlyStep;
    private Optional<Elsewhere> elsewhere = Optional.empty();
    private Scenario beginning;
    private long askedAt;

    /**
     * Where the world goes on.
     *
     * @param scenario whose world is there then; empty: that which was there
     */
    record Elsewhere(Cut cut, Optional<Scenario> scenario) {}

    /** In a world that began with a scenario. */
    ClientDeeds(Chronicle chronicle, Scenario beginning) {
        this.chronicle = chronicle;
        this.beginning = beginning;
    }

    /** Where the world is to go on, told once; empty if nobody has asked for that. */
    Optional<Elsewhere> takeElsewhere() {
        Optional<Elsewhere> taken = elsewhere;
        elsewhere = Optional.empty();
        taken.flatMap(Elsewhere::scenario).ifPresent(scenario -> beginning = scenario);
        return taken;
    }

    /** The world has gone on after all if this is not the step in which it was asked to leave. */
    void stepMade(long step) {
        if (step > askedAt) {
            elsewhere = Optional.empty();
        }
    }

    /** What the object of a name was made of, if a client has added it. */
    Optional<WorldObjectDefinition> takeAdded(String name) {
        return Optional.ofNullable(added.remove(name));
    }

    /** The recording tells of an object that clients may have commanded already. */
    void arrived(Course course) {
        early.getOrDefault(course.id(), List.of()).forEach(deed -> deed.accept(course));
        early.remove(course.id());
    }

    /** Carries out a command at a time (s). */
    void carryOut(Message message, double time, int order, long step) {
        switch (message) {
            case AddWorldObjectCommand(var definition) -> added.put(definition.name(), definition);
            case AddFieldCommand(var field) -> chronicle.add(field, time, order);
            case ApplyDirectForceCommand(var id, var name, var frame, var vector) ->
                    with(
                            id,
                            step,
                            course ->
                                    course.apply(
                                            time, order, NamedForce.direct(name, frame, vector)));
            case ApplyForceCommand(var id, var name, var frame, var vector, var point) ->
                    with(
                            id,
                            step,
                            course ->
                                    course.apply(
                                            time,
                                            order,
                                            new NamedForce(name, frame, vector, point)));
            case RemoveForceCommand(var id, var name) ->
                    with(id, step, course -> course.removeForce(time, order, name));
            case SetPropulsorCommand(var id, var name, var level) ->
                    with(id, step, course -> course.tell(time, order, name, level));
            case TakeSnapshotCommand(var name) -> snapshots.put(name, new Cut(time, order));
            case RestoreSnapshotCommand(var name) ->
                    Optional.ofNullable(snapshots.get(name))
                            .ifPresent(cut -> ask(new Elsewhere(cut, Optional.empty()), step));
            case ResetCommand() -> ask(beginningOf(beginning), step);
            case LoadScenarioCommand(var scenario) -> ask(beginningOf(scenario), step);
            default -> {
                // moves nothing that is seen
            }
        }
    }

    private static Elsewhere beginningOf(Scenario scenario) {
        return new Elsewhere(Cut.at(scenario.startTime()), Optional.of(scenario));
    }

    private void ask(Elsewhere where, long step) {
        elsewhere = Optional.of(where);
        askedAt = step;
    }

    /** To one that the recording has not told of yet, it is done when that tells of it. */
    private void with(long id, long step, Consumer<Course> deed) {
        Optional<Course> known = chronicle.course(id);
        if (known.isPresent()) {
            deed.accept(known.get());
        } else {
            if (step > earlyStep) {
                early.clear();
                earlyStep = step;
            }
            early.computeIfAbsent(id, _ -> new ArrayList<>()).add(deed);
        }
    }
}
