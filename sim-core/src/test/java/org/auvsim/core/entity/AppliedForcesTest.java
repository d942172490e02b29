package org.auvsim.core.entity;

import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/** Resultants against the plain sum of the forces and of their torques. */
class AppliedForcesTest {
    private final Bodies bodies = new Bodies();

    private static WorldObjectDefinition drawn(Draws draws, int i) {
        WorldObjectDefinition.Builder body =
                WorldObjectDefinition.named("body " + i)
                        .volume(new Sphere(1))
                        .mass(1)
                        .orientation(draws.orientation());
        for (int k = 0; k < i % 5; k++) {
            body.force(drawnForce(draws, "force " + k));
            body.component(
                    new Propulsor(
                            "screw " + k,
                            draws.number(0, 9),
                            draws.number(-1, 1),
                            draws.vector(2),
                            draws.direction()));
        }
        return body.build();
    }

    private static NamedForce drawnForce(Draws draws, String name) {
        Frame frame = draws.number(0, 1) < 0.5 ? Frame.BODY : Frame.WORLD;
        return new NamedForce(name, frame, draws.vector(5), draws.vector(2));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void theResultantIsTheSumOfForcesAndTorques(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 40; i++) {
            bodies.add(i + 1, drawn(draws, i));
        }
        assertResultants(bodies);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void itFollowsWhateverChanges(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 20; i++) {
            bodies.add(i + 1, drawn(draws, i));
        }
        Bodies before = bodies.copy();
        for (int i = 0; i < 20; i += 2) {
            WorldObject body = bodies.objects().get(i);
            body.applyForce(drawnForce(draws, "force 0"));
            body.removeForce("force 1");
            body.components(Propulsor.class)
                    .forEach(p -> body.command(Propulsor.class, p.name(), p.level() / 2));
        }
        bodies.remove(bodies.objects().get(7));
        bodies.remove(bodies.objects().getLast());
        bodies.add(21, drawn(draws, 3));
        assertResultants(bodies);
        assertResultants(before);
        bodies.objects().forEach(body -> body.setForces(List.of()));
        bodies.objects().forEach(body -> removePropulsors(body));
        assertResultants(bodies);
    }

    private static void removePropulsors(WorldObject body) {
        body.components(Propulsor.class).forEach(propulsor -> body.remove(propulsor.name()));
    }

    private static void assertResultants(Bodies bodies) {
        Block block = new Block();
        block.take(3, bodies.count() - 3);
        for (int i = 0; i < block.count; i++) {
            setRotation(block, i, bodies.objects().get(3 + i).orientation().toMatrix());
        }
        bodies.state().applied().load(block);
        bodies.state().applied().write(block);
        for (int i = 0; i < block.count; i++) {
            WorldObject body = bodies.objects().get(3 + i);
            Vec3 force = Vec3.ZERO;
            Vec3 torque = Vec3.ZERO;
            for (NamedForce one : all(body)) {
                Vec3 vector = one.vector();
                Vec3 inWorld =
                        one.frame() == Frame.BODY ? body.orientation().rotate(vector) : vector;
                force = force.plus(inWorld);
                torque = torque.plus(body.orientation().rotate(one.point()).cross(inWorld));
            }
            assertNear(new Vec3(block.fx[i], block.fy[i], block.fz[i]), force, 1e-13);
            assertNear(new Vec3(block.tx[i], block.ty[i], block.tz[i]), torque, 1e-12);
        }
    }

    private static List<NamedForce> all(WorldObject body) {
        List<NamedForce> all = new ArrayList<>(body.forces());
        for (Propulsor p : body.components(Propulsor.class)) {
            Vec3 push = p.direction().times(p.maximumThrust() * p.level());
            all.add(new NamedForce(p.name(), Frame.BODY, push, p.position()));
        }
        return all;
    }

    private static void setRotation(Block block, int i, Mat3 r) {
        block.rxx[i] = r.xx();
        block.rxy[i] = r.xy();
        block.rxz[i] = r.xz();
        block.ryx[i] = r.yx();
        block.ryy[i] = r.yy();
        block.ryz[i] = r.yz();
        block.rzx[i] = r.zx();
        block.rzy[i] = r.zy();
        block.rzz[i] = r.zz();
    }
}
