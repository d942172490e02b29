package org.auvsim.experiments.hidden;

import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.function.Predicate;

/** All that can be hidden. */
final class Effects {
    /** One kind of effect, and the scenes that it fits. */
    record Kind(Predicate<Scene> fits, BiFunction<Scene, Draws, Family> family) {}

    /** Those of the library of causes, by their id there. */
    static final SortedMap<String, Kind> LIBRARY = library();

    /** Those outside of it. */
    static final List<Kind> UNCOVERED =
            List.of(
                    new Kind(Effects::any, UncoveredEffects::slosh),
                    new Kind(Effects::any, UncoveredEffects::kicks),
                    new Kind(Effects::any, UncoveredEffects::chaos),
                    new Kind(Effects::afloat, UncoveredEffects::wake));

    private Effects() {}

    private static SortedMap<String, Kind> library() {
        SortedMap<String, Kind> all = new TreeMap<>();
        all.put("linear_drag", new Kind(Effects::any, PlantEffects::linearDrag));
        all.put("quadratic_drag", new Kind(Effects::any, PlantEffects::quadraticDrag));
        all.put("anisotropic_drag", new Kind(Scene::shows, PlantEffects::anisotropicDrag));
        all.put("rotational_drag", new Kind(Scene::shows, PlantEffects::rotationalDrag));
        all.put("added_mass", new Kind(Effects::showsAfloat, PlantEffects::addedMass));
        all.put("cob_offset", new Kind(Effects::showsAfloat, PlantEffects::cobOffset));
        all.put("mass_error", new Kind(scene -> !scene.falls(), PlantEffects::mass));
        all.put("inertia_error", new Kind(Scene::shows, PlantEffects::inertia));
        all.put("current_constant", new Kind(Effects::any, WaterEffects::constant));
        all.put("current_oscillating", new Kind(Effects::any, WaterEffects::oscillating));
        all.put("current_shear", new Kind(Effects::any, WaterEffects::shear));
        all.put("current_vortex", new Kind(Effects::afloat, WaterEffects::vortex));
        all.put("buoyancy_weight", new Kind(Effects::any, ForceEffects::buoyancyWeight));
        all.put("coulomb_friction", new Kind(Effects::any, ForceEffects::coulombFriction));
        all.put("magnetic", new Kind(Effects::any, ForceEffects::magnetic));
        all.put("magnus", new Kind(Effects::any, ForceEffects::magnus));
        all.put("tether_spring", new Kind(Effects::any, ForceEffects::tether));
        all.put("wave_forcing", new Kind(Effects::any, ForceEffects::wave));
        all.put("periodic_force", new Kind(Effects::any, ForceEffects::periodic));
        all.put("step_force", new Kind(Effects::any, ForceEffects::step));
        all.put("impulse", new Kind(Effects::any, ForceEffects::impulse));
        all.put("thruster_gain", new Kind(Effects::driven, ThrusterEffects::gain));
        all.put("thruster_deadzone", new Kind(Effects::driven, ThrusterEffects::deadZone));
        all.put("thruster_lag", new Kind(Effects::driven, ThrusterEffects::lag));
        all.put("thruster_misalignment", new Kind(Effects::driven, ThrusterEffects::misalignment));
        all.put("thruster_loss", new Kind(Effects::driven, ThrusterEffects::loss));
        all.put("sensor_bias", new Kind(Scene::shows, SensorEffects::yawBias));
        all.put("sensor_drift", new Kind(Scene::shows, SensorEffects::yawDrift));
        all.put("sensor_scale", new Kind(Effects::any, SensorEffects::scale));
        all.put("sensor_delay", new Kind(Effects::any, SensorEffects::delay));
        all.put("axis_misalignment", new Kind(Effects::any, SensorEffects::axisMisalignment));
        return all;
    }

    private static boolean any(Scene scene) {
        return true;
    }

    private static boolean afloat(Scene scene) {
        return scene.plant().displaced() > 0;
    }

    private static boolean driven(Scene scene) {
        return !scene.plant().thrusters().isEmpty();
    }

    private static boolean showsAfloat(Scene scene) {
        return scene.shows() && afloat(scene);
    }
}
