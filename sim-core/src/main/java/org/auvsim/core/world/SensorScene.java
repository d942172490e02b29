package org.auvsim.core.world;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Datum;
import org.auvsim.core.sensor.Kinematics;
import org.auvsim.core.sensor.Scene;
import org.auvsim.core.volume.Ray;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The world around one object at an instant of a step. */
final class SensorScene implements Scene {
    private final Population population;
    private final Optional<Datum> datum;
    private final Course course;
    private final WorldObject self;
    private final double time;
    private Optional<List<Seen>> seen = Optional.empty();

    SensorScene(
            Population population,
            Optional<Datum> datum,
            Course course,
            WorldObject self,
            Kinematics now) {
        this.population = population;
        this.datum = datum;
        this.course = course;
        this.self = self;
        this.time = now.time();
    }

    @Override
    public Optional<Datum> datum() {
        return datum;
    }

    @Override
    public <F extends Field<?>> List<F> fields(Class<F> type) {
        List<F> found = new ArrayList<>();
        for (Entity entity : population.others()) {
            if (type.isInstance(entity)) {
                found.add(type.cast(entity));
            }
        }
        return found;
    }

    @Override
    public List<Current> currents() {
        return population.bodies().state().currents();
    }

    @Override
    public <C extends Component> List<C> components(Class<C> type) {
        return self.components(type);
    }

    @Override
    public Optional<Sighting> look(Vec3 from, Vec3 direction, double range, Target what) {
        Optional<Sighting> nearest = Optional.empty();
        Ray ray = new Ray(from, direction, range);
        for (Seen body : bodies()) {
            if (what == Target.FIXED_BODY && !body.object.isFixed()) {
                continue;
            }
            double distance = body.distance(ray);
            if (distance < Ray.MISS) {
                nearest = Optional.of(new Sighting(body.object.id(), distance));
                ray = new Ray(from, direction, distance);
            }
        }
        return nearest;
    }

    /** The other bodies where they are now, found once for all rays. */
    private List<Seen> bodies() {
        if (seen.isEmpty()) {
            List<Seen> found = new ArrayList<>();
            for (WorldObject object : population.objects()) {
                if (object != self) {
                    Kinematics there = course.at(object, time);
                    found.add(new Seen(object, there.position(), there.orientation()));
                }
            }
            seen = Optional.of(found);
        }
        return seen.get();
    }

    /** Another body, and where it is. */
    private record Seen(WorldObject object, Vec3 position, Quat orientation) {
        double distance(Ray ray) {
            double radius = object.volume().boundingRadius();
            Vec3 to = position.minus(ray.from());
            double along = to.dot(ray.direction());
            if (along + radius < 0 || along - radius > ray.range()) {
                return Ray.MISS;
            }
            double beside = to.minus(ray.direction().times(along)).norm();
            return beside > radius
                    ? Ray.MISS
                    : object.volume().distance(ray.seenFrom(position, orientation));
        }
    }
}
