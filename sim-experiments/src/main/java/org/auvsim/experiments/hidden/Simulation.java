package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.ode.ContinuousOutputModel;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.auvsim.experiments.hidden.Companion.Kick;
import org.auvsim.experiments.hidden.Manoeuvre.TimedPush;
import org.auvsim.experiments.hidden.Manoeuvre.Track;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SortedSet;
import java.util.SplittableRandom;
import java.util.TreeSet;

/**
 * A reality through a manoeuvre: Dormand-Prince 8(5,3) at a relative tolerance of 1e-9, begun anew
 * wherever something sets in or ends.
 */
final class Simulation {
    private static final double TOLERANCE = 1e-9;
    private static final double SHORTEST = 1e-10;

    /** How often companions are told where the body is (s). */
    private static final double REMEMBERED = 0.25;

    private final Reality reality;
    private final Manoeuvre manoeuvre;
    private final List<Companion> companions;
    private final List<Kick> kicks;
    private final Equations equations;
    private final double[] y;
    private final List<ContinuousOutputModel> pieces = new ArrayList<>();

    private Simulation(Reality reality, Manoeuvre manoeuvre, SplittableRandom random) {
        this.reality = reality;
        this.manoeuvre = manoeuvre;
        this.companions = reality.companions().stream().map(c -> c.apply(random.split())).toList();
        this.kicks =
                companions.stream()
                        .flatMap(c -> c.kicks().stream())
                        .filter(k -> k.at() < manoeuvre.duration())
                        .sorted(Comparator.comparingDouble(Kick::at))
                        .toList();
        List<double[]> starts = companions.stream().map(c -> c.start(manoeuvre.start())).toList();
        this.equations =
                new Equations(
                        reality, companions, starts.stream().mapToInt(s -> s.length).toArray());
        this.y = new double[equations.getDimension()];
        manoeuvre.start().putInto(y);
        int at = Instant.SIZE + reality.plant().thrusters().size();
        for (double[] start : starts) {
            System.arraycopy(start, 0, y, at, start.length);
            at += start.length;
        }
    }

    /**
     * What sensors without noise would tell at each sample.
     *
     * @param random of what differs from run to run
     * @throws org.apache.commons.math3.exception.MathIllegalStateException if it cannot be followed
     */
    static List<Pose> poses(Reality reality, Manoeuvre manoeuvre, SplittableRandom random) {
        return new Simulation(reality, manoeuvre, random).poses();
    }

    private List<Pose> poses() {
        double delay = reality.sensors().delay();
        hold(0);
        if (delay > 0) {
            follow(0, -delay, y.clone());
        }
        double last = 0;
        for (double edge : edges()) {
            hold(last);
            follow(last, edge, y);
            kick(edge);
            last = edge;
        }
        List<Pose> poses = new ArrayList<>();
        for (int k = 0; k < manoeuvre.samples(); k++) {
            double time = manoeuvre.time(k);
            poses.add(reality.sensors().told(at(time - delay), time));
        }
        return poses;
    }

    private SortedSet<Double> edges() {
        double end = manoeuvre.duration() + Math.max(0, -reality.sensors().delay());
        SortedSet<Double> edges = new TreeSet<>(reality.edges());
        for (Track track : manoeuvre.commands()) {
            track.samples().forEach(k -> edges.add(manoeuvre.time(k)));
        }
        for (TimedPush push : manoeuvre.pushes()) {
            edges.add(push.from());
            edges.add(push.until());
        }
        kicks.forEach(kick -> edges.add(kick.at()));
        for (int i = 1; !companions.isEmpty() && i * REMEMBERED < end; i++) {
            edges.add(i * REMEMBERED);
        }
        edges.removeIf(edge -> edge <= 0 || edge >= end);
        edges.add(end);
        return edges;
    }

    /** What is commanded and pushed from a time (s) on. */
    private void hold(double time) {
        int sample = (int) Math.floor(time * manoeuvre.rate() + 1e-6);
        equations.hold(
                time,
                levels(reality.plant().thrusters().stream().map(Thruster::name).toList(), sample),
                levels(reality.plant().foils().stream().map(Foil::name).toList(), sample),
                manoeuvre.pushes().stream()
                        .filter(push -> push.from() <= time && time < push.until())
                        .toList());
    }

    private double[] levels(List<String> names, int sample) {
        double[] levels = new double[names.size()];
        for (Track track : manoeuvre.commands()) {
            int i = names.indexOf(track.name());
            if (i >= 0) {
                levels[i] = track.level(sample);
            }
        }
        return levels;
    }

    private void follow(double from, double to, double[] state) {
        if (Math.abs(to - from) < SHORTEST) {
            return;
        }
        DormandPrince853Integrator integrator =
                new DormandPrince853Integrator(SHORTEST, Math.abs(to - from), TOLERANCE, TOLERANCE);
        ContinuousOutputModel piece = new ContinuousOutputModel();
        integrator.addStepHandler(piece);
        integrator.integrate(equations, from, state, to, state);
        pieces.add(piece);
    }

    private void kick(double time) {
        Instant now = Instant.of(time, y, reality.water());
        companions.forEach(companion -> companion.remember(now));
        for (Kick kick : kicks) {
            if (kick.at() == time) {
                Vector3D j = now.attitude().toBody(kick.impulse());
                Plant plant = reality.plant();
                Vector3D jump =
                        new Vector3D(
                                j.getX() / (plant.mass() + plant.addedMass().getX()),
                                j.getY() / (plant.mass() + plant.addedMass().getY()),
                                j.getZ() / (plant.mass() + plant.addedMass().getZ()));
                Vector3D before = Instant.of(time, y, reality.water()).velocity();
                Instant.put(before.add(now.attitude().toWorld(jump)), y, 7);
            }
        }
    }

    private Instant at(double time) {
        ContinuousOutputModel piece = pieces.getFirst();
        for (ContinuousOutputModel candidate : pieces.subList(1, pieces.size())) {
            double earliest = Math.min(candidate.getInitialTime(), candidate.getFinalTime());
            if (earliest <= time + 1e-12) {
                piece = candidate;
            }
        }
        piece.setInterpolatedTime(time);
        return Instant.of(time, piece.getInterpolatedState(), reality.water());
    }
}
