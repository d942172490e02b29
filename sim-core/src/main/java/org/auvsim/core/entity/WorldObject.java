package org.auvsim.core.entity;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * A rigid body with components (thesis, section 6.3): from a pebble, which has none, to a vehicle
 * with propulsors, behaviors and sensors.
 */
public final class WorldObject extends RigidBody {
    private final List<Component> components;
    private List<Actuator> actuators = List.of();
    private List<Behavior> behaviors = List.of();

    WorldObject(long id, WorldObjectDefinition definition, BodyState state) {
        super(id, definition, state);
        components = new ArrayList<>(definition.component());
        sort();
        resultantChanged();
    }

    WorldObject(WorldObject original, BodyState copiedState) {
        super(original, copiedState);
        components = new ArrayList<>(original.components);
        sort();
    }

    private void sort() {
        actuators = List.copyOf(components(Actuator.class));
        behaviors = List.copyOf(components(Behavior.class));
    }

    /** What it would have to be made from to be as it is now. */
    public WorldObjectDefinition presentDefinition() {
        return definition().as(this);
    }

    /** All components, in the order in which they were added. */
    public List<Component> components() {
        return List.copyOf(components);
    }

    /** The components of a type. */
    public <C extends Component> List<C> components(Class<C> type) {
        List<C> found = new ArrayList<>();
        for (Component component : components) {
            if (type.isInstance(component)) {
                found.add(type.cast(component));
            }
        }
        return found;
    }

    /** The first component of a type. */
    public <C extends Component> Optional<C> component(Class<C> type) {
        return components(type).stream().findFirst();
    }

    /** The component of a type and name. */
    public <C extends Component> Optional<C> component(Class<C> type, String name) {
        for (Component component : components) {
            if (type.isInstance(component) && component.name().equals(name)) {
                return Optional.of(type.cast(component));
            }
        }
        return Optional.empty();
    }

    /**
     * Adds a component.
     *
     * @throws IllegalArgumentException if the object has one of that name, or lacks what the
     *     component needs
     */
    public void add(Component component) {
        if (indexOf(component.name()) >= 0) {
            throw new IllegalArgumentException(
                    "'%s' already has a component '%s'; remove it or choose another name"
                            .formatted(name(), component.name()));
        }
        Need.require(name(), component, components);
        components.add(component);
        changed(component);
    }

    /**
     * Puts a component in the place of the one with the same name, of the same class.
     *
     * @throws IllegalArgumentException if there is none, it is of another class, or the object
     *     lacks what the new one needs
     */
    public void replace(Component component) {
        int index = existing(component.name());
        Class<?> before = components.get(index).getClass();
        if (before != component.getClass()) {
            throw new IllegalArgumentException(
                    "component '%s' of '%s' is a %s and cannot become a %s; remove it first"
                            .formatted(
                                    component.name(),
                                    name(),
                                    before.getSimpleName(),
                                    component.getClass().getSimpleName()));
        }
        Need.require(name(), component, components);
        components.set(index, component);
        changed(component);
    }

    /**
     * Removes a component.
     *
     * @throws IllegalArgumentException if there is none of that name, or another one needs it
     */
    public void remove(String componentName) {
        int index = existing(componentName);
        List<Component> left = new ArrayList<>(components);
        Component removed = left.remove(index);
        for (Component other : left) {
            if (!Need.isMet(other, left)) {
                throw new IllegalArgumentException(
                        "component '%s' of '%s' cannot be removed: '%s' needs it"
                                .formatted(componentName, name(), other.name()));
            }
        }
        components.remove(index);
        changed(removed);
    }

    /**
     * Tells an actuator what to do from now on.
     *
     * @param command in the actuator's own unit: a level, an angle (rad)
     * @throws IllegalArgumentException if the object has no actuator of this type and name, or the
     *     command is outside what it can do
     */
    public void command(Class<? extends Actuator> type, String actuatorName, double command) {
        Actuator actuator =
                component(type, actuatorName).orElseThrow(() -> noActuator(type, actuatorName));
        if (actuator.command() != command) {
            replace(actuator.commanded(command, time()));
        }
    }

    private IllegalArgumentException noActuator(
            Class<? extends Actuator> type, String actuatorName) {
        return new IllegalArgumentException(
                "'%s' has no %s '%s'; it has %s"
                        .formatted(
                                name(),
                                type.getSimpleName().toLowerCase(Locale.ROOT),
                                actuatorName,
                                components(type).stream().map(Component::name).toList()));
    }

    @Override
    public List<Actuator> actuators() {
        return actuators;
    }

    /** The behaviors, in the order in which they act. */
    public List<Behavior> behaviors() {
        return behaviors;
    }

    private void changed(Component component) {
        if (component instanceof Behavior) {
            behaviors = List.copyOf(components(Behavior.class));
            behaviorsChanged();
        }
        if (component instanceof Actuator) {
            actuators = List.copyOf(components(Actuator.class));
            resultantChanged();
        } else {
            equipmentChanged();
        }
    }

    private int indexOf(String componentName) {
        for (int i = 0; i < components.size(); i++) {
            if (components.get(i).name().equals(componentName)) {
                return i;
            }
        }
        return -1;
    }

    private int existing(String componentName) {
        int index = indexOf(componentName);
        if (index < 0) {
            throw new IllegalArgumentException(
                    "'%s' has no component '%s'; it has %s"
                            .formatted(
                                    name(),
                                    componentName,
                                    components.stream().map(Component::name).toList()));
        }
        return index;
    }
}
