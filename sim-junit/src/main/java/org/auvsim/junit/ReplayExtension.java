package org.auvsim.junit;

import org.junit.jupiter.api.MediaType;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolutionException;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.platform.commons.support.AnnotationSupport;

import java.io.IOException;
import java.lang.reflect.AnnotatedElement;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;

/** Gives tests the replays that {@link ReplayScenario} asks for. */
final class ReplayExtension implements ParameterResolver {
    private static final ExtensionContext.Namespace NAMESPACE =
            ExtensionContext.Namespace.create(ReplayExtension.class);

    @Override
    public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
        return parameter.getParameter().getType() == Replay.class;
    }

    @Override
    public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
        return new Replay(observed(context), (name, png) -> publish(context, name, png));
    }

    /** What was run for the method or class that has the annotation; once for all below it. */
    private static Observed observed(ExtensionContext context) {
        ExtensionContext owner = owner(context);
        ReplayScenario wanted = annotation(owner).orElseThrow();
        return owner.getStore(NAMESPACE)
                .getOrComputeIfAbsent(
                        wanted, _ -> replay(wanted, owner.getRequiredTestClass()), Observed.class);
    }

    private static Observed replay(ReplayScenario wanted, Class<?> test) {
        try {
            return ReplayedFile.of(wanted.value(), test).replay(wanted.until());
        } catch (ReplayException e) {
            throw new ParameterResolutionException(e.getMessage(), e);
        }
    }

    /** The nearest context with the annotation; of those for one method or class the outermost. */
    private static ExtensionContext owner(ExtensionContext context) {
        ExtensionContext owner = context;
        while (annotation(owner).isEmpty()) {
            owner = parent(owner);
        }
        Optional<AnnotatedElement> element = owner.getElement();
        while (parent(owner).getElement().equals(element)) {
            owner = parent(owner);
        }
        return owner;
    }

    private static ExtensionContext parent(ExtensionContext context) {
        return context.getParent().orElseThrow();
    }

    private static Optional<ReplayScenario> annotation(ExtensionContext context) {
        return AnnotationSupport.findAnnotation(context.getElement(), ReplayScenario.class);
    }

    private static Path publish(ExtensionContext context, String name, byte[] png)
            throws IOException {
        AtomicReference<Optional<Path>> file = new AtomicReference<>(Optional.empty());
        context.publishFile(
                name,
                MediaType.IMAGE_PNG,
                path -> {
                    Files.write(path, png);
                    file.set(Optional.of(path));
                });
        return file.get().orElseThrow(() -> new IOException("JUnit takes no files"));
    }
}
