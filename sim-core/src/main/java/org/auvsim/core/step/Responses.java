package org.auvsim.core.step;

import org.auvsim.core.entity.Change;
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
    private record Response(long responder, List<Change> changes) {}

    private Responses() {}

    /** Responds to all pairs of the sets that touch and approach now. */
    static StepResult to(Motion motion, CollisionSets sets, double elapsed) {
        List<Collision> collisions = new ArrayList<>();
        List<Response> responses = new ArrayList<>();
        Map<Long, RigidBody> bodies = new TreeMap<>();
        for (int k = 0; k < sets.pairCount(); k++) {
            int i = sets.first(k);
            int j = sets.second(k);
            if (motion.overlap(i, j, 0) && motion.approaching(i, j, 0)) {
                collisions.add(respond(motion, i, j, responses));
                collectBody(motion, i, bodies);
                collectBody(motion, j, bodies);
            }
        }
        responses.sort(Comparator.comparingLong(Response::responder));
        return new StepResult(elapsed, collisions, apply(responses, bodies));
    }

    private static Collision respond(Motion motion, int i, int j, List<Response> responses) {
        Contact contact = motion.contact(i, j);
        List<Change> mine = motion.response(i).respond(contact);
        List<Change> its = motion.response(j).respond(contact.flipped());
        responses.add(new Response(contact.self().id(), mine));
        responses.add(new Response(contact.other().id(), its));
        Vec3 impulse = received(mine, contact.self().id()).plus(received(its, contact.self().id()));
        return new Collision(contact, impulse);
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
    private static List<Change> apply(List<Response> responses, Map<Long, RigidBody> bodies) {
        List<Change> rest = new ArrayList<>();
        for (Response response : responses) {
            for (Change change : response.changes()) {
                if (change instanceof Change.Momentum m && bodies.get(m.objectId()) != null) {
                    addMomentum(bodies.get(m.objectId()), m);
                } else {
                    rest.add(change);
                }
            }
        }
        return rest;
    }

    private static void addMomentum(RigidBody body, Change.Momentum m) {
        body.setLinearMomentum(body.linearMomentum().plus(m.linear()));
        body.setAngularMomentum(body.angularMomentum().plus(m.angular()));
    }
}
