package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/** A body as it is believed, written as a scenario. */
final class ScenarioText {
    /** The body's name in it. */
    static final String BODY = "body";

    private ScenarioText() {}

    static String of(Plant plant, double timeStep) {
        StringBuilder out = new StringBuilder("<scenario>\n");
        out.append("  <time-step delta=\"%s\"/>\n".formatted(timeStep));
        out.append("  <world-object name=\"%s\" mass=\"%s\">\n".formatted(BODY, plant.mass()));
        out.append(
                plant.isBall()
                        ? "    <sphere radius=\"%s\"/>\n".formatted(plant.size().getX() / 2)
                        : "    <box>%s</box>\n".formatted(element("size", plant.size())));
        Vector3D inertia = plant.inertia();
        out.append(
                "    <inertia xx=\"%s\" yy=\"%s\" zz=\"%s\"/>\n"
                        .formatted(inertia.getX(), inertia.getY(), inertia.getZ()));
        if (plant.addedMass().getNorm() > 0) {
            out.append(
                    "    <added-mass>%s%s</added-mass>\n"
                            .formatted(
                                    element("linear", plant.addedMass()),
                                    element("angular", plant.addedInertia())));
        }
        effects(plant, out);
        plant.thrusters().forEach(thruster -> out.append(text(thruster)));
        plant.foils().forEach(foil -> out.append(text(foil)));
        return out.append("  </world-object>\n</scenario>\n").toString();
    }

    private static void effects(Plant plant, StringBuilder out) {
        if (plant.gravity() > 0) {
            out.append("    <gravity acceleration=\"%s\"/>\n".formatted(plant.gravity()));
        }
        if (plant.displaced() > 0) {
            out.append(
                    """
                        <buoyancy volume="%s" density="%s" acceleration="%s">%s</buoyancy>
                    """
                            .formatted(
                                    plant.displaced() / Foil.DENSITY,
                                    Foil.DENSITY,
                                    plant.gravity(),
                                    element("centre", plant.buoyancyCentre())));
        }
        Drag drag = plant.drag();
        if (drag.linear().getNorm() + drag.quadratic().getNorm() > 0) {
            out.append(
                    "    <damping>%s%s%s%s</damping>\n"
                            .formatted(
                                    element("linear", drag.linear()),
                                    element("quadratic", drag.quadratic()),
                                    element("angular-linear", drag.angularLinear()),
                                    element("angular-quadratic", drag.angularQuadratic())));
        }
        if (drag.evenLinear() + drag.evenQuadratic() + drag.evenAngular() > 0) {
            out.append(
                    "    <isotropic-drag linear=\"%s\" quadratic=\"%s\" angular=\"%s\"/>\n"
                            .formatted(
                                    drag.evenLinear(), drag.evenQuadratic(), drag.evenAngular()));
        }
    }

    private static String text(Thruster thruster) {
        return """
            <propulsor name="%s" maximum-thrust="%s">%s%s</propulsor>
        """
                .formatted(
                        thruster.name(),
                        thruster.most(),
                        element("position", thruster.position()),
                        element("direction", thruster.direction()));
    }

    private static String text(Foil foil) {
        return """
            <fin name="%s" area="%s" lift-slope="%s" drag-coefficient="%s" induced-drag="%s" \
        stall-angle="%s" density="%s" maximum-angle="0.5">%s%s</fin>
        """
                .formatted(
                        foil.name(),
                        foil.area(),
                        foil.slope(),
                        Foil.DRAG,
                        Foil.INDUCED,
                        Foil.STALL,
                        Foil.DENSITY,
                        element("position", foil.position()),
                        element("span", foil.span()));
    }

    private static String element(String name, Vector3D v) {
        return "<%s x=\"%s\" y=\"%s\" z=\"%s\"/>".formatted(name, v.getX(), v.getY(), v.getZ());
    }
}
