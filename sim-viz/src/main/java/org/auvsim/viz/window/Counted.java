package org.auvsim.viz.window;

/** So many of something, in words. */
final class Counted {
    private Counted() {}

    /** As {@code 1 client}, {@code 2 clients}. */
    static String of(int count, String what) {
        return count + " " + what + (count == 1 ? "" : "s");
    }
}
