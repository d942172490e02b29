package org.auvsim.cli.vehicle;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Mount;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** The published vehicles of the examples, in trials of a test's choice. */
final class Vehicles {
    private static final Path FOLDER = Path.of("..", "examples", "vehicles");

    private Vehicles() {}

    static Scenario scenario(String file) throws Exception {
        return ScenarioLoader.load(Vehicles.class.getClassLoader()).load(FOLDER.resolve(file));
    }

    static WorldObjectDefinition remus() throws Exception {
        return scenario("remus100.xml").worldObject().getFirst();
    }

    /** A trial under way at a speed (m/s), its fins at angles (rad), without its schedules. */
    static World trial(
            WorldObjectDefinition vehicle,
            Optional<Mount> mount,
            double speed,
            ToDoubleFunction<Fin> angles) {
        WorldObjectDefinition.Builder body =
                WorldObjectDefinition.named(vehicle.name())
                        .mass(vehicle.mass().orElseThrow())
                        .volume(vehicle.volume())
                        .inertia(vehicle.inertia().orElseThrow())
                        .centreOfMass(vehicle.centreOfMass().orElse(Vec3.ZERO))
                        .addedMass(vehicle.addedMass().orElseThrow())
                        .position(0, 0, -100)
                        .velocity(speed, 0, 0);
        mount.ifPresent(body::mount);
        vehicle.effect().forEach(body::effect);
        for (Component component : vehicle.component()) {
            if (component instanceof Fin fin) {
                body.component(fin.commanded(angles.applyAsDouble(fin), 0));
            } else if (!(component instanceof Behavior)) {
                body.component(component);
            }
        }
        return World.builder().timeStep(0.02).add(body.build()).build();
    }

    static void advanceTo(World world, double time) {
        while (world.time() < time - 1e-9) {
            world.advanceTimestep();
        }
    }
}
