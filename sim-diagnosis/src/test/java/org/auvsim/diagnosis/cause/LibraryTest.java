package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.effect.PivotFriction;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.Collections;
import java.util.List;

/** Which causes are looked for, of which bodies and in which runs. */
class LibraryTest {
    private static final int SAMPLES = 40;
    private static final BelievedModel VEHICLE = Tank.vehicle();
    private static final BelievedModel STEERED = Tank.steered();
    private static final BelievedModel PENDULUM = Tank.pendulum();

    private static final RigidMotion AT_REST =
            new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

    private static List<Cause> library(BelievedModel model) {
        return Library.of(model, List.of(Tank.run(model, SAMPLES)));
    }

    @Test
    void trimComesFirstOfWhatFloatsAndDragOfWhatFalls() {
        assertThat(library(VEHICLE).getFirst().id()).isEqualTo("buoyancy_weight");
        assertThat(library(PENDULUM).getFirst().id()).isEqualTo("linear_drag");
    }

    @Test
    void aVehicleMayLackAllThatIsListed() {
        assertThat(library(VEHICLE).stream().map(Cause::id).distinct())
                .contains(
                        "linear_drag",
                        "quadratic_drag",
                        "anisotropic_drag",
                        "anisotropic_linear_drag",
                        "rotational_drag",
                        "added_mass",
                        "current_constant",
                        "current_oscillating",
                        "current_shear",
                        "current_vortex",
                        "buoyancy_weight",
                        "cob_offset",
                        "cog_offset",
                        "mass_error",
                        "inertia_error",
                        "thruster_gain",
                        "thruster_deadzone",
                        "thruster_lag",
                        "thruster_advance",
                        "thruster_fade",
                        "thruster_misalignment",
                        "thruster_loss",
                        "magnetic",
                        "magnus",
                        "coulomb_friction",
                        "restitution",
                        "contact_friction",
                        "tether_spring",
                        "wave_forcing",
                        "periodic_force",
                        "step_force",
                        "impulse",
                        "sensor_bias",
                        "sensor_drift",
                        "compass_deviation",
                        "sensor_lever_arm",
                        "sensor_scale",
                        "sensor_delay",
                        "position_delay",
                        "orientation_delay",
                        "clock_offset",
                        "axis_misalignment")
                .doesNotContain("coulomb_torque");
    }

    /** So that no name is refused before runs are read that would not be afterwards. */
    @Test
    void whatCanBeLookedForInRunsIsKnownWithoutThem() {
        for (BelievedModel model : List.of(VEHICLE, STEERED, PENDULUM, Tank.bare())) {
            Library.requireKnown(library(model).stream().map(Cause::name).toList(), model);
        }
        assertThatThrownBy(() -> Library.requireKnown(List.of("thruster_gain"), PENDULUM))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(
                        "no cause 'thruster_gain' is known of '%s'; docs/causes.md has all, and what each of them needs"
                                .formatted(PENDULUM.body()));
        assertThatThrownBy(() -> Library.requireKnown(List.of("linear_drga"), PENDULUM))
                .hasMessageStartingWith(
                        "no cause 'linear_drga' is known of '%s'; did you mean 'linear_drag'? docs/causes.md"
                                .formatted(PENDULUM.body()));
    }

    /** All that are known would be lines of names. */
    @Test
    void ofAnUnknownCauseThoseThatMayBeMeantAreTold() {
        assertThatThrownBy(() -> Library.requireKnown(List.of("drag"), VEHICLE))
                .hasMessage(
                        "no cause 'drag' is known of '%s'; did you mean 'linear_drag' or 'quadratic_drag' or 'anisotropic_drag' or 'anisotropic_linear_drag'? docs/causes.md has all, and what each of them needs"
                                .formatted(VEHICLE.body()));
        assertThatThrownBy(() -> Library.requireKnown(List.of("thruster_gain (prot)"), VEHICLE))
                .hasMessageContaining("; did you mean 'thruster_gain (port)'? docs/");
    }

    @Test
    void causesThatMakeNoSenseAreLeftOut() {
        assertThat(library(PENDULUM).stream().map(Cause::id))
                .contains("coulomb_torque")
                .doesNotContain("coulomb_friction", "thruster_gain", "restitution", "cob_offset")
                .doesNotContain("sensor_bias", "sensor_drift", "cog_offset");
        assertThat(library(Tank.bare()).stream().map(Cause::id))
                .doesNotContain("thruster_lag", "contact_friction");
    }

    /** Within its plane a thruster may point elsewhere; out of it that is a matter of strength. */
    @Test
    void aThrusterOfWhatStaysInAPlaneMayPointElsewhereInIt() {
        BelievedModel planar =
                Tank.model(
                        "",
                        """
                        <held z="1" turn-x="1" turn-y="1"/>
                        <propulsor name="port" maximum-thrust="10" level="0.6"/>
                        """);
        List<Cause> turned =
                library(planar).stream()
                        .filter(cause -> cause.id().equals("thruster_misalignment"))
                        .toList();

        assertThat(turned).hasSize(1);
        assertThat(turned.getFirst().parameters().getFirst().name()).isEqualTo("angle");
    }

    /** A boat has no damping upwards, nor where it cannot roll and pitch; less than none is not. */
    @Test
    void asMuchDragIsTakenAwayAsThereIsWhereAMountLeavesItFree() {
        String damping =
                "<damping><linear x=\"18\" y=\"60\" z=\"0\"/>"
                        + "<angular-linear x=\"0\" y=\"0\" z=\"22\"/></damping>";
        BelievedModel boat = Tank.model("", damping + "<held z=\"1\" turn-x=\"1\" turn-y=\"1\"/>");
        BelievedModel free = Tank.model("", damping);

        assertThat(least("linear_drag", boat)).isCloseTo(-18, within(1e-9));
        assertThat(least("rotational_drag", boat)).isCloseTo(-22, within(1e-9));
        assertThat(least("linear_drag", free)).isZero();
        assertThat(least("rotational_drag", free)).isZero();
    }

    private static double least(String id, BelievedModel of) {
        return library(of).stream()
                .filter(cause -> cause.id().equals(id))
                .mapToDouble(cause -> cause.parameters().getFirst().lowest())
                .findFirst()
                .orElseThrow();
    }

    /** Of a boat whose height is not measured, the scenario knows it. */
    @Test
    void whatActsFromAPlaceIsLookedForWhereWhatHoldsTheBodySaysWhereItIs() {
        List<MeasuredRun> runs = sailing();
        BelievedModel boat = Tank.model("", "<held z=\"1\" turn-x=\"1\" turn-y=\"1\"/>");

        assertThat(Library.of(boat, runs))
                .extracting(Cause::id)
                .contains("magnetic", "tether_spring");
        assertThat(Library.of(Tank.bare(), runs))
                .extracting(Cause::id)
                .doesNotContain("magnetic", "tether_spring");
    }

    /**
     * The source of a magnet beside a plane is at one side or the other: from within, no step
     * shows.
     */
    @Test
    void besideAPathInAPlaneAMagnetBeginsOutOfIt() {
        Cause magnet = cause("magnetic", "<held z=\"1\" turn-x=\"1\" turn-y=\"1\"/>");

        assertThat(magnet.guesses(sailing()))
                .isNotEmpty()
                .allSatisfy(guess -> assertThat(guess.theta().get(2)).isGreaterThan(0.1));
    }

    /** A body that goes along x tells nothing of a wave's direction. */
    @Test
    void wavesOnABodyThatGoesAlongOneAxisHaveNoDirection() {
        String alongX = "<held y=\"1\" turn-x=\"1\" turn-z=\"1\"/>";

        assertThat(cause("wave_forcing", alongX).parameters())
                .extracting(Parameter::name)
                .doesNotContain("direction");
        assertThat(cause("wave_forcing", "<held z=\"1\"/>").parameters())
                .extracting(Parameter::name)
                .contains("direction");
    }

    private static Cause cause(String id, String held) {
        return Library.of(Tank.model("", held), sailing()).stream()
                .filter(cause -> cause.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private static List<MeasuredRun> sailing() {
        MeasuredRunBuilder sailing = MeasuredRun.named("sailing");
        for (int k = 0; k < SAMPLES; k++) {
            sailing.at(k).measured(Channel.POSITION, 0.3 * k, 0.1 * k, Double.NaN);
        }
        return List.of(sailing.build());
    }

    /** What sticks creeps at the rate that the scenario states for it. */
    @Test
    void dryFrictionSlipsAsThatOfTheScenario() {
        BelievedModel creeping =
                Tank.model(
                        "",
                        """
                        <centre-of-mass x="0" y="0" z="-0.5"/>
                        <pinned><axis x="0" y="1" z="0"/></pinned>
                        <gravity/>
                        <pivot-friction viscous="0.1" slip-rate="0.07"/>
                        """);
        Cause friction =
                library(creeping).stream()
                        .filter(cause -> cause.id().equals("coulomb_torque"))
                        .findFirst()
                        .orElseThrow();

        assertThat(friction.in(creeping.variant(), new double[] {2}).body().effect())
                .contains(new PivotFriction(2, 0, 0.07));
    }

    /** A speed that is measured along one axis alone is one, too. */
    @Test
    void whatIsSmallGoesByWhatIsMeasuredOfTheSpeed() {
        MeasuredRunBuilder slow = MeasuredRun.named("slow");
        MeasuredRunBuilder fast = MeasuredRun.named("fast");
        for (int k = 0; k < SAMPLES; k++) {
            slow.at(k).measured(Channel.VELOCITY, Double.NaN, 0.1, Double.NaN);
            fast.at(k).measured(Channel.VELOCITY, Double.NaN, 2, Double.NaN);
        }

        assertThat(raceScale(fast.build())).isCloseTo(20 * raceScale(slow.build()), within(1e-12));
    }

    private static double raceScale(MeasuredRun run) {
        return Library.of(STEERED, List.of(run)).stream()
                .filter(cause -> cause.id().equals("fin_race"))
                .findFirst()
                .orElseThrow()
                .parameters()
                .getFirst()
                .scale();
    }

    /** Elsewhere an offset only says that the body began elsewhere. */
    @Test
    void aZeroCanBeOffAlongAxesInWhichTheStartIsKnown() {
        assertThat(library(VEHICLE)).extracting(Cause::id).doesNotContain("sensor_offset");

        MeasuredRunBuilder dive = MeasuredRun.named("dive");
        for (int k = 0; k < SAMPLES; k++) {
            dive.at(k).measured(Channel.POSITION, Double.NaN, Double.NaN, -0.1 * k);
        }
        dive.start(new KnownStart(AT_REST, Collections.nCopies(RigidMotion.SIZE, 0.02)));

        assertThat(Library.of(VEHICLE, List.of(dive.build())))
                .filteredOn(cause -> cause.id().equals("sensor_offset"))
                .singleElement()
                .satisfies(
                        cause ->
                                assertThat(cause.parameters())
                                        .extracting(Parameter::name)
                                        .containsExactly("offset.z"))
                .satisfies(
                        cause ->
                                assertThat(
                                                cause.in(VEHICLE.variant(), new double[] {0.3})
                                                        .sensing())
                                        .isEqualTo(Sensing.EXACT.shifted(new Vec3(0, 0, 0.3))));
    }

    @Test
    void causesAreChosenByTheirIdsOrWithWhatTheyAreAbout() {
        List<Cause> library = library(VEHICLE);

        assertThat(Library.named(List.of("mass_error", "thruster_gain (port)"), library))
                .extracting(Cause::name)
                .containsExactly("mass_error", "thruster_gain (port)");
        assertThat(Library.named(List.of("thruster_gain"), library)).hasSize(3);
        assertThat(Library.named(List.of("thruster_misalignment (port)"), library))
                .extracting(cause -> cause.parameters().getFirst().name())
                .containsExactly("angle", "tilt");
        assertThat(Library.named(List.of("thruster_misalignment (tilt of port)"), library))
                .extracting(cause -> cause.parameters().getFirst().name())
                .containsExactly("tilt");
        assertThatThrownBy(() -> Library.named(List.of("mess"), library))
                .hasMessage(
                        "no cause 'mess' can be looked for in these runs; docs/causes.md has all,"
                                + " and what each of them needs");
        assertThatThrownBy(() -> Library.named(List.of("mass_error", "mess"), library))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no cause 'mess' can be looked for in these runs");
    }

    @Test
    void noTwoCausesHaveOneLabel() {
        assertThat(library(VEHICLE))
                .extracting(Cause::label)
                .doesNotHaveDuplicates()
                .contains(
                        "thruster_misalignment (angle of port)",
                        "thruster_misalignment (tilt of port)",
                        "thruster_gain (port)");
    }

    /** What one of many must gain by chance alone, one of few must not. */
    @Test
    void theFewerCausesAreLookedForTheLessEachMustGain() {
        List<Cause> library = library(VEHICLE);
        Cause drag = Library.named(List.of("linear_drag"), library).getFirst();
        List<String> all = library.stream().map(Cause::name).toList();

        assertThat(drag.price()).isCloseTo(12 - 2 * Math.log(library.size()), within(1e-12));
        assertThat(drag.price(100, 7))
                .isCloseTo(12 - 2 * Math.log(library.size()) + Math.log(7), within(1e-12));
        assertThat(library.getFirst().price(100, 7))
                .isCloseTo(
                        12 + library.getFirst().parameters().size() * Math.log(100), within(1e-12));
        assertThat(Library.named(all, library))
                .allSatisfy(cause -> assertThat(cause.price()).isEqualTo(12))
                .extracting(Cause::name)
                .isEqualTo(all);
    }

    private static List<String> thrustersInDoubt(String behavior) {
        BelievedModel model =
                Tank.model(
                        "",
                        "<propulsor name='idle' maximum-thrust='20'/>"
                                + "<propulsor name='main' maximum-thrust='20' level='0.5'/>"
                                + behavior);
        return library(model).stream()
                .filter(c -> c.id().equals("thruster_gain"))
                .flatMap(c -> c.subject().stream())
                .toList();
    }

    /** A battery is a behavior, but sets no thruster going. */
    @Test
    void aThrusterThatNothingDirectsHasNoCauses() {
        assertThat(thrustersInDoubt("<battery name='cells' capacity='9' charge='9'/>"))
                .containsExactly("main");
        assertThat(
                        thrustersInDoubt(
                                "<propulsor-schedule name='plan' propulsor='idle'>"
                                        + "<timed-level at='1' level='1'/></propulsor-schedule>"))
                .containsExactly("idle", "main");
    }

    /** The schedule does not act in a run with commands, and these leave the thruster at rest. */
    @Test
    void aThrusterThatIsToldToRestHasNoCauses() {
        BelievedModel model =
                Tank.model(
                        "",
                        "<propulsor name='idle' maximum-thrust='20'/>"
                                + "<propulsor-schedule name='plan' propulsor='idle'>"
                                + "<timed-level at='1' level='1'/></propulsor-schedule>");
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("idle"));
        for (int k = 0; k < SAMPLES; k++) {
            run.at(k).position(k, 0, 0).command(0, 0);
        }

        assertThat(Library.of(model, List.of(run.build())).stream().map(Cause::id))
                .doesNotContain("thruster_gain");
    }

    @Test
    void thrusterCausesAreAboutOneOfThemOrAll() {
        assertThat(
                        library(VEHICLE).stream()
                                .filter(c -> c.id().equals("thruster_gain"))
                                .map(c -> c.subject().orElse("all")))
                .containsExactly("all", "port", "starboard");
    }

    @Test
    void hullsLiftInThePlanesInWhichFinsAct() {
        assertThat(library(STEERED).stream().map(Cause::name))
                .contains(
                        "fin_gain (rudder)",
                        "fin_gain (plane)",
                        "fin_race (rudder)",
                        "fin_race (plane)",
                        "hull_lift (sway and yaw)",
                        "hull_lift (heave and pitch)");
        assertThat(library(VEHICLE).stream().map(Cause::id))
                .doesNotContain("fin_gain", "fin_race", "hull_lift");
    }

    @Test
    void hullsLiftWhereTheScenarioSaysSo() throws Exception {
        BelievedModel glider =
                Believed.model(
                        """
                        <scenario>
                          <world-object name="glider" mass="50">
                            <capsule radius="0.1" length="1.6"/>
                            <hydrodynamic-derivatives>
                              <derivative name="Zuw" value="-110"/>
                              <derivative name="Xuu" value="-3"/>
                            </hydrodynamic-derivatives>
                          </world-object>
                        </scenario>
                        """,
                        "glider");

        assertThat(library(glider).stream().map(Cause::name))
                .contains("hull_lift (heave and pitch)")
                .doesNotContain("hull_lift (sway and yaw)");
    }
}
