package org.auvsim.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.cli.vehicle.Vehicles.advanceTo;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The scenarios with the published vehicles. */
class VehicleScenariosTest {
    private static World world(String scenario) throws Exception {
        return Vehicles.scenario("../scenarios/" + scenario).world();
    }

    @ParameterizedTest
    @CsvSource({"remus100.xml, remus-turn.xml", "bluerov2-heavy.xml, bluerov2-dive.xml"})
    void haveTheNumbersOfTheVehicle(String vehicle, String scenario) throws Exception {
        WorldObjectDefinition there = Vehicles.scenario(vehicle).worldObject().getFirst();
        WorldObjectDefinition here =
                Vehicles.scenario("../scenarios/" + scenario).worldObject().getFirst();

        assertThat(here)
                .usingRecursiveComparison()
                .ignoringFields("mount", "component")
                .isEqualTo(there);
        assertThat(here.component())
                .filteredOn(component -> !(component instanceof Behavior))
                .isEqualTo(there.component());
    }

    @Test
    void theTorpedoTurnsToPortAndThenToStarboard() throws Exception {
        World world = world("remus-turn.xml");
        WorldObject torpedo = world.objects().getFirst();
        advanceTo(world, 60);
        assertThat(Math.toDegrees(torpedo.angularVelocity().z())).isCloseTo(9.27, within(0.1));
        advanceTo(world, 120);
        assertThat(Math.toDegrees(torpedo.angularVelocity().z())).isCloseTo(-9.27, within(0.1));
        assertThat(torpedo.position().z()).isEqualTo(-20);
    }

    /** Its horizontal thrusters push below its centre of mass, which lifts the bow. */
    @Test
    void theRovTurnsOverBackwardByItsHorizontalThrustersAlone() throws Exception {
        World world = Vehicles.scenario("bluerov2-heavy.xml").world();
        WorldObject rov = world.objects().getFirst();
        for (Propulsor propulsor : rov.components(Propulsor.class)) {
            rov.command(Propulsor.class, propulsor.name(), Math.signum(propulsor.direction().x()));
        }
        double highest = 0;
        Vec3 up = new Vec3(0, 0, 1);
        while (world.time() < 5 && up.z() > -0.9) {
            world.advanceTimestep();
            highest = Math.max(highest, rov.orientation().rotate(new Vec3(1, 0, 0)).z());
            up = rov.orientation().rotate(new Vec3(0, 0, 1));
        }
        assertThat(highest).as("the bow went over the top").isGreaterThan(0.9);
        assertThat(up.z()).isLessThan(-0.9);
    }

    @Test
    void theRovDivesGoesAheadTurnsAndComesUp() throws Exception {
        World world = world("bluerov2-dive.xml");
        WorldObject rov = world.objects().getFirst();
        advanceTo(world, 15);
        assertThat(rov.position().z()).isLessThan(-5);
        assertThat(rov.position().x()).isCloseTo(0, within(1e-9));
        advanceTo(world, 27);
        assertThat(rov.position().x()).isGreaterThan(3);
        assertThat(rov.position().z()).isCloseTo(-5.1, within(0.1));
        advanceTo(world, 36);
        assertThat(rov.angularVelocity().z()).isPositive();
        advanceTo(world, 60);
        assertThat(rov.position().z()).isGreaterThan(-3);
    }
}
