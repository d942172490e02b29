package org.auvsim.viz.scene;

/** So many of something, in words. */
public final class Counted {
    private Counted() {}

    /** As {@code 1 client}, {@code 2 clients}. */
    public static String of(long count, String what) {
        return count + " " + what + (count == 1 ? "" : "s");
    }
}
