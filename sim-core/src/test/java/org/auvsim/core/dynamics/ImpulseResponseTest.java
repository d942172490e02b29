package org.auvsim.core.dynamics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Contact;
import org.auvsim.core.entity.Participant;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.ContactPoint;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Optional;

class ImpulseResponseTest {
    private static final Sphere BALL = new Sphere(0.5);

    private final Bodies bodies = new Bodies();

    private static WorldObjectDefinition.Builder body(String name, Volume volume, double mass) {
        return WorldObjectDefinition.named(name).volume(volume).mass(mass);
    }

    private WorldObject add(WorldObjectDefinition.Builder definition) {
        return bodies.add(bodies.count() + 1, definition.build());
    }

    private static Contact contact(WorldObject a, WorldObject b) {
        ContactPoint where =
                PairQueries.standard().contact(a.volume(), pose(a), b.volume(), pose(b));
        return new Contact(0, where.point(), where.normal(), participant(a), participant(b));
    }

    private static Pose pose(WorldObject object) {
        return Pose.of(object.position(), object.orientation());
    }

    private static Participant participant(WorldObject object) {
        return new Participant(
                object.id(), object.name(), WorldObject.class, Optional.of(object.motion()));
    }

    private static void collide(WorldObject a, WorldObject b) {
        Contact contact = contact(a, b);
        List<Change> ofA = new ImpulseResponse().respond(contact);
        List<Change> ofB = new ImpulseResponse().respond(contact.flipped());
        apply(ofA, a);
        apply(ofB, b);
    }

    private static void apply(List<Change> changes, WorldObject object) {
        for (Change change : changes) {
            Change.Momentum momentum = (Change.Momentum) change;
            assertThat(momentum.objectId()).isEqualTo(object.id());
            object.setLinearMomentum(object.linearMomentum().plus(momentum.linear()));
            object.setAngularMomentum(object.angularMomentum().plus(momentum.angular()));
        }
    }

    private static double energy(WorldObject object) {
        return (object.linearMomentum().dot(object.velocity())
                        + object.angularMomentum().dot(object.angularVelocity()))
                / 2;
    }

    private Vec3 totalMomentum() {
        return bodies.objects().stream()
                .map(WorldObject::linearMomentum)
                .reduce(Vec3.ZERO, Vec3::plus);
    }

    private Vec3 totalAngularMomentum() {
        return bodies.objects().stream()
                .map(o -> o.angularMomentum().plus(o.position().cross(o.linearMomentum())))
                .reduce(Vec3.ZERO, Vec3::plus);
    }

    private double totalEnergy() {
        return bodies.objects().stream().mapToDouble(ImpulseResponseTest::energy).sum();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void aBoxHitOffItsCentreKeepsMomentaAndEnergy(long seed) {
        Draws draws = new Draws(seed);
        WorldObject box =
                add(
                        body("box", new Box(new Vec3(2, 3, 1)), 5)
                                .orientation(draws.orientation())
                                .angularVelocity(0.3, -0.2, 0.5));
        Vec3 offCentre = box.orientation().rotate(new Vec3(0.7, 1.1, 0.95));
        Vec3 inward = box.orientation().rotate(new Vec3(0.4, -0.3, -4));
        WorldObject ball =
                add(
                        body("ball", BALL, 2)
                                .position(offCentre)
                                .velocity(inward.x(), inward.y(), inward.z()));
        Vec3 momentum = totalMomentum();
        Vec3 angularMomentum = totalAngularMomentum();
        double energy = totalEnergy();
        double approach = contact(ball, box).separationSpeed();
        collide(ball, box);
        assertNear(totalMomentum(), momentum, 1e-13);
        assertNear(totalAngularMomentum(), angularMomentum, 1e-13);
        assertThat(totalEnergy()).isCloseTo(energy, within(1e-12 * energy));
        assertThat(contact(ball, box).separationSpeed()).isCloseTo(-approach, within(1e-13));
        assertThat(box.angularMomentum().norm()).isGreaterThan(1);
    }

    @Test
    void twoBallsHeadOnExchangeAsTheClosedFormSays() {
        WorldObject a = add(body("a", BALL, 3).position(1, 0, 0).velocity(-2, 0, 0));
        WorldObject b = add(body("b", BALL, 1).velocity(4, 1, 0));
        collide(a, b);
        // v_a' = ((m_a - m_b) v_a + 2 m_b v_b) / (m_a + m_b), and so for b.
        assertNear(a.velocity(), new Vec3((2 * -2 + 2 * 4) / 4.0, 0, 0), 1e-14);
        assertNear(b.velocity(), new Vec3((-2 * 4 + 6 * -2) / 4.0, 1, 0), 1e-14);
    }

    @ParameterizedTest(name = "restitution {0}")
    @ValueSource(doubles = {0, 0.25, 0.5, 1})
    void theSmallerRestitutionIsTheShareOfSpeedThatIsLeft(double restitution) {
        WorldObject a = add(body("a", BALL, 3).position(1, 0, 0).velocity(-2, 0, 0).restitution(1));
        WorldObject b = add(body("b", BALL, 1).velocity(4, 0, 0).restitution(restitution));
        collide(a, b);
        assertThat(a.velocity().x() - b.velocity().x()).isCloseTo(6 * restitution, within(1e-14));
        assertNear(totalMomentum(), new Vec3(-2, 0, 0), 1e-14);
    }

    @Test
    void bodiesThatPartGetNothing() {
        WorldObject a = add(body("a", BALL, 3).position(1, 0, 0).velocity(2, 0, 0));
        WorldObject b = add(body("b", BALL, 1).velocity(1, 0, 0));
        assertThat(new ImpulseResponse().respond(contact(a, b))).isEmpty();
        a.setVelocity(new Vec3(1, 5, 0));
        assertThat(new ImpulseResponse().respond(contact(a, b))).isEmpty();
    }

    @Test
    void aFixedBodyThrowsEverythingBack() {
        WorldObject wall =
                add(WorldObjectDefinition.named("wall").volume(new Box(new Vec3(1, 9, 9))).fixed());
        WorldObject ball = add(body("ball", BALL, 2).position(1, 3, 0).velocity(-4, 1, 0));
        collide(ball, wall);
        assertNear(ball.velocity(), new Vec3(4, 1, 0), 1e-14);
        assertNear(wall.linearMomentum(), Vec3.ZERO, 0);
        assertNear(wall.velocity(), Vec3.ZERO, 0);
    }

    @Test
    void fixedBodiesGiveEachOtherNothing() {
        WorldObject a = add(WorldObjectDefinition.named("a").volume(BALL).fixed());
        WorldObject b = add(WorldObjectDefinition.named("b").volume(BALL).fixed());
        assertThat(new ImpulseResponse().respond(contact(a, b))).isEmpty();
    }

    @Test
    void whatIsNoBodyIsNotAnswered() {
        WorldObject ball = add(body("ball", BALL, 2).velocity(-4, 1, 0));
        Participant wave = new Participant(9, "wave", WorldObject.class, Optional.empty());
        Contact contact = new Contact(0, Vec3.ZERO, new Vec3(1, 0, 0), participant(ball), wave);
        assertThat(new ImpulseResponse().respond(contact)).isEmpty();
        assertThat(new ImpulseResponse().respond(contact.flipped())).isEmpty();
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void frictionKeepsMomentaStaysInItsConeAndTakesEnergy(long seed) {
        Draws draws = new Draws(seed);
        WorldObject box =
                add(
                        body("box", new Box(new Vec3(2, 3, 1)), 5)
                                .orientation(draws.orientation())
                                .angularVelocity(0.3, -0.2, 0.5)
                                .friction(0.8));
        Vec3 offCentre = box.orientation().rotate(new Vec3(0.7, 1.1, 0.95));
        Vec3 inward = box.orientation().rotate(new Vec3(draws.number(-5, 5), -0.3, -4));
        WorldObject ball =
                add(
                        body("ball", BALL, 2)
                                .position(offCentre)
                                .velocity(inward.x(), inward.y(), inward.z())
                                .friction(0.2));
        Vec3 momentum = totalMomentum();
        Vec3 angularMomentum = totalAngularMomentum();
        double energy = totalEnergy();
        Contact contact = contact(ball, box);
        Change.Momentum ofBall = half(contact);
        Change.Momentum ofBox = half(contact.flipped());
        assertThat(ofBox.linear()).isEqualTo(ofBall.linear().negated());
        double normal = ofBall.linear().dot(contact.normal());
        Vec3 across = ofBall.linear().minus(contact.normal().times(normal));
        assertThat(across.norm()).isPositive().isLessThanOrEqualTo(0.4 * normal * (1 + 1e-12));
        apply(List.of(ofBall), ball);
        apply(List.of(ofBox), box);
        assertNear(totalMomentum(), momentum, 1e-13);
        assertNear(totalAngularMomentum(), angularMomentum, 1e-13);
        assertThat(totalEnergy()).isLessThan(energy);
        assertThat(contact(ball, box).separationSpeed())
                .isCloseTo(-contact.separationSpeed(), within(1e-9));
    }

    private static Change.Momentum half(Contact contact) {
        return (Change.Momentum) new ImpulseResponse().respond(contact).getFirst();
    }

    /** Rolls off with 5/7 of the speed if it grips (mu >= 2 vx / (7 (1 + e) vn)), else slides. */
    @ParameterizedTest(name = "friction {0}: {1} m/s")
    @CsvSource({"1, 2.142857142857143", "0.0225, 2.82", "0, 3"})
    void aBallThatHitsTheFloorAslantGripsOrSlides(double friction, double expected) {
        WorldObject floor =
                add(
                        WorldObjectDefinition.named("floor")
                                .volume(new Box(new Vec3(9, 9, 1)))
                                .fixed()
                                .friction(friction));
        WorldObject ball =
                add(body("ball", BALL, 2).position(0, 0, 1).velocity(3, 0, -4).friction(friction));
        collide(ball, floor);
        assertThat(ball.velocity().x()).isCloseTo(expected, within(1e-9));
        assertThat(ball.velocity().z()).isCloseTo(4, within(1e-9));
        // No torque about the contact point: I w = r x P.
        assertThat(0.4 * 2 * 0.25 * ball.angularVelocity().y())
                .isCloseTo(-0.5 * 2 * (ball.velocity().x() - 3), within(1e-9));
    }
}
