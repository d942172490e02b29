package org.auvsim.cli.extension;

import static java.util.Objects.requireNonNull;
import static java.util.stream.Collectors.toSet;

import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.cli.extension.ExtensionJar.Named;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.description.ElementName;
import org.auvsim.diagnosis.cause.CauseFamily;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.viz.drawing.Renderer;

import java.lang.reflect.Modifier;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.Set;

/** Whether all that extensions name is there, fits, and has a name of its own. */
final class ProviderCheck {
    /** Those that are made without a word of a scenario; all others are records that it states. */
    private static final Set<Class<?>> MADE =
            Set.of(FeedbackProcessor.class, CauseFamily.class, Renderer.class);

    private final ClassLoader loader;
    private final ClassLoader ownLoader;
    private final AuvsmlMapper own;

    /** By interface and name: who has it. */
    private final Map<String, Place> taken = new HashMap<>();

    private record Place(Path jar, Class<?> provider) {}

    /** Looks up classes in {@code loader}; those of auvsim itself are in {@code own}. */
    ProviderCheck(ClassLoader loader, ClassLoader own) {
        this.loader = loader;
        this.ownLoader = own;
        this.own = AuvsmlMapper.load(own);
    }

    /**
     * Checks all providers.
     *
     * @throws UserError for the first that cannot be used
     */
    void check(List<ExtensionJar> jars) {
        for (ExtensionJar jar : jars) {
            for (Named named : jar.providers()) {
                check(jar.file(), named);
            }
        }
    }

    private void check(Path jar, Named named) {
        Class<?> type = type(jar, named);
        Class<?> provider = provider(jar, named);
        if (!type.isAssignableFrom(provider)) {
            throw unusable(jar, named, "does not implement it: implement it, or take the line out");
        }
        if (!MADE.contains(type)) {
            if (!provider.isRecord()) {
                throw unusable(jar, named, "is no record: make it one");
            }
            String name = ElementName.of(provider);
            requireFree(name, new Place(jar, provider), type);
            requireOwnName(name, new Place(jar, provider), type);
            return;
        }
        requireMakeable(jar, named, provider);
        String name = nameOf(made(jar, named, provider));
        requireFree(name, new Place(jar, provider), type);
        if (namesOfOwn(type).contains(name)) {
            throw takenByOwn(name, new Place(jar, provider), type);
        }
    }

    private Class<?> type(Path jar, Named named) {
        try {
            return Class.forName(named.type(), false, ownLoader);
        } catch (ClassNotFoundException e) {
            throw new UserError(
                    "%s has a provider file for %s, which auvsim does not have: correct the file's name, or build the extension for this version."
                            .formatted(jar, named.type()),
                    e);
        }
    }

    private Class<?> provider(Path jar, Named named) {
        try {
            Class<?> provider = Class.forName(named.provider(), false, loader);
            // Looks up all that is in its signatures, too.
            requireNonNull(provider.getDeclaredConstructors());
            requireNonNull(provider.getDeclaredMethods());
            return provider;
        } catch (ClassNotFoundException e) {
            throw unusable(jar, named, "is in no jar: correct the line, or build the jar again", e);
        } catch (UnsupportedClassVersionError e) {
            throw unusable(
                    jar,
                    named,
                    "was compiled for a newer Java than %s, which runs: compile it with --release %s"
                            .formatted(Runtime.version().feature(), Runtime.version().feature()),
                    e);
        } catch (NoClassDefFoundError e) {
            throw unusable(
                    jar,
                    named,
                    "needs a class that is in no jar (%s): put the jar that has it beside it"
                            .formatted(e.getMessage()),
                    e);
        } catch (LinkageError e) {
            throw unusable(
                    jar, named, "cannot be loaded (%s): build the jar again".formatted(e), e);
        }
    }

    private static void requireMakeable(Path jar, Named named, Class<?> provider) {
        boolean isMakeable =
                Modifier.isPublic(provider.getModifiers())
                        && !Modifier.isAbstract(provider.getModifiers())
                        && Arrays.stream(provider.getConstructors())
                                .anyMatch(constructor -> constructor.getParameterCount() == 0);
        if (!isMakeable) {
            throw unusable(
                    jar,
                    named,
                    "is no public class with a public constructor without parameters: make it one");
        }
    }

    private static Object made(Path jar, Named named, Class<?> provider) {
        try {
            return provider.getConstructor().newInstance();
        } catch (ReflectiveOperationException | LinkageError e) {
            throw unusable(jar, named, "cannot be made (%s): mend its constructor".formatted(e), e);
        }
    }

    /** The name by which somebody chooses it. */
    private static String nameOf(Object made) {
        return switch (made) {
            case Renderer renderer -> renderer.name();
            case FeedbackProcessor processor -> processor.name();
            default -> made.getClass().getSimpleName();
        };
    }

    private Set<String> namesOfOwn(Class<?> type) {
        return ServiceLoader.load(type, ownLoader).stream()
                .map(own -> nameOf(own.get()))
                .collect(toSet());
    }

    private void requireFree(String name, Place place, Class<?> type) {
        Place other = taken.getOrDefault(type.getName() + " " + name, place);
        if (!other.equals(place)) {
            throw new UserError(
                    "%s and %s both provide the %s '%s': take one of them out of the folder, or rename one."
                            .formatted(other.jar(), place.jar(), type.getSimpleName(), name));
        }
        taken.put(type.getName() + " " + name, place);
    }

    private void requireOwnName(String name, Place place, Class<?> type) {
        Class<?> provider = place.provider();
        if (own.implementations(type).getOrDefault(name, provider) != provider) {
            throw takenByOwn(name, place, type);
        }
    }

    private static UserError takenByOwn(String name, Place place, Class<?> type) {
        return new UserError(
                "%s provides the %s '%s', as auvsim itself does: rename %s."
                        .formatted(
                                place.jar(),
                                type.getSimpleName(),
                                name,
                                place.provider().getName()));
    }

    private static UserError unusable(Path jar, Named named, String what) {
        return new UserError(sentence(jar, named, what));
    }

    private static UserError unusable(Path jar, Named named, String what, Throwable cause) {
        return new UserError(sentence(jar, named, what), cause);
    }

    private static String sentence(Path jar, Named named, String what) {
        return "%s names %s for %s, but it %s."
                .formatted(jar, named.provider(), named.type(), what);
    }
}
