package org.auvsim.diagnosis.model;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.QRDecomposition;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Partings.Leg;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * What variants part by in which something swings, at any of many frequencies. Within a short leg a
 * swing is its mean, its change and its bend, and what it does to a body is linear in them: so what
 * a slow and a fast swing do along each axis tells what all others do.
 */
final class Swings {
    /** Times of samples (s) are rounded to this. */
    private static final double ROUNDING = 1e-4;

    /** Of what all are told by (rad/s): one that hardly bends within a leg, and one that does. */
    private static final List<Double> FREQUENCIES = List.of(1.0, 6.0);

    private static final List<Vec3> AXES =
            List.of(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1));

    /** A sine and a cosine of each frequency. */
    private static final int PER_AXIS = 2 * FREQUENCIES.size();

    private final MeasuredRun run;
    private final List<Leg> legs;
    private final Variant from;
    private final List<Variant> variants;

    /** By variant; empty where it has to be simulated. */
    private final List<Optional<Swing>> swings;

    /** By kind what the others are told by, axis by axis. */
    private final Map<Swing.Kind, List<Variant>> references = new EnumMap<>(Swing.Kind.class);

    /** Among variants of one, along the legs of a run. */
    Swings(MeasuredRun run, List<Leg> legs, Variant from, List<Variant> variants) {
        this.run = run;
        this.legs = legs;
        this.from = from;
        this.variants = variants;
        List<Optional<Swing>> all = variants.stream().map(v -> Swing.of(v, from)).toList();
        if (legs.stream().allMatch(leg -> duration(leg) < Partings.SHORT + ROUNDING)) {
            for (Swing.Kind kind : Swing.Kind.values()) {
                refer(
                        kind,
                        all.stream()
                                .flatMap(Optional::stream)
                                .filter(s -> s.kind() == kind)
                                .toList());
            }
        }
        swings = all.stream().map(s -> s.filter(of -> references.containsKey(of.kind()))).toList();
    }

    private double duration(Leg leg) {
        return run.time(leg.to()) - run.time(leg.from());
    }

    /** Has references of a kind, as large as the first, where that is less work. */
    private void refer(Swing.Kind kind, List<Swing> swings) {
        if (swings.size() <= PER_AXIS * AXES.size()) {
            return;
        }
        double size =
                legs.stream().mapToDouble(leg -> size(swings.getFirst(), leg)).max().orElse(0);
        if (size > 0) {
            List<Variant> ofKind = new ArrayList<>();
            for (Vec3 axis : AXES) {
                Vec3 vector = axis.times(size);
                for (double omega : FREQUENCIES) {
                    ofKind.add(Swing.in(from, kind, vector, Vec3.ZERO, omega));
                    ofKind.add(Swing.in(from, kind, Vec3.ZERO, vector, omega));
                }
            }
            references.put(kind, ofKind);
        }
    }

    private double size(Swing swing, Leg leg) {
        return swing.vector().at(leg.start().position(), run.time(leg.from())).norm();
    }

    /** Variants that do not swing, then what tells of those that do. */
    List<Variant> toSimulate() {
        List<Variant> simulated = new ArrayList<>();
        for (int i = 0; i < variants.size(); i++) {
            if (swings.get(i).isEmpty()) {
                simulated.add(variants.get(i));
            }
        }
        references.values().forEach(simulated::addAll);
        return simulated;
    }

    /** By variant and leg, from those of what was to be simulated. */
    double[][][] all(double[][][] simulated) {
        double[][][] all = new double[variants.size()][][];
        int next = 0;
        for (int i = 0; i < all.length; i++) {
            if (swings.get(i).isEmpty()) {
                all[i] = simulated[next++];
            }
        }
        for (Map.Entry<Swing.Kind, List<Variant>> of : references.entrySet()) {
            int end = next + of.getValue().size();
            fill(all, of.getKey(), of.getValue(), Arrays.asList(simulated).subList(next, end));
            next = end;
        }
        return all;
    }

    private void fill(
            double[][][] all, Swing.Kind kind, List<Variant> of, List<double[][]> partings) {
        List<Swing> told = of.stream().map(v -> Swing.of(v, from).orElseThrow()).toList();
        double[][][][] does =
                IntStream.range(0, legs.size())
                        .parallel()
                        .mapToObj(l -> does(told, partings, l))
                        .toArray(double[][][][]::new);
        IntStream.range(0, all.length)
                .parallel()
                .forEach(
                        i ->
                                swings.get(i)
                                        .filter(swing -> swing.kind() == kind)
                                        .ifPresent(swing -> all[i] = partings(swing, does)));
    }

    /** What a mean, a change and a bend of 1 along each axis do in a leg, by least squares. */
    private double[][][] does(List<Swing> told, List<double[][]> partings, int leg) {
        double[][][] does = new double[AXES.size()][][];
        for (int a = 0; a < does.length; a++) {
            double[][] swing = new double[PER_AXIS][];
            double[][] parting = new double[PER_AXIS][];
            for (int r = 0; r < PER_AXIS; r++) {
                int of = PER_AXIS * a + r;
                swing[r] = told.get(of).during(run, legs.get(leg)).along(AXES.get(a));
                parting[r] = partings.get(of)[leg];
            }
            does[a] =
                    new QRDecomposition(new Array2DRowRealMatrix(swing))
                            .getSolver()
                            .solve(new Array2DRowRealMatrix(parting))
                            .getData();
        }
        return does;
    }

    /** By leg. */
    private double[][] partings(Swing swing, double[][][][] does) {
        double[][] partings = new double[legs.size()][RigidMotion.SIZE];
        for (int l = 0; l < partings.length; l++) {
            Swing.Part part = swing.during(run, legs.get(l));
            for (int a = 0; a < AXES.size(); a++) {
                double[] along = part.along(AXES.get(a));
                for (int k = 0; k < along.length; k++) {
                    double[] by = does[l][a][k];
                    for (int i = 0; i < by.length; i++) {
                        partings[l][i] += along[k] * by[i];
                    }
                }
            }
        }
        return partings;
    }
}
