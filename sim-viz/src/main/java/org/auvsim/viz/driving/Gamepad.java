package org.auvsim.viz.driving;

import java.util.Optional;

/** A gamepad, or a place where one may be plugged in. */
@FunctionalInterface
public interface Gamepad {
    /** How its sticks stand now; empty if none is connected. */
    Optional<Sticks> poll();
}
