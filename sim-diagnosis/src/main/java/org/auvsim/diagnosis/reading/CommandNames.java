package org.auvsim.diagnosis.reading;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a body can be told in columns: an actuator by its name; a force of the scenario by its name,
 * a dot and an axis, or by its name alone: newtons along its vector there.
 */
final class CommandNames {
    private static final String AXES = "xyz";

    private final WorldObjectDefinition body;
    private final Map<String, List<Part>> parts = new LinkedHashMap<>();

    /**
     * A part of what a column tells.
     *
     * @param command its name as the run has it
     * @param factor of the column's number
     * @param isAngle whether it is an angle
     */
    record Part(String command, double factor, boolean isAngle) {}

    CommandNames(WorldObjectDefinition body) {
        this.body = body;
        for (NamedForce force : body.force()) {
            double[] along = direction(force.vector());
            List<Part> all = new ArrayList<>();
            for (int axis = 0; axis < AXES.length(); axis++) {
                String command = force.name() + "." + AXES.charAt(axis);
                parts.put(command, List.of(new Part(command, 1, false)));
                all.add(new Part(command, along[axis], false));
            }
            if (force.vector().norm() > 0) {
                parts.put(force.name(), all);
            }
        }
        actuators()
                .forEach(
                        each ->
                                parts.put(
                                        each.name(),
                                        List.of(new Part(each.name(), 1, each instanceof Fin))));
    }

    private static double[] direction(Vec3 vector) {
        Vec3 unit = vector.norm() > 0 ? vector.normalized() : vector;
        return new double[] {unit.x(), unit.y(), unit.z()};
    }

    /** The actuators of the body. */
    List<Actuator> actuators() {
        return body.component().stream()
                .filter(Actuator.class::isInstance)
                .map(Actuator.class::cast)
                .toList();
    }

    /** The one of a name. */
    Optional<Actuator> actuator(String name) {
        return actuators().stream().filter(each -> each.name().equals(name)).findFirst();
    }

    /** The body's name. */
    String body() {
        return body.name();
    }

    boolean isKnown(String name) {
        return parts.containsKey(name);
    }

    /** What a column of this name tells. */
    List<Part> parts(String name) {
        return parts.getOrDefault(name, List.of());
    }

    /** All names of columns. */
    List<String> names() {
        return List.copyOf(parts.keySet());
    }
}
