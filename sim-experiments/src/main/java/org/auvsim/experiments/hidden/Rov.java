package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.experiments.hidden.Manoeuvre.Track;

import java.util.ArrayList;
import java.util.List;

/** A vehicle with four thrusters aslant in the plane and four upright ones, told step by step. */
final class Rov implements Body {
    private static final double THRUST = 40;
    private static final List<String> NAMES =
            List.of("bow port", "bow starboard", "stern port", "stern starboard");

    /** Where each of the four is: ahead and to port. */
    private static final double[][] CORNERS = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};

    @Override
    public String name() {
        return "ROV";
    }

    @Override
    public Plant plant(Draws draws) {
        return new Plant(
                new Vector3D(0.46, 0.58, 0.25),
                13.5,
                new Vector3D(0.26, 0.23, 0.37),
                new Vector3D(6.36, 7.12, 18.68),
                new Vector3D(0.189, 0.135, 0.222),
                Plant.GRAVITY,
                13.6,
                new Vector3D(0, 0, 0.02),
                Drag.byAxes(
                        new Vector3D(13.7, 10, 33),
                        new Vector3D(141, 217, 190),
                        new Vector3D(0.3, 0.8, 0.5),
                        new Vector3D(1.2, 0.5, 1.5)),
                thrusters(),
                List.of());
    }

    private static List<Thruster> thrusters() {
        List<Thruster> thrusters = new ArrayList<>();
        for (int i = 0; i < NAMES.size(); i++) {
            double ahead = CORNERS[i][0];
            double port = CORNERS[i][1];
            thrusters.add(
                    Thruster.sound(
                            NAMES.get(i),
                            new Vector3D(0.156 * ahead, 0.111 * port, 0),
                            new Vector3D(1, -ahead * port, 0),
                            THRUST));
        }
        for (int i = 0; i < NAMES.size(); i++) {
            thrusters.add(
                    Thruster.sound(
                            NAMES.get(i) + " upright",
                            new Vector3D(0.12 * CORNERS[i][0], 0.218 * CORNERS[i][1], 0),
                            Vector3D.PLUS_K,
                            THRUST));
        }
        return thrusters;
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
        double duration = Math.round(draws.between(25, 40));
        int rate = draws.oneOf(List.of(10, 20, 25));
        return new Manoeuvre(
                Pushing.start(draws), duration, rate, tracks(duration, rate, draws), List.of());
    }

    /** Surge, sway, heave and yaw in steps, shared out, and a little by each thruster alone. */
    private static List<Track> tracks(double duration, int rate, Draws draws) {
        List<Integer> samples = Steps.draw(duration, rate, 2, 5, draws);
        List<List<Double>> levels = new ArrayList<>();
        for (int i = 0; i < 2 * NAMES.size(); i++) {
            levels.add(new ArrayList<>(List.of(0.0)));
        }
        for (int s = 1; s < samples.size(); s++) {
            Vector3D way = draws.box(-0.35, 0.35);
            double yaw = draws.between(-0.1, 0.1);
            for (int i = 0; i < NAMES.size(); i++) {
                double ahead = CORNERS[i][0];
                double port = CORNERS[i][1];
                levels.get(i)
                        .add(
                                way.getX()
                                        - ahead * port * way.getY()
                                        - port * yaw
                                        + draws.between(-0.08, 0.08));
                levels.get(NAMES.size() + i).add(0.6 * way.getZ() + draws.between(-0.04, 0.04));
            }
        }
        List<Track> tracks = new ArrayList<>();
        List<Thruster> thrusters = thrusters();
        for (int i = 0; i < thrusters.size(); i++) {
            tracks.add(new Track(thrusters.get(i).name(), samples, levels.get(i)));
        }
        return tracks;
    }
}
