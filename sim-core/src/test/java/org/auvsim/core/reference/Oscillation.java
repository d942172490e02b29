package org.auvsim.core.reference;

/** The exact motion of a ball on a linear spring to a point, with angular frequency w (rad/s). */
final class Oscillation implements Flight {
    private final double[] centre;
    private final double[] place;
    private final double[] speed;
    private final double w;
    private final Placement now = new Placement();

    Oscillation(double[] centre, double[] place, double[] speed, double w) {
        this.centre = centre;
        this.place = place;
        this.speed = speed;
        this.w = w;
    }

    @Override
    public Placement at(double t) {
        for (int i = 0; i < 3; i++) {
            now.at[i] =
                    centre[i]
                            + (place[i] - centre[i]) * StrictMath.cos(w * t)
                            + speed[i] / w * StrictMath.sin(w * t);
        }
        return now;
    }

    @Override
    public double velocity(int axis, double t) {
        return speed[axis] * StrictMath.cos(w * t)
                - w * (place[axis] - centre[axis]) * StrictMath.sin(w * t);
    }

    @Override
    public double speedBound(double from, double to) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double swing = w * (place[i] - centre[i]);
            sum += speed[i] * speed[i] + swing * swing;
        }
        return Math.sqrt(sum);
    }

    @Override
    public double spinBound() {
        return 0;
    }
}
