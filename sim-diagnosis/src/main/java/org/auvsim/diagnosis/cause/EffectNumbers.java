package org.auvsim.diagnosis.cause;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.math.Vec3;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * The numbers of a record that are 0 unless they are stated: those of components with such a
 * default, numbers and vectors. The others stay as their defaults have them.
 */
final class EffectNumbers {
    /** Units of places, times and directions: how much of an effect there is has others. */
    private static final Set<String> SHAPES = Set.of("m", "s", "rad");

    private final Object[] defaults;
    private final List<RecordComponent> components = new ArrayList<>();
    private final List<Integer> places = new ArrayList<>();
    private final Constructor<?> constructor;

    /** Those of an effect whose components are all as their defaults have them. */
    EffectNumbers(Effect untouched) {
        RecordComponent[] all = untouched.getClass().getRecordComponents();
        defaults = new Object[all.length];
        for (int i = 0; i < all.length; i++) {
            defaults[i] = value(all[i], untouched);
            boolean isZero = defaults[i].equals(0.0) || defaults[i].equals(Vec3.ZERO);
            if (isZero && all[i].isAnnotationPresent(Default.class)) {
                components.add(all[i]);
                places.add(i);
            }
        }
        constructor = constructor(untouched.getClass(), all);
    }

    private static Object value(RecordComponent component, Effect of) {
        try {
            component.getAccessor().setAccessible(true);
            return component.getAccessor().invoke(of);
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException(
                    "component '%s' of effect %s cannot be read"
                            .formatted(component.getName(), of.getClass().getName()),
                    e);
        }
    }

    private static Constructor<?> constructor(Class<?> type, RecordComponent[] components) {
        try {
            Constructor<?> canonical =
                    type.getDeclaredConstructor(
                            Arrays.stream(components)
                                    .map(RecordComponent::getType)
                                    .toArray(Class<?>[]::new));
            canonical.setAccessible(true);
            return canonical;
        } catch (NoSuchMethodException e) {
            throw new IllegalArgumentException(type.getName() + " is not a record", e);
        }
    }

    /** Whether it has any such number, and does nothing while all of them are 0. */
    boolean mayBeAbsent(Setting s) {
        return !components.isEmpty()
                && !ActingAtOnce.on(s, effect(new double[parameters(s).size()]));
    }

    /** A parameter for each number; at least 0 where the effect refuses less. */
    List<Parameter> parameters(Setting s) {
        List<Parameter> parameters = new ArrayList<>();
        for (RecordComponent component : components) {
            String name = ElementName.of(component.getName()).replace('-', '_');
            String unit = unit(component);
            double scale = s.scale(unit);
            if (component.getType() == Vec3.class) {
                parameters.addAll(Parameter.vector(name, unit, scale));
            } else {
                parameters.add(Parameter.signed(name, unit, scale));
            }
        }
        for (int i = 0; i < parameters.size(); i++) {
            double[] theta = new double[parameters.size()];
            theta[i] = -parameters.get(i).scale();
            if (!isValid(theta)) {
                parameters.set(i, parameters.get(i).atLeast(0));
            }
        }
        return parameters;
    }

    private static String unit(RecordComponent component) {
        Unit unit = component.getAnnotation(Unit.class);
        return unit == null ? "1" : unit.value();
    }

    /** The numbers that say how much of the effect there is. */
    int[] strengths() {
        List<String> units = new ArrayList<>();
        for (RecordComponent component : components) {
            for (int k = 0; k < size(component); k++) {
                units.add(unit(component));
            }
        }
        int[] all = IntStream.range(0, units.size()).toArray();
        int[] strengths = Arrays.stream(all).filter(i -> !SHAPES.contains(units.get(i))).toArray();
        return strengths.length == 0 ? all : strengths;
    }

    private static int size(RecordComponent component) {
        return component.getType() == Vec3.class ? 3 : 1;
    }

    private boolean isValid(double[] theta) {
        try {
            effect(theta);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    /**
     * The effect with these numbers.
     *
     * @throws IllegalArgumentException if it refuses them
     */
    Effect effect(double[] theta) {
        Object[] values = defaults.clone();
        int from = 0;
        for (int c = 0; c < components.size(); c++) {
            values[places.get(c)] =
                    size(components.get(c)) == 1
                            ? (Object) theta[from]
                            : new Vec3(theta[from], theta[from + 1], theta[from + 2]);
            from += size(components.get(c));
        }
        try {
            return (Effect) constructor.newInstance(values);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException refusal) {
                throw refusal;
            }
            throw new IllegalStateException(constructor.getDeclaringClass().getName(), e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(constructor.getDeclaringClass().getName(), e);
        }
    }
}
