package org.auvsim.auvsml.mapping;

import org.auvsim.auvsml.message.feedback.Covariance;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Random;
import java.util.function.Supplier;

/**
 * Makes records of any type that AUVSML can write, with random values in all components; values
 * that a record's constructor refuses are drawn again.
 */
final class RandomRecords {
    private static final int DRAWS = 20_000;

    private static final double[] NUMBERS = {
        0, -0.0, 1, -1, 0.5, 2, 3, 0.1, 1e-300, Double.MIN_VALUE, Double.MAX_VALUE, -1e23, Math.PI
    };
    private static final String[] TEXTS = {
        "Gravity",
        "Aft Thruster",
        "Yv|v|",
        "Nuv",
        "*",
        "*ALL*",
        "47",
        "max",
        "2.5",
        "",
        " leading and trailing ",
        "<&>\"'",
        "tab\tline\nreturn\r",
        "Tr\u00fcmmer \u20ac \uD83D\uDEA2",
        "]]>",
        "DirectPositionChangeFeedbackHandler"
    };

    private final AuvsmlMapper mapper;
    private final Random random;

    RandomRecords(AuvsmlMapper mapper, Random random) {
        this.mapper = mapper;
        this.random = random;
    }

    Record record(Class<?> type) {
        for (int i = 0; i < DRAWS; i++) {
            Optional<Record> drawn = draw(type);
            if (drawn.isPresent()) {
                return drawn.get();
            }
        }
        throw new AssertionError(
                "no random values fit " + type + ": give it an example of its own");
    }

    private Optional<Record> draw(Class<?> type) {
        RecordComponent[] components = type.getRecordComponents();
        Object[] values = new Object[components.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = value(components[i].getGenericType());
        }
        try {
            var constructor =
                    type.getDeclaredConstructor(
                            Arrays.stream(components)
                                    .map(RecordComponent::getType)
                                    .toArray(Class<?>[]::new));
            constructor.setAccessible(true);
            return Optional.of((Record) constructor.newInstance(values));
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException) {
                return Optional.empty();
            }
            throw new AssertionError("constructor of " + type, e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new LinkageError("constructor of " + type, e);
        }
    }

    private Object value(Type type) {
        if (type instanceof ParameterizedType generic) {
            return generic.getRawType() == List.class
                    ? list(generic.getActualTypeArguments()[0])
                    : generic.getRawType() == Optional.class
                            ? optional(() -> value(generic.getActualTypeArguments()[0]))
                            : value(generic.getRawType());
        }
        Class<?> raw = (Class<?>) type;
        if (raw == Quat.class && random.nextBoolean()) {
            return turn();
        }
        if (raw == Covariance.class) {
            return covariance(3 * random.nextInt(1, 5));
        }
        if (raw.isRecord()) {
            return record(raw);
        }
        return raw.isInterface() ? implementation(raw) : scalar(raw);
    }

    /** An orientation, as some records want no other quaternion. */
    private Quat turn() {
        Vec3 axis = new Vec3(random.nextGaussian(), random.nextGaussian(), 1);
        return Quat.ofAxisAngle(axis, random.nextGaussian());
    }

    /** B B^T for a random B, which is symmetric and positive definite. */
    private Covariance covariance(int size) {
        double[] factor = random.doubles((long) size * size, 0.1, 1).toArray();
        double[] product = new double[size * size];
        for (int i = 0; i < size; i++) {
            factor[(size + 1) * i] += size;
            for (int j = 0; j <= i; j++) {
                for (int k = 0; k < size; k++) {
                    product[size * i + j] += factor[size * i + k] * factor[size * j + k];
                }
                product[size * j + i] = product[size * i + j];
            }
        }
        return Covariance.of(product, size);
    }

    private List<Object> list(Type element) {
        List<Object> list = new ArrayList<>();
        for (int i = random.nextInt(4); i > 0; i--) {
            list.add(value(element));
        }
        return list;
    }

    private Optional<Object> optional(Supplier<Object> value) {
        return random.nextBoolean() ? Optional.of(value.get()) : Optional.empty();
    }

    private Record implementation(Class<?> type) {
        List<Class<?>> types = List.copyOf(mapper.implementations(type).values());
        return record(types.get(random.nextInt(types.size())));
    }

    private Object scalar(Class<?> type) {
        if (type == OptionalDouble.class) {
            return random.nextBoolean() ? OptionalDouble.of(number()) : OptionalDouble.empty();
        }
        if (type == OptionalLong.class) {
            return random.nextBoolean() ? OptionalLong.of(whole()) : OptionalLong.empty();
        }
        if (type == OptionalInt.class) {
            return random.nextBoolean() ? OptionalInt.of((int) whole()) : OptionalInt.empty();
        }
        if (type.isEnum()) {
            return type.getEnumConstants()[random.nextInt(type.getEnumConstants().length)];
        }
        if (type == double.class || type == Double.class) {
            return number();
        }
        if (type == long.class || type == Long.class) {
            return whole();
        }
        if (type == int.class || type == Integer.class) {
            return (int) whole();
        }
        if (type == boolean.class || type == Boolean.class) {
            return random.nextBoolean();
        }
        if (type == Numbers.class) {
            return Numbers.of(random.doubles(random.nextInt(1, 4)).toArray());
        }
        if (type == String.class) {
            return TEXTS[random.nextInt(TEXTS.length)];
        }
        throw new AssertionError("no random values for " + type);
    }

    private double number() {
        return switch (random.nextInt(3)) {
            case 0 -> NUMBERS[random.nextInt(NUMBERS.length)];
            case 1 -> random.nextDouble();
            default -> random.nextGaussian() * 1000;
        };
    }

    private long whole() {
        return switch (random.nextInt(3)) {
            case 0 -> random.nextInt(10);
            case 1 -> random.nextInt(1, 1000);
            default -> random.nextLong();
        };
    }
}
