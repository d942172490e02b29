package org.auvsim.viz.window;

import java.util.OptionalLong;

/** What a window lets people choose about the picture, from any thread. */
public interface ViewOptions {
    /** Whether this is shown. */
    boolean shows(Shown what);

    /** Shows this, or hides it. */
    void show(Shown what, boolean on);

    /** Whether colours are light on dark. */
    boolean isDark();

    /** Makes colours light on dark, or dark on light. */
    void dark(boolean on);

    /** The id of the object that is looked at more closely. */
    OptionalLong selected();

    /** Looks at an object more closely, or at none. */
    void select(OptionalLong id);

    /** The id of the object that the camera goes along with. */
    OptionalLong followed();

    /** Lets the camera go along with an object, or with none. */
    void follow(OptionalLong id);
}
