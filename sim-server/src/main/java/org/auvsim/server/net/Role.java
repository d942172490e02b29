package org.auvsim.server.net;

import java.util.Locale;

/** What a client may do. */
public enum Role {
    /** Everything: that is every client as long as clients do not prove who they are. */
    ADMIN;

    /** Its name in AUVSML. */
    public String roleName() {
        return name().toLowerCase(Locale.ROOT);
    }
}
