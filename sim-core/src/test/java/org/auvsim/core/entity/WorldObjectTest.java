package org.auvsim.core.entity;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.behavior.BackAndForth;
import org.auvsim.core.behavior.PropulsorSchedule;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

class WorldObjectTest {
    private static final Propulsor SCREW =
            new Propulsor("screw", 10, 0.5, Vec3.ZERO, new Vec3(1, 0, 0));
    private static final Component DRIVER = new Driver("driver");

    private final WorldObject object =
            new Bodies()
                    .add(
                            1,
                            WorldObjectDefinition.named("auv")
                                    .volume(new Sphere(1))
                                    .mass(1)
                                    .build());

    private record Driver(String name) implements Component {
        @Override
        public Optional<Need> needs() {
            return Optional.of(Need.of(Propulsor.class));
        }
    }

    @Test
    void componentsAreFoundByTypeAndName() {
        Behavior patrol = new BackAndForth("patrol", 1, 2, new Vec3(1, 0, 0));
        object.add(SCREW);
        object.add(DRIVER);
        object.add(patrol);
        assertThat(object.components()).containsExactly(SCREW, DRIVER, patrol);
        assertThat(object.component(Driver.class)).contains((Driver) DRIVER);
        assertThat(object.component(Propulsor.class, "screw")).contains(SCREW);
        assertThat(object.component(Propulsor.class, "driver")).isEmpty();
        assertThat(object.components(Propulsor.class)).containsExactly(SCREW);
        assertThat(object.behaviors()).containsExactly(patrol);
    }

    @Test
    void aNameIsTakenOnce() {
        object.add(SCREW);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.add(new Driver("screw")))
                .withMessage(
                        "'auv' already has a component 'screw'; remove it or choose another name");
        assertThat(object.components()).containsExactly(SCREW);
    }

    @Test
    void whatAComponentNeedsMustBeThereAndStays() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.add(DRIVER))
                .withMessage("component 'driver' of 'auv' needs a Propulsor; add one");
        object.add(SCREW);
        object.add(DRIVER);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.remove("screw"))
                .withMessage("component 'screw' of 'auv' cannot be removed: 'driver' needs it");
        assertThat(object.components()).containsExactly(SCREW, DRIVER);
        object.remove("driver");
        object.remove("screw");
        assertThat(object.components()).isEmpty();
    }

    @Test
    void aScheduleNeedsThePropulsorThatItNames() {
        Component rudderPlan = new PropulsorSchedule("plan", "rudder", List.of());
        Component screwPlan = new PropulsorSchedule("plan", "screw", List.of());
        String refusal =
                "component 'plan' of 'auv' needs a Propulsor 'rudder', but there are [screw];"
                        + " correct the name or add it";
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                WorldObjectDefinition.named("auv")
                                        .volume(new Sphere(1))
                                        .mass(1)
                                        .component(rudderPlan)
                                        .component(SCREW)
                                        .build())
                .withMessage(refusal);
        object.add(SCREW);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.add(rudderPlan))
                .withMessage(refusal);
        object.add(screwPlan);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.replace(rudderPlan))
                .withMessage(refusal);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.remove("screw"))
                .withMessage("component 'screw' of 'auv' cannot be removed: 'plan' needs it");
        assertThat(object.components()).containsExactly(SCREW, screwPlan);
    }

    @Test
    void aReplacedComponentKeepsItsPlace() {
        object.add(SCREW);
        object.add(DRIVER);
        object.command(Propulsor.class, "screw", -1);
        assertThat(object.components()).containsExactly(SCREW.commanded(-1, 0), DRIVER);
        assertThat(object.components(Propulsor.class)).containsExactly(SCREW.commanded(-1, 0));
    }

    @Test
    void aComponentIsReplacedByItsOwnKindAlone() {
        object.add(SCREW);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.replace(new Driver("screw")))
                .withMessage(
                        "component 'screw' of 'auv' is a Propulsor and cannot become a Driver;"
                                + " remove it first");
        assertThat(object.components()).containsExactly(SCREW);
    }

    @Test
    void whatIsNotThereIsNamedBesideWhatIs() {
        object.add(SCREW);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.remove("rudder"))
                .withMessage("'auv' has no component 'rudder'; it has [screw]");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.command(Propulsor.class, "rudder", 1))
                .withMessage("'auv' has no propulsor 'rudder'; it has [screw]");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> object.command(Propulsor.class, "screw", 1.5))
                .withMessage("the level of propulsor 'screw' must be -1 to 1, but is 1.5");
        assertThat(object.components()).containsExactly(SCREW);
    }
}
