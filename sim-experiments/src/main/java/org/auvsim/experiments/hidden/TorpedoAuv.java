package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.experiments.hidden.Manoeuvre.Track;

import java.util.ArrayList;
import java.util.List;

/** A slender vehicle with a propeller, a rudder and a stern plane: zigzags and changes of depth. */
final class TorpedoAuv implements Body {
    /** Where it begins (m), deep enough to go up. */
    private static final double DEPTH = -40;

    private static final String PROPELLER = "propeller";
    private static final String RUDDER = "rudder";
    private static final String STERN_PLANE = "stern plane";

    @Override
    public String name() {
        return "torpedo AUV";
    }

    @Override
    public Plant plant(Draws draws) {
        Vector3D stern = new Vector3D(-0.7, 0, 0);
        return new Plant(
                new Vector3D(1.4, 0.19, 0.19),
                30.5,
                new Vector3D(0.17, 3.44, 3.45),
                new Vector3D(1, 30, 30),
                new Vector3D(0.07, 4.9, 4.9),
                Plant.GRAVITY,
                30.5,
                new Vector3D(0, 0, 0.02),
                Drag.byAxes(
                        new Vector3D(1.5, 20, 20),
                        new Vector3D(2, 100, 100),
                        new Vector3D(0.4, 6, 6),
                        new Vector3D(0.2, 25, 25)),
                List.of(Thruster.sound(PROPELLER, stern, Vector3D.PLUS_I, 25)),
                List.of(
                        new Foil(RUDDER, stern, Vector3D.PLUS_K, 0.06, 3),
                        new Foil(STERN_PLANE, stern, Vector3D.PLUS_J, 0.06, 3)));
    }

    @Override
    public double timeStep() {
        return 0.02;
    }

    @Override
    public boolean showsOrientation(Draws draws) {
        return true;
    }

    @Override
    public Manoeuvre manoeuvre(Draws draws) {
        double duration = Math.round(draws.between(30, 45));
        int rate = draws.oneOf(List.of(10, 20, 25));
        Instant rest = Pushing.start(draws);
        Vector3D ahead = rest.attitude().toWorld(new Vector3D(draws.between(0.5, 1.5), 0, 0));
        Instant start =
                new Instant(
                        0,
                        new Vector3D(0, 0, DEPTH),
                        rest.attitude(),
                        ahead,
                        rest.turning(),
                        rest.water());
        return new Manoeuvre(
                start,
                duration,
                rate,
                List.of(
                        track(PROPELLER, duration, rate, 5, 0.2, 1, draws),
                        track(RUDDER, duration, rate, 3, -0.25, 0.25, draws),
                        track(STERN_PLANE, duration, rate, 3, -0.08, 0.08, draws)),
                List.of());
    }

    private static Track track(
            String name,
            double duration,
            int rate,
            double pause,
            double low,
            double high,
            Draws draws) {
        List<Integer> samples = Steps.draw(duration, rate, pause, 2 * pause, draws);
        List<Double> levels = new ArrayList<>(List.of(0.0));
        while (levels.size() < samples.size()) {
            levels.add(draws.between(low, high));
        }
        return new Track(name, samples, levels);
    }
}
