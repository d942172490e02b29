package org.auvsim.auvsml.mapping;

import java.util.Optional;

/** Where providers are looked for by whoever is not told where. */
public final class ContextClasses {
    private ContextClasses() {}

    /**
     * The class loader of the current thread's context, which the command line gives a user's
     * extensions and threads inherit; auvsim's own if the context has none.
     */
    public static ClassLoader loader() {
        return Optional.ofNullable(Thread.currentThread().getContextClassLoader())
                .orElseGet(ContextClasses.class::getClassLoader);
    }
}
