package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.communication.AcousticModem;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.CompassReading;
import org.auvsim.core.sensor.DepthReading;
import org.auvsim.core.sensor.DvlReading;
import org.auvsim.core.sensor.DvlReference;
import org.auvsim.core.sensor.GpsReading;
import org.auvsim.core.sensor.ImuReading;
import org.auvsim.core.sensor.RangeReading;
import org.auvsim.core.sensor.ThermometerReading;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The shipped scenarios do what their comments say. */
class ExampleScenariosTest {
    private static World world(String name) throws DocumentException {
        Path file = CommandLineHarness.EXAMPLES.resolve("scenarios").resolve(name);
        return ScenarioLoader.load(ExampleScenariosTest.class.getClassLoader()).load(file).world();
    }

    private static void run(World world, double until) {
        while (world.time() < until - 1e-9) {
            world.advanceTimestep();
        }
    }

    @Test
    void theTankKeepsEverythingInside() throws DocumentException {
        World world = world("tank.xml");
        Set<Long> collided = new HashSet<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.Collided hit) {
                        collided.add(hit.collision().contact().self().id());
                        collided.add(hit.collision().contact().other().id());
                    }
                });
        run(world, 60);

        assertThat(collided).hasSizeGreaterThan(5);
        for (WorldObject object : world.objects()) {
            if (!object.isFixed()) {
                Vec3 p = object.position();
                assertThat(Math.abs(p.x())).as(object.name()).isLessThan(10);
                assertThat(Math.abs(p.y())).as(object.name()).isLessThan(5);
                assertThat(p.z()).as(object.name()).isBetween(-5.0, 0.0);
            }
        }
    }

    @Test
    void thrustersThatDifferTurnTheAuvAndEqualOnesDoNot() throws DocumentException {
        World straight = world("tank.xml");
        straight.object("AUV-1701").command(Propulsor.class, "Port Thruster", 0.5);
        straight.object("AUV-1701").command(Propulsor.class, "Starboard Thruster", 0.5);
        run(straight, 2);
        assertThat(straight.object("AUV-1701").position().x()).isGreaterThan(-5.5);
        assertThat(straight.object("AUV-1701").angularVelocity().norm()).isZero();

        World turning = world("tank.xml");
        turning.object("AUV-1701").command(Propulsor.class, "Starboard Thruster", 0.5);
        run(turning, 2);
        assertThat(turning.object("AUV-1701").angularVelocity().z()).isGreaterThan(0.1);

        World rising = world("tank.xml");
        rising.object("AUV-1701").command(Propulsor.class, "Ventral Thruster", 0.5);
        run(rising, 2);
        assertThat(rising.object("AUV-1701").position().z()).isGreaterThan(-1.9);
    }

    @Test
    void backAndForthGoesFartherOverTime() throws DocumentException {
        World world = world("back-and-forth.xml");
        double early = 0;
        double late = 0;
        while (world.time() < 1000) {
            world.advanceTimestep();
            double out = Math.abs(world.object(1).position().y());
            early = world.time() < 10 ? Math.max(early, out) : early;
            late = world.time() > 950 ? Math.max(late, out) : late;
        }
        assertThat(early).isCloseTo(2.5, within(0.1));
        assertThat(late).isCloseTo(23.4, within(0.5));
    }

    @Test
    void crossingSpheresMeetWhereFigure51HasThem() throws DocumentException {
        World world = world("crossing.xml");
        assertThat(world.advanceTimestep()).isCloseTo((1 - Math.sqrt(0.5)) / 2, within(1e-9));
        assertThat(world.object("A").position().distance(world.object("B").position()))
                .isCloseTo(1, within(1e-9));
    }

    @Test
    void theSwarmMeetsAtItsTargets() throws DocumentException {
        World world = world("swarm.xml");
        int[] collisions = {0};
        world.addListener(event -> collisions[0] += event instanceof WorldEvent.Collided ? 1 : 0);
        run(world, 40);
        assertThat(world.objects()).hasSize(27);
        assertThat(collisions[0]).isGreaterThan(20);
        assertThat(world.objects().stream().mapToDouble(o -> o.velocity().norm()).max().orElse(0))
                .isGreaterThan(1);
    }

    @Test
    void aDrifterEndsUpWithTheWater() throws DocumentException {
        World world = world("drift.xml");
        run(world, 40);
        assertThat(world.object("Drifter").velocity().distance(new Vec3(0.3, 0.1, 0)))
                .isLessThan(1e-9);
        assertThat(world.object("Sinking Chest").position().z()).isLessThan(-2.5);
        assertThat(world.object("Surveyor").orientation().z()).isGreaterThan(0.1);
    }

    @Test
    void theStackStands() throws DocumentException {
        World world = world("stack.xml");
        run(world, 10);
        for (int k = 1; k <= 10; k++) {
            Vec3 place = new Vec3(0, 0, k - 0.5);
            assertThat(world.object("Box " + k).position().distance(place)).isLessThan(1e-3);
        }
    }

    @Test
    void frictionHoldsOneCrateAndLetsTheOtherSlide() throws DocumentException {
        World world = world("slope.xml");
        Vec3 rough = world.object("Rough Crate").position();
        Vec3 smooth = world.object("Smooth Crate").position();
        run(world, 2);
        double angle = Math.toRadians(20);
        double way = 9.80665 * (Math.sin(angle) - 0.2 * Math.cos(angle)) * 2 * 2 / 2;
        assertThat(world.object("Rough Crate").position().distance(rough)).isLessThan(1e-3);
        assertThat(world.object("Smooth Crate").position().distance(smooth))
                .isCloseTo(way, within(0.01));
    }

    @Test
    void whatSinksComesToRestOnTheSeabed() throws DocumentException {
        World world = world("seabed.xml");
        run(world, 12);
        for (String rock : List.of("Boulder", "Slab")) {
            assertThat(world.object(rock).velocity().norm()).isLessThan(0.01);
            assertThat(world.object(rock).position().z()).isBetween(-20.0, -18.0);
        }
        assertThat(world.object("Surveyor").position().x()).isGreaterThan(-4);
        assertThat(world.object("Surveyor").position().z()).isBetween(-20.0, -10.0);
    }

    private static List<WorldEvent.SensorRead> readings(World world, double until) {
        List<WorldEvent.SensorRead> heard = new ArrayList<>();
        WorldListener listener =
                event -> {
                    if (event instanceof WorldEvent.SensorRead read) {
                        heard.add(read);
                    }
                };
        world.addListener(listener);
        run(world, until);
        world.removeListener(listener);
        return heard;
    }

    private static <R> R last(List<WorldEvent.SensorRead> heard, long object, Class<R> kind) {
        return heard.reversed().stream()
                .filter(read -> read.objectId() == object)
                .map(WorldEvent.SensorRead::reading)
                .filter(kind::isInstance)
                .map(kind::cast)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void theSurveyorsSensorsTellWhatItDoes() throws DocumentException {
        World world = world("survey.xml");
        List<WorldEvent.SensorRead> heard = readings(world, 30);

        Vec3 place = world.object("Surveyor").position();
        DvlReading log = last(heard, 1, DvlReading.class);
        assertThat(log.reference()).isEqualTo(DvlReference.BOTTOM);
        assertThat(log.velocity().x()).isCloseTo(1.2, within(0.06));
        assertThat(log.altitude().orElseThrow()).isCloseTo(8, within(0.25));
        assertThat(last(heard, 1, DepthReading.class).depth()).isCloseTo(12.03, within(0.05));
        assertThat(last(heard, 1, CompassReading.class).heading())
                .isCloseTo(Math.PI / 2 - 0.23, within(0.05));
        assertThat(last(heard, 1, ImuReading.class).specificForce().z())
                .isCloseTo(9.80665, within(0.03));
        assertThat(last(heard, 1, ThermometerReading.class).temperature()).isBetween(14.0, 16.0);
        // the sonar is 0.9 m ahead of the origin, the wreck begins at 60 m; the last ping is 0.5 s
        // old
        RangeReading ahead = last(heard, 1, RangeReading.class);
        assertThat(ahead.echo()).hasSize(5);
        assertThat(ahead.echo().get(2).distance()).isCloseTo(60 - 0.9 - place.x(), within(0.9));
        assertThat(heard).noneMatch(r -> r.objectId() == 1 && r.reading() instanceof GpsReading);
        GpsReading buoy = last(heard, 2, GpsReading.class);
        assertThat(buoy.latitude()).isCloseTo(36.6 + 30 / 111_000.0, within(1e-4));
        assertThat(buoy.longitude()).isCloseTo(-121.9 + 20 / 89_500.0, within(1e-4));
    }

    @Test
    void theBuoyHearsTheSurveyor() throws DocumentException {
        World world = world("survey.xml");
        List<WorldEvent.SignalReceived> heard = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.SignalReceived received) {
                        heard.add(received);
                    }
                });
        for (int i = 0; i < 20; i++) {
            world.transmit(1, AcousticModem.class, "Modem", "fix " + i);
            run(world, world.time() + 0.1);
        }

        assertThat(heard).hasSizeBetween(12, 20);
        double distance = Math.sqrt(20 * 20 + 30 * 30 + 12 * 12);
        assertThat(heard.getFirst().time()).isCloseTo((distance - 0.3) / 1500, within(1e-3));
    }
}
