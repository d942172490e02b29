package org.auvsim.experiments.figures;

import static org.auvsim.experiments.figures.CauseStage.PENDULUM;
import static org.auvsim.experiments.figures.CauseStage.SPINNER;
import static org.auvsim.experiments.figures.CauseStage.STEERED;
import static org.auvsim.experiments.figures.CauseStage.THROWN;
import static org.auvsim.experiments.figures.CauseStage.VEHICLE;

import org.auvsim.diagnosis.cause.Cause;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** For each cause of the library, what it leaves in the residuals of a model that lacks it. */
final class CauseFigures {
    private final Map<CauseStage, List<Cause>> causes = new HashMap<>();
    private final List<Figure> figures = new ArrayList<>();

    /** What is shown of the residuals. */
    private enum Shown {
        POSITION("position (m)", 0, 1),
        TURN("turn (degrees)", 3, 180 / Math.PI);

        final String label;
        final int first;
        final double unit;

        Shown(String label, int first, double unit) {
            this.label = label;
            this.first = first;
            this.unit = unit;
        }
    }

    private CauseFigures() {}

    static List<Figure> all() {
        CauseFigures all = new CauseFigures();
        all.ofWater();
        all.ofTheBody();
        all.ofThrusters();
        all.ofFins();
        all.ofPlaces();
        all.ofTimes();
        all.ofSensors();
        return all.figures;
    }

    private void ofWater() {
        position("linear_drag", SPINNER, 1);
        position("quadratic_drag", SPINNER, 2);
        position("anisotropic_drag", SPINNER, 1, 4, 8);
        position("anisotropic_linear_drag", SPINNER, 0.5, 1, 2);
        turn("rotational_drag", SPINNER, 0.002);
        position("magnus", SPINNER, 0.5);
        position("current_constant", VEHICLE, 0.05, -0.03, 0);
        position("current_oscillating", VEHICLE, 0.1, 0.05, 0, 0, 0.05, 0, 1);
        position("current_shear", VEHICLE, 0.01, 0.005);
        position("current_vortex", VEHICLE, 3, -1, 0.05, 2);
    }

    private void ofTheBody() {
        position("buoyancy_weight", VEHICLE, 0.6);
        turn("cob_offset", VEHICLE, 0.002, 0.001, 0);
        turn("cog_offset", VEHICLE, 0.002, 0.001, 0);
        position("mass_error", VEHICLE, 0.1);
        turn("inertia_error", SPINNER, 0.2, -0.1, 0.1);
        position("added_mass", VEHICLE, 3, 3, 3);
        position("coulomb_friction", SPINNER, 0.002);
        turn("coulomb_torque", PENDULUM, 0.05);
        position("restitution", THROWN, 0.1);
        position("contact_friction", THROWN, 0.15);
    }

    private void ofThrusters() {
        position("thruster_gain", VEHICLE, -0.1);
        position("thruster_deadzone", VEHICLE, 0.05);
        position("thruster_lag", VEHICLE, 0.5);
        position("thruster_astern", VEHICLE, -0.3);
        position("thruster_advance", VEHICLE, 0.2);
        position("thruster_fade", VEHICLE, 0.01);
        turn("thruster_misalignment", VEHICLE, 0.03);
        turn("thruster_loss", VEHICLE, 1, 18);
    }

    private void ofFins() {
        turn("fin_gain", STEERED, 0.2);
        turn("fin_race", STEERED, 0.3);
        turn("fin_offset", STEERED, 0.05);
        turn("hull_lift", STEERED, -4, 1, -2, -1);
    }

    private void ofPlaces() {
        position("magnetic", SPINNER, 6, 1, 2, 0.012);
        position("tether_spring", SPINNER, 0, 0, 1, 2.4, 0.05);
    }

    private void ofTimes() {
        position("wave_forcing", VEHICLE, 2, 1, 0.6, 1.2, 1);
        position("periodic_force", VEHICLE, 2, 0, 1, 0, 1, 0, 1.5);
        position("step_force", VEHICLE, 1, -0.5, 0.3, 8);
        position("impulse", VEHICLE, 3, -2, 1, 8);
    }

    private void ofSensors() {
        turn("sensor_bias", VEHICLE, 0.1);
        turn("sensor_drift", VEHICLE, 0.01);
        turn("compass_deviation", VEHICLE, 0.1, 0.05);
        position("sensor_offset", VEHICLE, 0.05, 0, -0.1);
        position("sensor_lever_arm", VEHICLE, 0.4, 0.2, 0);
        position("sensor_scale", VEHICLE, 0.03, 0, -0.02);
        position("sensor_delay", VEHICLE, 0.3);
        position("position_delay", VEHICLE, 0.3);
        turn("orientation_delay", VEHICLE, 0.3);
        position("clock_offset", VEHICLE, -0.3);
        position("axis_misalignment", VEHICLE, 0.02, 0, 0.05);
        position("position_drift", VEHICLE, 0.01, -0.005, 0);
    }

    private void position(String id, CauseStage stage, double... theta) {
        figures.add(figure(id, stage, Shown.POSITION, theta));
    }

    private void turn(String id, CauseStage stage, double... theta) {
        figures.add(figure(id, stage, Shown.TURN, theta));
    }

    private Figure figure(String id, CauseStage stage, Shown shown, double... theta) {
        Cause cause =
                causes.computeIfAbsent(stage, CauseStage::causes).stream()
                        .filter(one -> one.id().equals(id))
                        .findFirst()
                        .orElseThrow();
        double[][] residuals = stage.residuals(cause, theta);
        List<Series> lines = new ArrayList<>();
        for (int axis = 0; axis < 3; axis++) {
            List<Series.Point> points = new ArrayList<>();
            for (int k = 0; k < residuals.length; k++) {
                double y = shown.unit * residuals[k][shown.first + axis];
                points.add(new Series.Point(stage.time(k), y));
            }
            lines.add(new Series(List.of("x", "y", "z").get(axis), points));
        }
        return new Figure(
                id, "%s: measured less simulated".formatted(cause), "time (s)", shown.label, lines);
    }
}
