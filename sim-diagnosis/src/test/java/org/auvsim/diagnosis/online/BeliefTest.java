package org.auvsim.diagnosis.online;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Battery;
import org.auvsim.core.actuator.PowerDraw;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.behavior.GoToPoint;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.core.effect.Tether;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What a running world gets when it is learned, and when the same is learned again from more. */
class BeliefTest {
    private static final double DRAG = 7;

    private final World world =
            World.builder()
                    .add(
                            WorldObjectDefinition.named("body")
                                    .volume(new Sphere(0.2))
                                    .mass(10)
                                    .build())
                    .build();
    private Belief belief = Belief.of(world, 1);

    private void learn(Vec3 current, double drag) {
        learn("current_constant", new double[] {current.x(), current.y(), current.z()}, drag);
    }

    /**
     * The world gets what a diagnosis of it would have found.
     *
     * @return the currents as they were found
     */
    private List<Current> learn(String current, double[] theta, double drag) {
        BelievedModel model = belief.under(List.of());
        Variant found = model.variant().with(body -> body.effect(new IsotropicDrag(0, drag, 0)));
        Cause flow =
                Library.of(model, List.of(run())).stream()
                        .filter(cause -> cause.id().equals(current))
                        .findFirst()
                        .orElseThrow();
        found = flow.in(found, theta);
        Belief next = belief.learning(model, model.extended(found));
        belief.changes(next).forEach(new ObedientWorld(world)::carryOut);
        belief = next;
        return found.currents();
    }

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < 40; k++) {
            run.at(0.1 * k).position(0.1 * k, Math.sin(k), 0);
        }
        return run.build();
    }

    private List<Effect> drags() {
        return world.object(1).effects();
    }

    @Test
    void theWorldGetsTheCurrentAndTheObjectItsDrag() {
        learn(new Vec3(0.1, 0.2, 0), DRAG);

        assertThat(drags()).containsExactly(new IsotropicDrag(0, DRAG, 0));
        assertThat(velocities()).containsExactly(new Vec3(0.1, 0.2, 0));
    }

    @Test
    void whatIsLearnedAgainTakesThePlaceOfWhatWasLearned() {
        learn(new Vec3(0.1, 0.2, 0), DRAG);
        learn(new Vec3(0.11, 0.19, 0), DRAG + 1);
        learn(new Vec3(0.12, 0.18, 0), DRAG + 2);

        assertThat(drags()).containsExactly(new IsotropicDrag(0, DRAG + 2, 0));
        assertThat(velocities()).containsExactly(new Vec3(0.12, 0.18, 0));
    }

    @Test
    void whatIsDiagnosedDoesNotGrow() {
        BelievedModel before = belief.under(List.of());

        learn(new Vec3(0.1, 0.2, 0), DRAG);
        learn(new Vec3(0.11, 0.19, 0), DRAG + 1);

        assertThat(belief.under(List.of())).isEqualTo(before);
    }

    @ParameterizedTest
    @CsvSource({
        "current_constant, 3",
        "current_oscillating, 7",
        "current_shear, 2",
        "current_vortex, 4"
    })
    void eachKindOfCurrentIsLearnedAgain(String kind, int numbers) {
        double[] theta = new double[numbers];
        for (double number : new double[] {0.1, 0.2, 0.3}) {
            Arrays.fill(theta, number);
            List<Current> found = learn(kind, theta, DRAG);

            assertThat(world.fields())
                    .usingRecursiveFieldByFieldElementComparatorIgnoringFields("id")
                    .isEqualTo(found);
        }
    }

    private static Propulsor drawing(String battery) {
        return new Propulsor(
                "screw",
                5,
                0,
                Vec3.ZERO,
                new Vec3(1, 0, 0),
                Optional.empty(),
                0,
                0,
                0,
                0,
                Optional.empty(),
                Optional.of(new PowerDraw(battery, 20, 0, true)),
                Optional.empty(),
                Optional.empty());
    }

    /** Its behavior does not act in diagnoses, and stays in the world when something is learned. */
    @Test
    void aVehicleThatDrawsFromABatteryLearnsToo() {
        Battery cells = new Battery("cells", 9e6, 9e6);
        GoToPoint home = new GoToPoint("home", 1, 0.1, Vec3.ZERO);
        world.object(1).add(cells);
        world.object(1).add(drawing("cells"));
        world.object(1).add(home);
        belief = Belief.of(world, 1);
        assertThat(belief.first().variant().body().component())
                .contains(cells)
                .doesNotContain(home);

        learn(Vec3.ZERO, DRAG);

        assertThat(drags()).containsExactly(new IsotropicDrag(0, DRAG, 0));
        assertThat(world.object(1).components()).contains(cells, home);
    }

    @Test
    void itMovesOnAsItDid() {
        world.object(1).setVelocity(new Vec3(1, 0, 0));

        learn(Vec3.ZERO, DRAG);

        assertThat(world.object(1).velocity().distance(new Vec3(1, 0, 0)))
                .isCloseTo(0, within(1e-12));
    }

    @Test
    void aBodyOnAFloorIsBelievedToRestThere() {
        World yard =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("floor")
                                        .volume(new HalfSpace())
                                        .fixed()
                                        .build())
                        .add(ball("rover", 0))
                        .add(ball("other", 1))
                        .build();

        BelievedModel model = Belief.of(yard, 2).under(List.of());

        assertThat(model.leftOut()).containsExactly("other");
        RigidMotion[] motion =
                Ensemble.simulate(
                        model, run(), 0, 39, List.of(new Entrant(model.variant(), model.start())))[
                        0];
        assertThat(motion[39].position().z()).isCloseTo(0.2, within(1e-3));
    }

    @Test
    void ofABodyThatIsTowedNothingCanBeLearned() {
        World towing =
                World.builder()
                        .add(ball("tug", 0))
                        .add(
                                ball("barge", 1).toBuilder()
                                        .effect(new Tether(1, Vec3.ZERO, Vec3.ZERO, 1, 5, 0))
                                        .build())
                        .build();

        assertThat(Belief.of(towing, 1).first().tie()).isPresent();
        assertThat(Belief.of(towing, 2).first().tie()).isPresent();
        assertThat(belief.first().tie()).isEmpty();
    }

    private static WorldObjectDefinition ball(String name, double x) {
        return WorldObjectDefinition.named(name)
                .volume(new Sphere(0.2))
                .mass(10)
                .position(x, 0, 0.2)
                .effect(new Gravity(9.80665))
                .build();
    }

    private List<Vec3> velocities() {
        return world.fields().stream()
                .map(UniformCurrent.class::cast)
                .map(UniformCurrent::velocity)
                .toList();
    }
}
