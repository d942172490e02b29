package org.auvsim.viz.drawing;

import org.auvsim.core.entity.Component;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Dvl;
import org.auvsim.core.sensor.RangeSonar;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

import java.util.List;

/** Where range sonars and Doppler velocity logs look: fans and cones of lines. */
final class SensorBeams implements Part {
    private static final int ARC = 16;
    private static final int CONE = 24;

    private final Placement body = new Placement();
    private final Placement sensor = new Placement();

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!picture.options().shows(Layer.SENSORS)) {
            return;
        }
        for (int i = 0; i < look.count(); i++) {
            ActorView actor = look.actor(i);
            if (actor.object().definition().isPresent()) {
                body.of(actor);
                sensors(actor.object().definition().get().component(), picture.brush());
            }
        }
    }

    private void sensors(List<Component> components, Brush brush) {
        for (int k = 0; k < components.size(); k++) {
            switch (components.get(k)) {
                case RangeSonar sonar -> fan(sonar, brush);
                case Dvl log -> cone(log, brush);
                default -> {}
            }
        }
    }

    private void mount(Vec3 position, Quat orientation) {
        sensor.within(body, position, orientation);
    }

    /** From the sensor's x axis half the fan to either side, in its x-y plane. */
    private void fan(RangeSonar sonar, Brush brush) {
        mount(sonar.position(), sonar.orientation());
        double range = sonar.maximumRange();
        double half = sonar.beams() == 1 ? 0 : sonar.fan() / 2;
        ray(Math.cos(half) * range, Math.sin(half) * range, 0, brush);
        if (half == 0) {
            return;
        }
        ray(Math.cos(half) * range, -Math.sin(half) * range, 0, brush);
        for (int i = 0; i < ARC; i++) {
            double from = half * (2.0 * i / ARC - 1);
            double to = half * (2.0 * (i + 1) / ARC - 1);
            edge(
                    range * Math.cos(from),
                    range * Math.sin(from),
                    0,
                    range * Math.cos(to),
                    range * Math.sin(to),
                    0,
                    brush);
        }
    }

    /** Four beams down, and the circle that they touch. */
    private void cone(Dvl log, Brush brush) {
        mount(log.position(), log.orientation());
        double wide = log.range() * Math.sin(log.beamAngle());
        double down = -log.range() * Math.cos(log.beamAngle());
        double beam = wide * Math.sqrt(0.5);
        ray(beam, beam, down, brush);
        ray(beam, -beam, down, brush);
        ray(-beam, beam, down, brush);
        ray(-beam, -beam, down, brush);
        for (int i = 0; i < CONE; i++) {
            double from = 2 * Math.PI * i / CONE;
            double to = 2 * Math.PI * (i + 1) / CONE;
            edge(
                    wide * Math.cos(from),
                    wide * Math.sin(from),
                    down,
                    wide * Math.cos(to),
                    wide * Math.sin(to),
                    down,
                    brush);
        }
    }

    private void ray(double x, double y, double z, Brush brush) {
        edge(0, 0, 0, x, y, z, brush);
    }

    private void edge(
            double ax, double ay, double az, double bx, double by, double bz, Brush brush) {
        brush.line(
                sensor.pose.x + sensor.world(0, ax, ay, az),
                sensor.pose.y + sensor.world(1, ax, ay, az),
                sensor.pose.z + sensor.world(2, ax, ay, az),
                sensor.pose.x + sensor.world(0, bx, by, bz),
                sensor.pose.y + sensor.world(1, bx, by, bz),
                sensor.pose.z + sensor.world(2, bx, by, bz),
                Palette.SENSOR);
    }
}
