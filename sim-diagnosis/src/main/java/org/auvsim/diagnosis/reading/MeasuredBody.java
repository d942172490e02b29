package org.auvsim.diagnosis.reading;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;

import java.util.List;
import java.util.Set;

/** What of a measured body's model matters to its measurements. */
final class MeasuredBody {
    private final WorldObjectDefinition definition;
    private final CommandNames commands;

    MeasuredBody(WorldObjectDefinition definition) {
        this.definition = definition;
        this.commands = new CommandNames(definition);
    }

    String name() {
        return definition.name();
    }

    /** What it can be told. */
    CommandNames commands() {
        return commands;
    }

    /** That of the scenario, which tells angles that are not measured. */
    Quat usualOrientation() {
        return definition.orientation();
    }

    /** The actuators that nothing tells what to do, no behavior either; fixed fins need nobody. */
    List<Actuator> undirected(List<String> told) {
        return commands.actuators().stream()
                .filter(a -> !told.contains(a.name()) && !definition.directs(a) && !isFixed(a))
                .toList();
    }

    private static boolean isFixed(Actuator actuator) {
        return actuator instanceof Fin fin && fin.maximumAngle() == 0;
    }

    /**
     * The actuators of which a recording has all commands: those that it names, and those that no
     * behavior directs.
     */
    List<Actuator> told(Set<String> named) {
        return commands.actuators().stream()
                .filter(a -> named.contains(a.name()) || !definition.directs(a))
                .toList();
    }

    /**
     * The actuators that a behavior directed in a recording, no client, and nothing of the
     * scenario.
     */
    List<Actuator> leftAlone(WorldObjectDefinition recorded, Set<String> named) {
        return told(named).stream()
                .filter(a -> !named.contains(a.name()) && recorded.directs(a))
                .toList();
    }

    /** Whether they are all that drives it; fins may well be fixed. */
    boolean isAllDrive(List<Actuator> some) {
        List<Actuator> drive =
                commands.actuators().stream().filter(a -> !(a instanceof Fin)).toList();
        return !drive.isEmpty() && some.containsAll(drive);
    }
}
