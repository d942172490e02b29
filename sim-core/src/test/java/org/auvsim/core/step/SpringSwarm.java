package org.auvsim.core.step;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.reference.Swarm;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;

import java.util.ArrayList;
import java.util.List;

/** Balls on springs, in a world and in the exact solution beside it. */
record SpringSwarm(long seed, int n) {
    private static final double FREQUENCY = 1.2;

    private Swarm drawn() {
        return Swarm.drawn(seed, n, FREQUENCY);
    }

    World world(Stepper stepper, double timeStep) {
        Swarm swarm = drawn();
        WorldBuilder builder = World.builder().stepper(stepper).timeStep(timeStep);
        for (int i = 0; i < n; i++) {
            double stiffness = swarm.mass(i) * FREQUENCY * FREQUENCY;
            builder.add(
                    WorldObjectDefinition.named("Ball " + i)
                            .id(i + 1)
                            .volume(new Sphere(swarm.radius(i)))
                            .mass(swarm.mass(i))
                            .position(swarm.place(i, 0), swarm.place(i, 1), swarm.place(i, 2))
                            .velocity(swarm.speed(i, 0), swarm.speed(i, 1), swarm.speed(i, 2))
                            .effect(new Spring(centre(swarm, i), stiffness))
                            .build());
        }
        return builder.build();
    }

    private static Vec3 centre(Swarm swarm, int i) {
        return new Vec3(swarm.centre(i, 0), swarm.centre(i, 1), swarm.centre(i, 2));
    }

    /**
     * The exact collisions up to a time (s), as long as places moved by 1e-9 m at the beginning
     * change their times by less than 1e-6 s, and up to the first graze that is shallower than a
     * depth (share of the radius).
     */
    List<Swarm.Meeting> meetings(double end, double depth) {
        List<Swarm.Meeting> exact = drawn().run(end);
        List<Swarm.Meeting> shaken = drawn().shaken(1e-9, seed).run(end);
        int count = 0;
        while (count < Math.min(exact.size(), shaken.size())
                && same(exact.get(count), shaken.get(count))
                && exact.get(count).depth() > depth) {
            count++;
        }
        return exact.subList(0, count);
    }

    private static boolean same(Swarm.Meeting a, Swarm.Meeting b) {
        return a.first() == b.first()
                && a.second() == b.second()
                && Math.abs(a.time() - b.time()) < 1e-6;
    }

    /** A collision as the exact solution tells it; its depth is not known. */
    static Swarm.Meeting meeting(Collision collision) {
        int self = (int) collision.contact().self().id() - 1;
        int other = (int) collision.contact().other().id() - 1;
        return new Swarm.Meeting(
                collision.contact().time(), Math.min(self, other), Math.max(self, other), 0);
    }

    /** The collisions of a world up to a time (s). */
    static List<Swarm.Meeting> collisions(World world, double end) {
        List<Swarm.Meeting> all = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided(double _, Collision collision)) {
                        all.add(meeting(collision));
                    }
                });
        while (world.time() < end) {
            world.advanceTimestep();
        }
        return all;
    }

    /** Deepest overlap of two balls (share of the lesser radius); negative if none overlap. */
    double overlap(World world) {
        Swarm swarm = drawn();
        double deepest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < n; i++) {
            Vec3 place = world.object(i + 1).position();
            for (int j = 0; j < i; j++) {
                double reach = swarm.radius(i) + swarm.radius(j);
                double overlap = reach - place.distance(world.object(j + 1).position());
                double lesser = Math.min(swarm.radius(i), swarm.radius(j));
                deepest = Math.max(deepest, overlap / lesser);
            }
        }
        return deepest;
    }

    /** Greatest distance (m) of a ball from where the exact solution has it. */
    double error(World world) {
        Swarm swarm = drawn();
        swarm.run(world.time());
        double worst = 0;
        for (int i = 0; i < n; i++) {
            Vec3 exact =
                    new Vec3(
                            swarm.placeAt(i, 0, world.time()),
                            swarm.placeAt(i, 1, world.time()),
                            swarm.placeAt(i, 2, world.time()));
            worst = Math.max(worst, world.object(i + 1).position().distance(exact));
        }
        return worst;
    }
}
