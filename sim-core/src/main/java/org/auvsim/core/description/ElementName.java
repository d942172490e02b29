package org.auvsim.core.description;

import java.util.Locale;

/** How names of Java look to users: as the elements and attributes of a scenario. */
public final class ElementName {
    private ElementName() {}

    /** Of a record: {@code HalfSpace} to {@code half-space}. */
    public static String of(Class<?> record) {
        return of(record.getSimpleName());
    }

    /**
     * {@code isProjectedState} to {@code is-projected-state}; {@code GPSFix} to {@code gps-fix}.
     */
    public static String of(String camel) {
        return camel.replaceAll("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "-")
                .toLowerCase(Locale.ROOT);
    }
}
