package org.auvsim.auvsml;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What a client may do; each role may do what those before it may. */
public enum Role {
    /** To listen and to ask. */
    VIEWER,
    /** To control world objects and to send feedback for them. */
    CONTROLLER,
    /** To change what is in the world and how its time goes on. */
    ADMIN;

    /** Its name in AUVSML. */
    public String roleName() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Whether a client of this role may do what takes {@code needed}. */
    public boolean allows(Role needed) {
        return compareTo(needed) >= 0;
    }

    /** The role of this name in AUVSML. */
    public static Optional<Role> named(String roleName) {
        return Arrays.stream(values()).filter(r -> r.roleName().equals(roleName)).findFirst();
    }

    /** The names of all roles. */
    public static List<String> names() {
        return Arrays.stream(values()).map(Role::roleName).toList();
    }
}
