package org.auvsim.core.world;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.CollisionResponse;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.step.ContactMemory;
import org.auvsim.core.step.Lanes;
import org.auvsim.core.step.Motion;
import org.auvsim.core.step.Overlap;
import org.auvsim.core.step.StepTally;
import org.auvsim.core.volume.PairQueries;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * How those in a world move and meet: the equations of motion of the present bodies under the
 * present effects, laid out when they are first asked for after a change.
 */
final class Mechanics {
    /** So many overlaps are told one by one. */
    private static final int MOST_LISTED = 10;

    private final Population population;
    private final Integrator integrator;
    private final CollisionResponse response;
    private final PairQueries queries;
    private final boolean asBoundingSpheres;
    private final Lanes lanes;
    private final StepTally tally;
    private final ContactMemory memory;
    private Optional<List<BlockEffect>> effects = Optional.empty();
    private Optional<Motion> motion = Optional.empty();

    Mechanics(WorldBuilder builder, Population population) {
        this.population = population;
        integrator = builder.integrator;
        response = builder.response;
        queries = builder.queries;
        asBoundingSpheres = builder.asBoundingSpheres;
        lanes = builder.lanes;
        tally = new StepTally();
        memory = new ContactMemory();
    }

    /** The same for an equal population. */
    Mechanics(Mechanics original, Population population) {
        this.population = population;
        integrator = original.integrator;
        response = original.response;
        queries = original.queries;
        asBoundingSpheres = original.asBoundingSpheres;
        lanes = original.lanes;
        tally = original.tally.copy();
        memory = original.memory.copy();
        effects = original.effects;
    }

    /** What the steps have done since the world was built. */
    StepTally tally() {
        return tally;
    }

    /** The motion from the present state on, which is that of a time (s). */
    Motion motion(double time) {
        if (motion.isEmpty()) {
            motion = Optional.of(layOut(time));
        }
        Motion here = motion.get();
        here.begin(time);
        return here;
    }

    private Motion layOut(double time) {
        if (effects.isEmpty()) {
            effects = Optional.of(EffectLayout.of(population.bodies()));
        }
        List<Collidable> collidables = new ArrayList<>();
        for (Entity entity : population.entities()) {
            if (entity instanceof Collidable collidable) {
                collidables.add(collidable);
            }
        }
        EquationsOfMotion equations =
                new EquationsOfMotion(population.bodies().state(), effects.get());
        return new Motion(
                population.bodies(),
                collidables,
                equations,
                integrator,
                queries,
                response,
                asBoundingSpheres,
                lanes,
                tally,
                memory,
                time);
    }

    /** An entity has come. */
    void entered() {
        changed();
    }

    /** An entity has gone; contacts of before are not to be taken for those of others. */
    void left() {
        memory.clear();
        entered();
    }

    /** An entity that is no body, or what acts on one that is, has changed. */
    void changed() {
        effects = Optional.empty();
        motion = Optional.empty();
    }

    /**
     * Nothing if an object may collide in this world.
     *
     * @throws WorldException if it is to collide as its bounding sphere and has none
     */
    void requireBounds(WorldObjectDefinition definition) {
        if (asBoundingSpheres && !definition.volume().isBounded()) {
            throw new WorldException(
                    "'%s' has no bounding sphere, as its volume has no end; leave it out or let"
                                    .formatted(definition.name())
                            + " objects collide as their volumes");
        }
    }

    /**
     * Nothing if no bodies that would collide overlap by more than rounding.
     *
     * @throws WorldException naming them
     */
    void requireApart(double time) {
        List<Overlap> overlaps = motion(time).overlaps();
        if (overlaps.isEmpty()) {
            return;
        }
        String listed =
                overlaps.stream()
                        .limit(MOST_LISTED)
                        .map(Overlap::toString)
                        .collect(Collectors.joining(", "));
        int more = overlaps.size() - MOST_LISTED;
        throw new WorldException(
                "objects overlap at the start: %s%s; move them apart or set allow-overlaps"
                        .formatted(listed, more > 0 ? " and " + more + " pairs more" : ""));
    }
}
