package org.auvsim.core.entity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

class RigidBodyTest {
    private static final Vec3 PUSH = new Vec3(1, 2, 3);

    private final Bodies bodies = new Bodies();

    private static WorldObjectDefinition.Builder crate() {
        return WorldObjectDefinition.named("crate").volume(new Box(new Vec3(1, 2, 3)));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void velocitiesAndMomentaAgreeInEveryOrientation(long seed) {
        Draws draws = new Draws(seed);
        Inertia inertia = new Inertia(2, 3, 4, 0.1, -0.2, 0.3);
        WorldObject body = bodies.add(1, crate().mass(5).inertia(inertia).build());
        body.setOrientation(draws.orientation());
        Vec3 v = draws.vector(3);
        Vec3 w = draws.vector(3);
        body.setVelocity(v);
        body.setAngularVelocity(w);
        assertNear(body.velocity(), v, 1e-14);
        assertNear(body.angularVelocity(), w, 1e-13);
        assertNear(body.linearMomentum(), v.times(5), 1e-14);
        Mat3 turn = body.orientation().toMatrix();
        Mat3 inWorld = turn.times(inertia.toMatrix()).times(turn.transposed());
        assertNear(body.angularMomentum(), inWorld.times(w), 1e-13);
        assertNear(body.mobility().angular().times(inWorld), Mat3.IDENTITY, 1e-14);
        Vec3 point = body.position().plus(new Vec3(0.5, 1, 0));
        assertNear(body.motion().velocityAt(point), v.plus(w.cross(new Vec3(0.5, 1, 0))), 1e-13);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void bothVelocitiesAreSetAtOnceAsOneAfterTheOther(long seed) {
        Draws draws = new Draws(seed);
        Vec3 ones = new Vec3(1, 2, 3);
        List<WorldObjectDefinition.Builder> kinds =
                List.of(
                        crate().mass(5),
                        crate().mass(5).centreOfMass(draws.vector(0.1)),
                        crate().mass(5).addedMass(new AddedMass(ones, ones, List.of())),
                        crate().fixed());
        for (int k = 0; k < kinds.size(); k++) {
            WorldObjectDefinition.Builder kind = kinds.get(k);
            WorldObject atOnce = bodies.add(2 * k + 1, kind.renamed("at once " + k).build());
            WorldObject inTurn = bodies.add(2 * k + 2, kind.renamed("in turn " + k).build());
            Twist twist = new Twist(draws.vector(3), draws.vector(3));
            Quat turn = draws.orientation();
            atOnce.setOrientation(turn);
            atOnce.setTwist(twist);
            inTurn.setOrientation(turn);
            inTurn.setVelocity(twist.velocity());
            inTurn.setAngularVelocity(twist.angularVelocity());
            assertNear(atOnce.linearMomentum(), inTurn.linearMomentum(), 1e-12);
            assertNear(atOnce.angularMomentum(), inTurn.angularMomentum(), 1e-12);
        }
    }

    @Test
    void ofTwoVelocitiesNoneIsSetIfOneIsNotFinite() {
        WorldObject body = bodies.add(1, crate().mass(1).build());
        assertThatIllegalArgumentException()
                .isThrownBy(() -> body.setTwist(new Twist(PUSH, new Vec3(0, Double.NaN, 0))))
                .withMessage("angular velocity of 'crate' must be finite, but is (0.0, NaN, 0.0)");
        assertThat(body.velocity()).isEqualTo(Vec3.ZERO);
    }

    @Test
    void aMovementStateIsSetAndReadBack() {
        WorldObject body = bodies.add(1, crate().mass(5).build());
        MovementState state =
                new MovementState(PUSH, new Quat(0.5, 0.5, -0.5, 0.5), PUSH, PUSH.negated());
        body.setMovementState(state);
        assertThat(body.movementState()).isEqualTo(state);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4})
    void theInverseInertiaTurnsMomentaIntoVelocitiesInEveryOrientation(long seed) {
        Draws draws = new Draws(seed);
        Inertia inertia = new Inertia(2, 3, 4, 0.1, -0.2, 0.3);
        WorldObject body = bodies.add(1, crate().mass(5).inertia(inertia).build());
        Quat turn = draws.orientation();
        body.setOrientation(turn);
        body.setLinearMomentum(draws.vector(3));
        body.setAngularMomentum(draws.vector(3));
        double[] k = new double[40];
        bodies.state().inverseInertia6(0, turn.w(), turn.x(), turn.y(), turn.z(), k, 2);
        double[] momenta = new double[6];
        put(momenta, 0, body.linearMomentum());
        put(momenta, 3, body.angularMomentum());
        double[] velocities = new double[6];
        for (int row = 0; row < 6; row++) {
            for (int column = 0; column < 6; column++) {
                velocities[row] += k[2 + 6 * row + column] * momenta[column];
            }
        }
        assertNear(new Vec3(velocities[0], velocities[1], velocities[2]), body.velocity(), 1e-14);
        assertNear(
                new Vec3(velocities[3], velocities[4], velocities[5]),
                body.angularVelocity(),
                1e-14);
        assertThat(new double[] {k[0], k[1], k[38], k[39]}).containsOnly(0);
    }

    private static void put(double[] to, int at, Vec3 v) {
        to[at] = v.x();
        to[at + 1] = v.y();
        to[at + 2] = v.z();
    }

    @Test
    void theInverseInertiaOfAFixedBodyIsZero() {
        bodies.add(1, crate().fixed().mass(3).build());
        double[] k = new double[36];
        k[7] = 1;
        bodies.state().inverseInertia6(0, 0.6, 0.8, 0, 0, k, 0);
        assertThat(k).containsOnly(0);
    }

    @Test
    void eitherOfTwoMayIgnoreTheOthersLayer() {
        WorldObject ghost = bodies.add(1, crate().mass(1).layer(31).ignores(0).build());
        WorldObject wall = bodies.add(2, crate().fixed().build());
        WorldObject other = bodies.add(3, crate().fixed().layer(2).ignores(5).build());
        assertThat(ghost.ignoredLayers()).isEqualTo(1);
        assertThat(other.ignoredLayers()).isEqualTo(1 << 5);
        assertThat(ghost.meetsLayerOf(wall)).isFalse();
        assertThat(wall.meetsLayerOf(ghost)).isFalse();
        assertThat(ghost.meetsLayerOf(other)).isTrue();
        assertThat(wall.meetsLayerOf(other)).isTrue();
        WorldObject last = bodies.add(4, crate().mass(1).ignores(31).build());
        assertThat(last.meetsLayerOf(ghost)).isFalse();
    }

    @Test
    void aFixedBodyTakesNoMomentum() {
        WorldObject rock = bodies.add(1, crate().fixed().velocity(1, 0, 0).build());
        rock.setLinearMomentum(PUSH);
        rock.setAngularMomentum(PUSH);
        rock.setAngularVelocity(PUSH);
        assertThat(rock.linearMomentum()).isEqualTo(Vec3.ZERO);
        assertThat(rock.angularMomentum()).isEqualTo(Vec3.ZERO);
        assertThat(rock.mass()).isZero();
        assertThat(rock.motion().mobility().linear()).isEqualTo(Mat3.diagonal(0, 0, 0));
    }

    @Test
    void aForceReplacesTheOneOfItsNameAndKeepsItsPlace() {
        WorldObject body = bodies.add(1, crate().mass(1).build());
        NamedForce first = NamedForce.direct("first", Frame.WORLD, PUSH);
        NamedForce second = NamedForce.direct("second", Frame.BODY, PUSH);
        NamedForce weaker = NamedForce.direct("first", Frame.WORLD, PUSH.times(0.5));
        body.applyForce(first);
        body.applyForce(second);
        body.applyForce(weaker);
        assertThat(body.forces()).containsExactly(weaker, second);
        assertThat(body.removeForce("first")).isTrue();
        assertThat(body.removeForce("first")).isFalse();
        assertThat(body.forces()).containsExactly(second);
        body.setForces(List.of(first));
        assertThat(body.forces()).containsExactly(first);
    }

    @Test
    void whatIsNotFiniteIsRefusedAndNothingChanges() {
        WorldObject body = bodies.add(1, crate().mass(1).build());
        assertThatIllegalArgumentException()
                .isThrownBy(() -> body.setPosition(new Vec3(1, Double.NaN, 2)))
                .withMessage("position of 'crate' must be finite, but is (1.0, NaN, 2.0)");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> body.setVelocity(new Vec3(Double.POSITIVE_INFINITY, 0, 0)));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> body.setOrientation(new Quat(0, 0, 0, 0)));
        assertThat(body.position()).isEqualTo(Vec3.ZERO);
        assertThat(body.velocity()).isEqualTo(Vec3.ZERO);
        assertThat(body.orientation()).isEqualTo(Quat.IDENTITY);
    }
}
