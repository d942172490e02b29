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

    private static final Predicate<Scene> ANY = scene -> true;
    private static final Predicate<Scene> SHOWN = Scene::shows;
    private static final Predicate<Scene> AFLOAT = scene -> scene.plant().displaced() > 0;
    private static final Predicate<Scene> THRUSTERS = scene -> !scene.plant().thrusters().isEmpty();

    /** Those of the library of causes, by their id there. */
    static final SortedMap<String, Kind> LIBRARY = library();

    /** Those outside of it. */
    static final List<Kind> UNCOVERED =
            List.of(
                    new Kind(ANY, UncoveredEffects::slosh),
                    new Kind(ANY, UncoveredEffects::kicks),
                    new Kind(ANY, UncoveredEffects::chaos),
                    new Kind(AFLOAT, UncoveredEffects::wake));

    private Effects() {}

    private static SortedMap<String, Kind> library() {
        SortedMap<String, Kind> all = new TreeMap<>();
        all.put("linear_drag", new Kind(ANY, PlantEffects::linearDrag));
        all.put("quadratic_drag", new Kind(ANY, PlantEffects::quadraticDrag));
        all.put("anisotropic_drag", new Kind(SHOWN, PlantEffects::anisotropicDrag));
        all.put("rotational_drag", new Kind(SHOWN, PlantEffects::rotationalDrag));
        all.put("added_mass", new Kind(SHOWN.and(AFLOAT), PlantEffects::addedMass));
        all.put("cob_offset", new Kind(SHOWN.and(AFLOAT), PlantEffects::cobOffset));
        all.put("mass_error", new Kind(ANY, PlantEffects::mass));
        all.put("inertia_error", new Kind(SHOWN, PlantEffects::inertia));
        all.put("current_constant", new Kind(ANY, WaterEffects::constant));
        all.put("current_oscillating", new Kind(ANY, WaterEffects::oscillating));
        all.put("current_shear", new Kind(ANY, WaterEffects::shear));
        all.put("current_vortex", new Kind(AFLOAT, WaterEffects::vortex));
        all.put("buoyancy_weight", new Kind(ANY, ForceEffects::buoyancyWeight));
        all.put("coulomb_friction", new Kind(ANY, ForceEffects::coulombFriction));
        all.put("magnetic", new Kind(ANY, ForceEffects::magnetic));
        all.put("magnus", new Kind(ANY, ForceEffects::magnus));
        all.put("tether_spring", new Kind(ANY, ForceEffects::tether));
        all.put("wave_forcing", new Kind(ANY, ForceEffects::wave));
        all.put("periodic_force", new Kind(ANY, ForceEffects::periodic));
        all.put("step_force", new Kind(ANY, ForceEffects::step));
        all.put("impulse", new Kind(ANY, ForceEffects::impulse));
        all.put("thruster_gain", new Kind(THRUSTERS, ThrusterEffects::gain));
        all.put("thruster_deadzone", new Kind(THRUSTERS, ThrusterEffects::deadZone));
        all.put("thruster_lag", new Kind(THRUSTERS, ThrusterEffects::lag));
        all.put("thruster_misalignment", new Kind(THRUSTERS, ThrusterEffects::misalignment));
        all.put("thruster_loss", new Kind(THRUSTERS, ThrusterEffects::loss));
        all.put("sensor_bias", new Kind(SHOWN, SensorEffects::yawBias));
        all.put("sensor_drift", new Kind(SHOWN, SensorEffects::yawDrift));
        all.put("sensor_scale", new Kind(ANY, SensorEffects::scale));
        all.put("sensor_delay", new Kind(ANY, SensorEffects::delay));
        all.put("axis_misalignment", new Kind(ANY, SensorEffects::axisMisalignment));
        return all;
    }
}
