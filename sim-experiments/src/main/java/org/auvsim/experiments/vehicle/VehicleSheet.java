package org.auvsim.experiments.vehicle;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Formatter;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/** What the numbers of a vehicle say of it, as text for people. */
public final class VehicleSheet {
    /** Share of the weight. */
    private static final double FAR_FROM_NEUTRAL = 0.05;

    /** Growth (1/s) too slow to tell from rounding and to matter: a minute to twice the size. */
    private static final double NEUTRAL = Math.log(2) / 60;

    private final WorldObjectDefinition vehicle;
    private final Hydrostatics hydrostatics;
    private final Hull hull;
    private final OptionalDouble ahead;
    private final Formatter sheet = new Formatter(Locale.ROOT);

    private VehicleSheet(WorldObjectDefinition vehicle) {
        this.vehicle = vehicle;
        hydrostatics = Hydrostatics.of(vehicle);
        hull = Hull.of(vehicle.volume());
        ahead = TerminalSpeeds.along(vehicle, new Vec3(1, 0, 0));
    }

    /**
     * The sheet of a vehicle. Axes are those of its body: x forward, y to port, z up.
     *
     * @throws IllegalArgumentException if it is fixed or has no end, so that it is no vehicle
     */
    public static String of(WorldObjectDefinition vehicle) {
        if (vehicle.fixed() || !vehicle.volume().isBounded()) {
            throw new IllegalArgumentException(
                    "'%s' is fixed or has no end and so is no vehicle; name another body"
                            .formatted(vehicle.name()));
        }
        return new VehicleSheet(vehicle).write();
    }

    private String write() {
        sheet.format("%s (body axes: x forward, y to port, z up)%n", vehicle.name());
        sheet.format("%n");
        masses();
        addedMass();
        motion();
        controls();
        sheet.format("%n");
        findings();
        return sheet.toString();
    }

    private void masses() {
        Mat3 inertia = vehicle.massProperties().orElseThrow().inertia();
        Hydrostatics h = hydrostatics;
        sheet.format("Hull          %s m%s%n", of(hull.size()), hull.isRound() ? ", round" : "");
        sheet.format("Mass          %.5g kg, centre at %s m%n", mass(), of(h.centreOfMass()));
        sheet.format(
                "Inertia       %.4g, %.4g, %.4g kg m^2 about it%n",
                inertia.xx(), inertia.yy(), inertia.zz());
        sheet.format("Weight        %.5g N%n", h.weight());
        sheet.format(
                "Buoyancy      %.5g N, centre at %s m%n", h.buoyancy(), of(h.centreOfBuoyancy()));
        if (h.stiffness() > 0) {
            sheet.format(
                    "Righting      %.4g N m/rad, BG %.4g m%s%n",
                    h.stiffness(), h.metacentricHeight(), swings());
        }
    }

    private double mass() {
        return vehicle.mass().orElseThrow();
    }

    /** Nothing where weight and buoyancy differ much: it then moves off rather than swings. */
    private String swings() {
        if (Math.abs(hydrostatics.excess()) > FAR_FROM_NEUTRAL) {
            return "";
        }
        return "; rolls in %s s, pitches in %s s"
                .formatted(
                        figure(SmallSwings.period(vehicle, new Vec3(1, 0, 0))),
                        figure(SmallSwings.period(vehicle, new Vec3(0, 1, 0))));
    }

    private void addedMass() {
        AddedMassCheck check = AddedMassCheck.of(vehicle, hydrostatics, hull);
        sheet.format("%n");
        sheet.format("Added mass       surge     sway    heave     roll    pitch      yaw%n");
        sheet.format("  stated     %s%n", row(boxed(check.stated())));
        sheet.format("  ellipsoid  %s%n", row(boxed(check.ellipsoid())));
        sheet.format("  strips     %s%n", row(check.strips()));
        sheet.format("%n");
        DampingCheck water = water();
        List<OptionalDouble> against = new ArrayList<>();
        for (int axis = 0; axis < 6; axis++) {
            against.add(OptionalDouble.of(water.against(axis)));
        }
        sheet.format("Drag at 1    %s  (N at 1 m/s, N m at 1 rad/s)%n", row(against));
    }

    private DampingCheck water() {
        return new DampingCheck(vehicle, hull, hydrostatics.density());
    }

    private static List<OptionalDouble> boxed(Numbers values) {
        List<OptionalDouble> boxed = new ArrayList<>();
        for (int i = 0; i < values.size(); i++) {
            boxed.add(OptionalDouble.of(values.get(i)));
        }
        return boxed;
    }

    private static String row(List<OptionalDouble> values) {
        StringBuilder row = new StringBuilder();
        for (OptionalDouble value : values) {
            row.append(
                    value.isPresent()
                            ? String.format(Locale.ROOT, "%9.4g", value.getAsDouble())
                            : "        -");
        }
        return row.toString();
    }

    private void motion() {
        sheet.format("%n");
        sheet.format(
                "Full thrust   ahead %s, astern %s, to port %s, up %s, down %s (m/s)%n",
                figure(ahead),
                figure(TerminalSpeeds.along(vehicle, new Vec3(-1, 0, 0))),
                figure(TerminalSpeeds.along(vehicle, new Vec3(0, 1, 0))),
                figure(TerminalSpeeds.along(vehicle, new Vec3(0, 0, 1))),
                figure(TerminalSpeeds.along(vehicle, new Vec3(0, 0, -1))));
        if (ahead.isPresent()) {
            CourseStability course = CourseStability.at(vehicle, ahead.getAsDouble());
            sheet.format("Course        %s%n", course(course.sideways(), "sideways"));
            sheet.format("              %s%n", course(course.vertical(), "up and down"));
        }
    }

    private static String figure(OptionalDouble value) {
        return value.isPresent() ? String.format(Locale.ROOT, "%.3g", value.getAsDouble()) : "-";
    }

    /** Package-private for its test: no published vehicle is neutral. */
    static String course(double growth, String plane) {
        if (Math.abs(growth) < NEUTRAL) {
            return "neutral %s: neither halves nor doubles within a minute".formatted(plane);
        }
        double time = Math.log(2) / Math.abs(growth);
        return String.format(
                Locale.ROOT,
                growth < 0 ? "stable %s: halves in %.3g s" : "unstable %s: doubles in %.3g s",
                plane,
                time);
    }

    private void controls() {
        List<Propulsor> propulsors = all(Propulsor.class);
        ThrustAllocation allocation = ThrustAllocation.of(propulsors);
        sheet.format(
                "Thrusters     %d, rank %d, independent: %s%n",
                propulsors.size(),
                allocation.rank(),
                allocation.free().isEmpty()
                        ? "none"
                        : String.join(
                                ", ",
                                allocation.free().stream()
                                        .map(axis -> axis.name().toLowerCase(Locale.ROOT))
                                        .toList()));
        sheet.format("Fins          %d%n", all(Fin.class).size());
    }

    private <C extends Component> List<C> all(Class<C> type) {
        return vehicle.component().stream().filter(type::isInstance).map(type::cast).toList();
    }

    private void findings() {
        List<String> found = new ArrayList<>(WeightCheck.findings(vehicle, hydrostatics));
        found.addAll(AddedMassCheck.of(vehicle, hydrostatics, hull).findings());
        found.addAll(water().findings());
        sheet.format(
                "%s%n",
                found.isEmpty() ? "Nothing looks wrong." : "What looks wrong, or worth knowing:");
        found.forEach(sentence -> sheet.format("- %s%n", sentence));
    }

    private static String of(Vec3 v) {
        return String.format(Locale.ROOT, "(%.4g, %.4g, %.4g)", v.x(), v.y(), v.z());
    }
}
