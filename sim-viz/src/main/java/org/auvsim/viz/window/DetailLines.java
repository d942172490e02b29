package org.auvsim.viz.window;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Angles;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.SeenObject;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What is to be read about an object. */
final class DetailLines {
    /** A line, or a heading without a value. */
    record Line(String name, String value, boolean isHeading) {}

    private final List<Line> lines = new ArrayList<>();

    private DetailLines() {}

    static List<Line> of(SeenObject object, Movement motion, List<NamedForce> forces) {
        DetailLines all = new DetailLines();
        all.motion(object, motion);
        object.definition().ifPresent(all::body);
        all.forces(forces);
        object.definition().ifPresent(all::parts);
        return all.lines;
    }

    private void motion(SeenObject object, Movement motion) {
        heading("Object");
        line("Name", object.name());
        line("Id", Long.toString(object.id()) + (object.isFixed() ? ", fixed" : ""));
        line("Position", vector(motion.position()) + " m");
        line("Depth", number(-motion.position().z()) + " m");
        double[] turn = Angles.rollPitchYaw(motion.orientation());
        line("Roll, pitch, yaw", inDegrees(turn[0], turn[1], turn[2]) + " \u00b0");
        heading("Velocity");
        line("World", vector(motion.velocity()) + " m/s");
        Vec3 body = motion.orientation().rotateInverse(motion.velocity());
        line("Surge, sway, heave", vector(body) + " m/s");
        line("Speed", number(motion.velocity().norm()) + " m/s");
        Vec3 spin = motion.orientation().rotateInverse(motion.angularVelocity());
        line("Roll, pitch, yaw rate", inDegrees(spin.x(), 0.0 - spin.y(), spin.z()) + " \u00b0/s");
    }

    private static String inDegrees(double x, double y, double z) {
        return String.format(Locale.ROOT, "%.1f, %.1f, %.1f", degrees(x), degrees(y), degrees(z));
    }

    private void body(WorldObjectDefinition definition) {
        heading("Body");
        if (definition.mass().isPresent()) {
            line("Mass", number(definition.mass().getAsDouble()) + " kg");
        }
        line("Volume", VolumeWords.of(definition.volume()));
        definition.mount().ifPresent(m -> line("Mount", ElementName.of(m.getClass())));
        definition.response().ifPresent(r -> line("Collision", ElementName.of(r.getClass())));
    }

    private void forces(List<NamedForce> forces) {
        if (!forces.isEmpty()) {
            heading("Forces");
            for (NamedForce force : forces) {
                line(
                        force.name(),
                        vector(force.vector())
                                + " N, "
                                + force.frame().name().toLowerCase(Locale.ROOT));
            }
        }
    }

    private void parts(WorldObjectDefinition definition) {
        if (!definition.effect().isEmpty()) {
            heading("Effects");
            for (Effect effect : definition.effect()) {
                line("effect", ElementName.of(effect.getClass()));
            }
        }
        if (!definition.component().isEmpty()) {
            heading("Components");
            for (Component component : definition.component()) {
                line(component.name(), ElementName.of(component.getClass()) + strength(component));
            }
        }
    }

    private static String strength(Component component) {
        return switch (component) {
            case Propulsor p -> ", " + number(p.maximumThrust()) + " N";
            case Fin f -> ", \u00b1" + degrees(f.maximumAngle()) + "\u00b0";
            default -> "";
        };
    }

    private void heading(String text) {
        lines.add(new Line(text, "", true));
    }

    private void line(String name, String value) {
        lines.add(new Line(name, value, false));
    }

    private static double degrees(double angle) {
        return Math.round(Math.toDegrees(angle) * 10) / 10.0 + 0.0;
    }

    private static String vector(Vec3 v) {
        return number(v.x()) + ", " + number(v.y()) + ", " + number(v.z());
    }

    static String number(double value) {
        double shown = Math.abs(value) < 0.005 ? 0 : value;
        return String.format(Locale.ROOT, Math.abs(value) < 1000 ? "%.2f" : "%.1f", shown);
    }
}
