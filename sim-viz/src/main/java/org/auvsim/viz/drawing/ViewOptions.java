package org.auvsim.viz.drawing;

import java.util.EnumSet;
import java.util.OptionalLong;
import java.util.Set;

/** What is shown of a scene and how; windows change it, drawings read it, each on its thread. */
public final class ViewOptions {
    /** No object has this id. */
    private static final long NOBODY = -1;

    private final Set<Layer> layers = EnumSet.allOf(Layer.class);
    private long selected = NOBODY;
    private long followed = NOBODY;
    private boolean dark = true;

    /** Everything is shown, nothing selected, dark. */
    public ViewOptions() {}

    /** Whether a layer is shown. */
    public synchronized boolean shows(Layer layer) {
        return layers.contains(layer);
    }

    /** Shows a layer, or leaves it out. */
    public synchronized void show(Layer layer, boolean on) {
        if (on) {
            layers.add(layer);
        } else {
            layers.remove(layer);
        }
    }

    /** The object that was chosen. */
    public synchronized OptionalLong selected() {
        return selected == NOBODY ? OptionalLong.empty() : OptionalLong.of(selected);
    }

    /** Chooses an object, or none. */
    public synchronized void select(OptionalLong id) {
        selected = id.orElse(NOBODY);
    }

    /** Whether an object is chosen. */
    synchronized boolean isSelected(long id) {
        return selected == id;
    }

    /** The object that the camera goes with. */
    public synchronized OptionalLong followed() {
        return followed == NOBODY ? OptionalLong.empty() : OptionalLong.of(followed);
    }

    /** Lets the camera go with an object, or stay. */
    public synchronized void follow(OptionalLong id) {
        followed = id.orElse(NOBODY);
    }

    /** Whether the camera goes with an object. */
    synchronized boolean isFollowed(long id) {
        return followed == id;
    }

    /** Whether light stands before dark. */
    public synchronized boolean isDark() {
        return dark;
    }

    /** Light before dark, or dark before light. */
    public synchronized void dark(boolean on) {
        dark = on;
    }
}
