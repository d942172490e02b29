package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Runs of a body that is otherwise than the scenario has it: three to fit and two held out.
 * Immutable.
 */
public final class HiddenCase {
    private final Drawn drawn;
    private final List<HiddenEffect> hidden;
    private final Optional<Twins> twins;
    private final String scenario;
    private final CaseRuns runs;
    private final Scene scene;

    /** What was asked for, and the kind of body that came of it. */
    record Drawn(CaseKind kind, double noise, long seed, String body) {}

    HiddenCase(
            Drawn drawn,
            List<HiddenEffect> hidden,
            Optional<Twins> twins,
            String scenario,
            CaseRuns runs,
            Scene scene) {
        this.drawn = drawn;
        this.hidden = List.copyOf(hidden);
        this.twins = twins;
        this.scenario = scenario;
        this.runs = runs;
        this.scene = scene;
    }

    /** What is hidden. */
    public CaseKind kind() {
        return drawn.kind();
    }

    /** Noise of measurements, as a share of the motion's range. */
    public double noise() {
        return drawn.noise();
    }

    /** From which it is drawn. */
    public long seed() {
        return drawn.seed();
    }

    /** What kind of body it is. */
    public String body() {
        return drawn.body();
    }

    /** What is otherwise; empty: nothing. */
    public List<HiddenEffect> hidden() {
        return hidden;
    }

    /** Causes that the data may not tell apart. */
    public Optional<Twins> twins() {
        return twins;
    }

    /** Runs to search with. */
    public List<MeasuredRun> fit() {
        return runs.measured().subList(0, CaseRuns.FIT);
    }

    /** Runs that only judge. */
    public List<MeasuredRun> heldOut() {
        return runs.measured().subList(CaseRuns.FIT, runs.measured().size());
    }

    /** Of each held-out run: what sensors without noise would tell. */
    List<List<Pose>> truth() {
        return runs.truth().subList(CaseRuns.FIT, runs.truth().size());
    }

    /** What the body does as believed. */
    Scene scene() {
        return scene;
    }

    /** The model as it is believed. */
    public BelievedModel model() {
        return new BelievedModel(parsed(), ScenarioText.BODY);
    }

    private Scenario parsed() {
        try {
            return ScenarioLoader.load(HiddenCase.class.getClassLoader())
                    .parse(scenario.getBytes(StandardCharsets.UTF_8));
        } catch (AuvsmlException e) {
            throw new IllegalStateException("the generated scenario is wrong: " + scenario, e);
        }
    }

    /**
     * How far a prediction of a held-out run is from the truth, in shares of the motion's range
     * (root mean square of positions, and of attitudes where they are measured); infinite if it
     * gets lost.
     */
    public double error(int run, List<RigidMotion> predicted) {
        List<Pose> of = truth().get(run);
        double sum = 0;
        for (int k = 0; k < of.size(); k++) {
            RigidMotion told = predicted.get(k);
            Vector3D p =
                    new Vector3D(told.position().x(), told.position().y(), told.position().z());
            double away = p.distance(of.get(k).position()) / scene.range();
            sum += away * away;
            if (scene.shows()) {
                Quat q = told.orientation();
                double turned =
                        new Attitude(q.w(), q.x(), q.y(), q.z()).angleTo(of.get(k).attitude())
                                / scene.turns();
                sum += turned * turned;
            }
        }
        return Double.isNaN(sum) ? Double.POSITIVE_INFINITY : Math.sqrt(sum / of.size());
    }

    /**
     * Whether a finding is a hidden effect: the same cause, of the same part of the body, with the
     * same numbers, whatever these are: a thruster's tilt is not its angle.
     */
    public boolean isHit(HiddenEffect effect, Finding found) {
        return effect.cause().equals(found.cause())
                && (effect.subject().equals(found.subject())
                        || scene.plant().thrusters().size() == 1)
                && effect.parameters().keySet().stream().allMatch(name -> tells(found, name));
    }

    private static boolean tells(Finding found, String name) {
        return found.quantities().stream()
                .map(Quantity::name)
                .anyMatch(of -> of.equals(name) || of.startsWith(name + "."));
    }

    /** How it can be made again. */
    public String repeat() {
        return String.format(
                Locale.ROOT,
                "auvsim bench diagnosis --kind %s --noise %s --seed %d --cases 1",
                kind(),
                noise(),
                seed());
    }

    @Override
    public String toString() {
        return "%s at noise %s, seed %d: %s, hidden %s"
                .formatted(kind(), noise(), seed(), body(), hidden);
    }
}
