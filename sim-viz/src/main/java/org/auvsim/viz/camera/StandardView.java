package org.auvsim.viz.camera;

/** Sides from which a scene is commonly looked at. */
public enum StandardView {
    /** From behind, the left and above. */
    OBLIQUE(-125, 25),
    /** From above, x to the right. */
    TOP(-90, 90),
    /** Along y, x to the right. */
    SIDE(-90, 0),
    /** Against x: at the bow of what points along x. */
    FRONT(0, 0);

    private final double azimuth;
    private final double elevation;

    StandardView(double azimuth, double elevation) {
        this.azimuth = Math.toRadians(azimuth);
        this.elevation = Math.toRadians(elevation);
    }

    /** Lets a camera look from this side. */
    public void apply(OrbitCamera camera) {
        camera.look(azimuth, elevation);
    }
}
