package org.auvsim.junit;

import org.auvsim.auvsml.document.Scenario;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * A scenario, run again with the present code: where its bodies went and what they met. A test gets
 * it as a parameter by {@link ReplayScenario}.
 */
public final class Replay {
    private final Observed observed;
    private final Evidence evidence;

    Replay(Observed observed, Evidence evidence) {
        this.observed = observed;
        this.evidence = evidence;
    }

    /** The world at the beginning, and how it was run. */
    public Scenario scenario() {
        return observed.scenario();
    }

    /** World time (s) at the beginning. */
    public double begin() {
        return observed.scenario().startTime();
    }

    /** World time (s) at the end. */
    public double end() {
        return observed.end();
    }

    /** How long it lasted (s). */
    public double duration() {
        return end() - begin();
    }

    /** The trajectories of all bodies that ever were in the world, in order of their ids. */
    public List<Trajectory> trajectories() {
        return observed.tracks().stream().map(track -> new Trajectory(this, track)).toList();
    }

    /**
     * The trajectory of the body with a name; the first one of them if there were several.
     *
     * @throws IllegalArgumentException naming those that there are, if there is none
     */
    public Trajectory trajectory(String name) {
        return find(t -> t.name().equals(name), "'%s'".formatted(name));
    }

    /**
     * The trajectory of the body with an id.
     *
     * @throws IllegalArgumentException naming those that there are, if there is none
     */
    public Trajectory trajectory(long id) {
        return find(t -> t.id() == id, "with id " + id);
    }

    private Trajectory find(Predicate<Trajectory> wanted, String what) {
        return trajectories().stream()
                .filter(wanted)
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "%s has no body %s; it has %s"
                                                .formatted(observed.source(), what, bodies())));
    }

    private String bodies() {
        return trajectories().stream()
                .map(t -> "'%s' (id %d)".formatted(t.name(), t.id()))
                .collect(Collectors.joining(", "));
    }

    /** All collisions, in order of time. */
    public List<Encounter> collisions() {
        return observed.encounters();
    }

    /**
     * Where the run first differed from the recording by as much as a bit, in a sentence; empty if
     * it did not. A plain scenario has nothing to differ from.
     */
    public Optional<String> divergence() {
        return observed.divergence();
    }

    /** Whether this is the replay of a recording, which says what is to be expected. */
    boolean isOfRecording() {
        return observed.ofRecording();
    }

    Evidence evidence() {
        return evidence;
    }

    @Override
    public String toString() {
        return "%s, %s to %s s".formatted(observed.source(), begin(), end());
    }
}
