package org.auvsim.core.step;

import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Collidable;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The last part of a step: all pairs in contact respond. Every response is computed from the states
 * before any of them; then they are applied in order of the ids of those who responded.
 */
final class Responses {
    private record Response(Collidable responder, Collidable other, List<Change> changes) {}

    private Responses() {}

    /**
     * Responds to all of these pairs, which touch and approach now.
     *
     * @throws StepException if a response fails, or what it changes is impossible; some momenta may
     *     have changed then
     */
    static StepResult to(Motion motion, List<Pair> touching, double elapsed) {
        List<Collision> collisions = new ArrayList<>();
        List<Response> responses = new ArrayList<>();
        Map<Long, RigidBody> bodies = new TreeMap<>();
        for (Pair pair : touching) {
            collisions.add(respond(motion, pair.first(), pair.second(), responses));
            collectBody(motion, pair.first(), bodies);
            collectBody(motion, pair.second(), bodies);
        }
        responses.sort(Comparator.comparingLong(r -> r.responder().id()));
        List<Change> changes = apply(responses, bodies, motion.time());
        return new StepResult(elapsed, collisions, changes, false);
    }

    private static Collision respond(Motion motion, int i, int j, List<Response> responses) {
        Collidable self = motion.collidable(i);
        Collidable other = motion.collidable(j);
        try {
            Contact contact = motion.contact(i, j);
            List<Change> mine = List.copyOf(motion.response(i).respond(contact));
            List<Change> its = List.copyOf(motion.response(j).respond(contact.flipped()));
            responses.add(new Response(self, other, mine));
            responses.add(new Response(other, self, its));
            return new Collision(contact, received(mine, self.id()).plus(received(its, self.id())));
        } catch (RuntimeException e) {
            throw failed(self, other, motion.time(), e);
        }
    }

    private static StepException failed(
            Collidable self, Collidable other, double time, RuntimeException cause) {
        return new StepException(
                "the collision of '%s' (id %d) and '%s' (id %d) at %s s has no response: %s;"
                                .formatted(
                                        self.name(),
                                        self.id(),
                                        other.name(),
                                        other.id(),
                                        time,
                                        cause)
                        + " check their collision responses",
                cause);
    }

    private static Vec3 received(List<Change> changes, long id) {
        Vec3 sum = Vec3.ZERO;
        for (Change change : changes) {
            if (change instanceof Change.Momentum m && m.objectId() == id) {
                sum = sum.plus(m.linear());
            }
        }
        return sum;
    }

    private static void collectBody(Motion motion, int i, Map<Long, RigidBody> bodies) {
        if (motion.collidable(i) instanceof RigidBody body) {
            bodies.put(body.id(), body);
        }
    }

    /** Applies changes of momentum; returns the others, which are for the world. */
    private static List<Change> apply(
            List<Response> responses, Map<Long, RigidBody> bodies, double time) {
        List<Change> rest = new ArrayList<>();
        for (Response response : responses) {
            try {
                apply(response.changes(), bodies, rest);
            } catch (RuntimeException e) {
                throw failed(response.responder(), response.other(), time, e);
            }
        }
        return rest;
    }

    private static void apply(
            List<Change> changes, Map<Long, RigidBody> bodies, List<Change> rest) {
        for (Change change : changes) {
            if (change instanceof Change.Momentum m && bodies.get(m.objectId()) != null) {
                addMomentum(bodies.get(m.objectId()), m);
            } else {
                rest.add(change);
            }
        }
    }

    private static void addMomentum(RigidBody body, Change.Momentum m) {
        body.setLinearMomentum(body.linearMomentum().plus(m.linear()));
        body.setAngularMomentum(body.angularMomentum().plus(m.angular()));
    }
}
