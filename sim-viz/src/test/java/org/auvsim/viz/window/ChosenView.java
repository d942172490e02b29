package org.auvsim.viz.window;

import java.util.EnumSet;
import java.util.OptionalLong;
import java.util.Set;

/** What somebody has chosen, as the window alone needs it. */
final class ChosenView implements ViewOptions {
    private final Set<Shown> shown = EnumSet.of(Shown.TRAILS, Shown.GRID, Shown.LABELS);
    private boolean isDark = true;
    private OptionalLong selected = OptionalLong.empty();
    private OptionalLong followed = OptionalLong.empty();

    @Override
    public synchronized boolean shows(Shown what) {
        return shown.contains(what);
    }

    @Override
    public synchronized void show(Shown what, boolean on) {
        if (on) {
            shown.add(what);
        } else {
            shown.remove(what);
        }
    }

    @Override
    public synchronized boolean isDark() {
        return isDark;
    }

    @Override
    public synchronized void dark(boolean on) {
        isDark = on;
    }

    @Override
    public synchronized OptionalLong selected() {
        return selected;
    }

    @Override
    public synchronized void select(OptionalLong id) {
        selected = id;
    }

    @Override
    public synchronized OptionalLong followed() {
        return followed;
    }

    @Override
    public synchronized void follow(OptionalLong id) {
        followed = id;
    }
}
