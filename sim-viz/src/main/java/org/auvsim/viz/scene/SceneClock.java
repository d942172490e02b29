package org.auvsim.viz.scene;

/** Which time of the world is to be shown. Belongs to a scene, whose lock it lives under. */
public interface SceneClock {
    /** A step is done, now, that ends at {@code time} (s). */
    void stepDone(double time, long nanos);

    /** Time has jumped to {@code time} (s). */
    void jump(double time);

    /** The time (s) to show at an instant of the machine's clock (ns). */
    double at(long nanos);
}
