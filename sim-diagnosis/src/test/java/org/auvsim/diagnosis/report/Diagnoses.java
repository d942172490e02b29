package org.auvsim.diagnosis.report;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Approximation;
import org.auvsim.diagnosis.result.Axis;
import org.auvsim.diagnosis.result.Conclusion;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Discrepancy;
import org.auvsim.diagnosis.result.Evidence;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.result.Identifiability;
import org.auvsim.diagnosis.result.Identifiability.Confusion;
import org.auvsim.diagnosis.result.Identifiability.Smallest;
import org.auvsim.diagnosis.result.NextExperiment;
import org.auvsim.diagnosis.result.Prediction;
import org.auvsim.diagnosis.result.Proposal;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.result.Sentence;
import org.auvsim.diagnosis.result.Sentences;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;

/**
 * Diagnoses made by hand: a sledge that turns and sinks, slowed by quadratic drag or by nothing.
 */
final class Diagnoses {
    static final double NOISE = 0.01;
    static final double TURN_NOISE = 0.004;
    private static final double DRAG = 0.05;
    private static final double SPEED = 2;
    private static final double DURATION = 60;

    static final Finding QUADRATIC_DRAG =
            new Finding(
                    "quadratic_drag",
                    Optional.empty(),
                    List.of(new Quantity("k", "kg/m", 12.43)),
                    List.of(0.31),
                    0.991,
                    true);
    static final Finding THRUST =
            new Finding(
                    "thruster_gain",
                    Optional.of("port"),
                    List.of(new Quantity("factor", "1", 0.8)),
                    List.of(0.004),
                    0.3,
                    true);
    static final Finding CURRENT =
            new Finding(
                    "current_constant",
                    Optional.empty(),
                    List.of(
                            new Quantity("u.x", "m/s", 0.2),
                            new Quantity("u.y", "m/s", -0.1),
                            new Quantity("u.z", "m/s", 0)),
                    List.of(0.004, 0.003, 0.002),
                    0.2,
                    true);
    private static final Map<Channel, Double> NOISES =
            Map.of(Channel.POSITION, NOISE, Channel.ORIENTATION, TURN_NOISE);

    private Diagnoses() {}

    /** A scenario with a body of this drag (kg/m). */
    static Scenario scenario(double drag) {
        String xml =
                """
                <scenario>
                  <world-object name="sledge" mass="30">
                    <box><size x="1.2" y="0.4" z="0.3"/></box>
                    %s
                  </world-object>
                </scenario>
                """
                        .formatted(
                                drag == 0
                                        ? ""
                                        : "<isotropic-drag quadratic=\"%s\"/>".formatted(drag));
        try {
            return ScenarioLoader.load(Diagnoses.class.getClassLoader()).parse(xml.getBytes(UTF_8));
        } catch (AuvsmlException e) {
            throw new IllegalStateException(e);
        }
    }

    private static RigidMotion motion(double time, double drag) {
        double way = drag == 0 ? SPEED * time : Math.log1p(drag * SPEED * time) / drag;
        double speed = SPEED / (1 + drag * SPEED * time);
        double turn = 0.1 * time;
        return new RigidMotion(
                new Vec3(way, 8 * Math.sin(turn), -1 - 0.02 * way),
                Quat.ofAxisAngle(new Vec3(0, 0, 1), turn),
                new Vec3(speed, 0.8 * Math.cos(turn), -0.02 * speed),
                new Vec3(0, 0, 0.1));
    }

    private static List<RigidMotion> motions(int samples, double drag) {
        List<RigidMotion> motions = new ArrayList<>();
        for (int k = 0; k < samples; k++) {
            motions.add(motion(time(k, samples), drag));
        }
        return motions;
    }

    private static double time(int sample, int samples) {
        return DURATION * sample / (samples - 1);
    }

    static MeasuredRun run(String name, int samples, double drag, long seed) {
        Random noise = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named(name);
        int k = 0;
        for (RigidMotion motion : motions(samples, drag)) {
            RigidMotion told =
                    motion.plus(
                            new double[] {
                                NOISE * noise.nextGaussian(),
                                NOISE * noise.nextGaussian(),
                                NOISE * noise.nextGaussian(),
                                TURN_NOISE * noise.nextGaussian(),
                                TURN_NOISE * noise.nextGaussian(),
                                TURN_NOISE * noise.nextGaussian(),
                                0,
                                0,
                                0,
                                0,
                                0,
                                0
                            });
            Vec3 p = told.position();
            run.at(time(k++, samples))
                    .position(p.x(), p.y(), p.z())
                    .orientation(told.orientation());
        }
        return run.build();
    }

    private static DiagnosedRun diagnosed(
            String name, int samples, double drag, boolean isHeldOut) {
        MeasuredRun run = run(name, samples, drag, name.hashCode());
        List<ForceResidual> forces = new ArrayList<>();
        for (int k = 0; k < 60; k++) {
            double v = motion(k, drag).velocity().norm();
            forces.add(
                    new ForceResidual(
                            k,
                            new Vec3(-30 * drag * v * v, 0.02 * Math.sin(k), 0),
                            new Vec3(0.02 * Math.cos(k), 0.02 * Math.sin(k), 0)));
        }
        return new DiagnosedRun(
                run, isHeldOut, motions(samples, 0), motions(samples, drag), forces, Set.of());
    }

    private static List<DiagnosedRun> runs(int samples, double drag) {
        return List.of(
                diagnosed("run1", samples, drag, false),
                diagnosed("run2", samples, drag, false),
                diagnosed("run3", samples, drag, true));
    }

    /** Drag was found. */
    static Diagnosis explained() {
        return explained(1201, List.of());
    }

    /** Drag was found in runs of so many samples. */
    static Diagnosis explained(int samples, List<Alternative> alternatives) {
        return explained(List.of(QUADRATIC_DRAG), samples, alternatives);
    }

    static Diagnosis explained(List<Finding> found, int samples, List<Alternative> alternatives) {
        Map<Channel, Gain> heldOut =
                Map.of(
                        Channel.POSITION, new Gain(0.834, 0.0112, NOISE),
                        Channel.ORIENTATION, new Gain(0.0041, 0.00405, TURN_NOISE));
        return diagnosis(
                Verdict.EXPLAINED,
                new Sentences(heldOut, false, true).explained(found, 0.991, alternatives),
                found,
                alternatives,
                heldOut,
                runs(samples, DRAG),
                Optional.empty(),
                Optional.empty(),
                scenario(12.43),
                List.of("run2.csv: times of whole seconds are read as 20 samples a second."));
    }

    /** Nothing is wrong. */
    static Diagnosis none() {
        Map<Channel, Gain> heldOut = Map.of(Channel.POSITION, new Gain(0.0101, 0.0101, NOISE));
        return diagnosis(
                Verdict.NONE,
                new Sentences(heldOut, false, true).none(),
                List.of(),
                List.of(),
                heldOut,
                runs(601, 0),
                Optional.empty(),
                Optional.empty(),
                scenario(0),
                List.of());
    }

    /** Something is wrong that nobody knows. */
    static Diagnosis unexplained() {
        Map<Channel, Gain> heldOut = Map.of(Channel.POSITION, new Gain(0.834, 0.61, NOISE));
        Discrepancy seen =
                new Discrepancy(
                        Channel.POSITION,
                        new Axis(Frame.WORLD, 'y'),
                        "run2",
                        12.4,
                        new Vec3(3.21, -0.5, 2),
                        OptionalDouble.of(0.31),
                        0.41);
        return diagnosis(
                Verdict.UNEXPLAINED,
                new Sentences(heldOut, false, true).unexplained(Optional.of(seen)),
                List.of(),
                List.of(),
                heldOut,
                runs(601, DRAG),
                Optional.of(seen),
                Optional.of(
                        new Proposal(
                                "formula", "F.x = -1.2 v.x |v| < 0", new Gain(0.8, 0.4, 0.01))),
                scenario(0),
                List.of());
    }

    /** Where something is not explained: drag, which helps. */
    private static Optional<Approximation> approximation(Optional<Discrepancy> seen) {
        Finding drag =
                new Finding(
                        "quadratic_drag",
                        Optional.empty(),
                        QUADRATIC_DRAG.quantities(),
                        List.of(),
                        0.6,
                        true);
        return seen.map(_ -> new Approximation(List.of(drag), scenario(12.43)));
    }

    private static HorizonGain ahead(double seconds, double before, double after) {
        return new HorizonGain(seconds, Map.of(Channel.POSITION, new Gain(before, after, NOISE)));
    }

    private static Diagnosis diagnosis(
            Verdict verdict,
            Sentence sentence,
            List<Finding> selected,
            List<Alternative> alternatives,
            Map<Channel, Gain> gains,
            List<DiagnosedRun> runs,
            Optional<Discrepancy> discrepancy,
            Optional<Proposal> proposal,
            Scenario extended,
            List<String> notices) {
        return new Diagnosis(
                "sledge",
                new Conclusion(
                        verdict,
                        sentence,
                        selected,
                        discrepancy,
                        approximation(discrepancy),
                        proposal),
                evidence(selected, alternatives),
                new Prediction(
                        NOISES,
                        gains,
                        List.of(
                                ahead(1, 0.012, 0.0105),
                                ahead(5, 0.08, 0.0107),
                                ahead(20, 0.4, 0.011),
                                ahead(60, 0.834, 0.0112)),
                        false),
                runs,
                extended,
                notices,
                42,
                true);
    }

    private static Evidence evidence(List<Finding> selected, List<Alternative> alternatives) {
        return new Evidence(
                62,
                ranked(selected),
                alternatives,
                new Identifiability(
                        List.of(
                                new Confusion("quadratic_drag", "k", "linear_drag", "c", 11.2),
                                new Confusion("mass_error", "factor", "added_mass", "m.x", 0.4)),
                        List.of("magnus"),
                        List.of("restitution", "contact_friction"),
                        List.of(new Smallest("mass_error", "factor", "1", 0.0123))),
                Optional.of(
                        new NextExperiment(
                                "coast_down",
                                "Speed up to 3 m/s, then coast with all thrusters off.",
                                List.of("quadratic_drag", "linear_drag"),
                                41)));
    }

    /** The runs of a null, but no model gets through the held-out one. */
    static Diagnosis brokenOff() {
        List<DiagnosedRun> runs = new ArrayList<>(runs(50, 0));
        DiagnosedRun last = runs.removeLast();
        runs.add(new DiagnosedRun(last.run(), true, List.of(), List.of(), List.of(), Set.of()));
        return diagnosis(
                Verdict.NONE,
                Sentence.of("Nothing"),
                List.of(),
                List.of(),
                Map.of(),
                runs,
                Optional.empty(),
                Optional.empty(),
                scenario(0),
                List.of());
    }

    /** The same of a body of another name. */
    static Diagnosis renamed(Diagnosis of, String body) {
        return with(of, body, of.evidence(), of.prediction(), of.isComplete());
    }

    /** The same of a search that was stopped before its end. */
    static Diagnosis stopped(Diagnosis of) {
        return with(of, of.body(), of.evidence(), of.prediction(), false).toldAsFarAsItCame();
    }

    /** The same, a set that was not chosen having so much more evidence. */
    static Diagnosis outweighed(Diagnosis of, double more, String reason) {
        List<Ranked> sets = new ArrayList<>(of.evidence().ranked());
        double evidence = sets.getFirst().logEvidence() + more;
        sets.add(
                new Ranked(
                        List.of("magnetic"), List.of(List.of()), evidence, 0, Optional.of(reason)));
        return of.explained(of.selected().getFirst(), of.conclusion().sentence(), sets);
    }

    /** The same without anything that is left open. */
    static Diagnosis settled(Diagnosis of) {
        return with(
                of,
                new Evidence(
                        of.evidence().candidates(),
                        of.evidence().ranked(),
                        of.evidence().alternatives(),
                        of.evidence().identifiability(),
                        Optional.empty()));
    }

    /** The same where no cause was tried. */
    static Diagnosis untried(Diagnosis of) {
        return with(of, List.of(new Ranked(List.of(), List.of(), 0, 1, Optional.empty())));
    }

    /** The same, two causes tried together. */
    static Diagnosis withPair(Diagnosis of) {
        Ranked pair =
                new Ranked(
                        List.of("linear_drag", "magnus"),
                        List.of(
                                List.of(new Quantity("c", "N s/m", 8.1)),
                                List.of(new Quantity("s", "kg", 0.2))),
                        -1270,
                        0,
                        Optional.empty());
        return with(of, List.of(of.evidence().ranked().getFirst(), pair));
    }

    /** The same, a set having more evidence than that which errors are told of. */
    static Diagnosis overtaken(Diagnosis of, String reason) {
        List<Ranked> sets = new ArrayList<>(of.evidence().ranked());
        sets.addFirst(
                new Ranked(List.of("magnetic"), List.of(List.of()), 0, 0, Optional.of(reason)));
        return with(of, sets);
    }

    /** The same where the believed model gets lost between 5 and 60 s. */
    static Diagnosis lost(Diagnosis of) {
        return with(
                of,
                List.of(ahead(5, 0.08, 0.0107), ahead(60, Double.POSITIVE_INFINITY, 0.0112)),
                of.prediction().usedHeldOut());
    }

    /** The same, its held-out runs used for the search, too. */
    static Diagnosis searchedWithAll(Diagnosis of) {
        return with(of, of.prediction().horizons(), /* usedHeldOut= */ true);
    }

    private static Diagnosis with(Diagnosis of, List<HorizonGain> horizons, boolean usedHeldOut) {
        Prediction before = of.prediction();
        return with(
                of,
                of.body(),
                of.evidence(),
                new Prediction(before.noise(), before.gains(), horizons, usedHeldOut),
                of.isComplete());
    }

    private static Diagnosis with(Diagnosis of, List<Ranked> ranked) {
        Evidence before = of.evidence();
        return with(
                of,
                new Evidence(
                        before.candidates(),
                        ranked,
                        before.alternatives(),
                        before.identifiability(),
                        before.nextExperiment()));
    }

    private static Diagnosis with(Diagnosis of, Evidence evidence) {
        return with(of, of.body(), evidence, of.prediction(), of.isComplete());
    }

    private static Diagnosis with(
            Diagnosis of,
            String body,
            Evidence evidence,
            Prediction prediction,
            boolean isComplete) {
        return new Diagnosis(
                body,
                of.conclusion(),
                evidence,
                prediction,
                of.runs(),
                of.extended(),
                of.notices(),
                of.seed(),
                isComplete);
    }

    private static List<Ranked> ranked(List<Finding> selected) {
        return List.of(
                new Ranked(
                        selected.stream().map(Finding::name).toList(),
                        selected.stream().map(Finding::quantities).toList(),
                        -1234.5,
                        0.9999,
                        Optional.empty()),
                new Ranked(
                        List.of("linear_drag"),
                        List.of(List.of(new Quantity("c", "N s/m", 8.1))),
                        -1260,
                        1e-11,
                        Optional.empty()),
                new Ranked(
                        List.of("magnus"),
                        List.of(List.of(new Quantity("s", "kg", 8.1))),
                        Double.NEGATIVE_INFINITY,
                        0,
                        Optional.empty()));
    }
}
