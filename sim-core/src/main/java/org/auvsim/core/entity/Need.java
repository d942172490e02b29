package org.auvsim.core.entity;

import java.util.List;
import java.util.Optional;

/**
 * What a component cannot do without in its object: a component of some kind, or the one of that
 * kind with a certain name (thesis, section 6.2).
 */
public record Need(Class<? extends Component> type, Optional<String> name) {
    /** Any component of a kind. */
    public static Need of(Class<? extends Component> type) {
        return new Need(type, Optional.empty());
    }

    /** The component of a kind that has this name. */
    public static Need named(Class<? extends Component> type, String name) {
        return new Need(type, Optional.of(name));
    }

    /** Whether a component has all that it needs among these. */
    static boolean isMet(Component component, List<Component> among) {
        return component.needs().isEmpty()
                || among.stream().anyMatch(component.needs().get()::isMetBy);
    }

    /**
     * Fails unless a component of an object has all that it needs among these.
     *
     * @throws IllegalArgumentException naming what is missing, and what there is
     */
    static void require(String object, Component component, List<Component> among) {
        if (!isMet(component, among)) {
            throw new IllegalArgumentException(
                    "component '%s' of '%s' needs a %s"
                            .formatted(
                                    component.name(),
                                    object,
                                    component.needs().orElseThrow().missing(among)));
        }
    }

    /** Whether a component is what is needed. */
    boolean isMetBy(Component component) {
        return type.isInstance(component)
                && name.filter(n -> !n.equals(component.name())).isEmpty();
    }

    private String missing(List<Component> among) {
        List<String> there = among.stream().filter(type::isInstance).map(Component::name).toList();
        return name.isEmpty()
                ? type.getSimpleName() + "; add one"
                : "%s '%s', but there are %s; correct the name or add it"
                        .formatted(type.getSimpleName(), name.get(), there);
    }
}
