package org.auvsim.core.world;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObject;
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
    public <C extends Component> List<C> components(Class<C> type) {
        return self.components(type);
    }

    @Override
    public Optional<Sighting> look(Vec3 from, Vec3 direction, double range, Target what) {
        Optional<Sighting> nearest = Optional.empty();
        Ray ray = new Ray(from, direction, range);
        for (WorldObject object : population.objects()) {
            if (object == self || (what == Target.FIXED_BODY && !object.isFixed())) {
                continue;
            }
            double distance = distance(object, ray);
            if (distance < Ray.MISS) {
                nearest = Optional.of(new Sighting(object.id(), distance));
                ray = new Ray(from, direction, distance);
            }
        }
        return nearest;
    }

    private double distance(WorldObject object, Ray ray) {
        Kinematics there = course.at(object, time);
        double radius = object.volume().boundingRadius();
        Vec3 to = there.position().minus(ray.from());
        double along = to.dot(ray.direction());
        double beside = to.minus(ray.direction().times(along)).norm();
        if (beside > radius || along + radius < 0 || along - radius > ray.range()) {
            return Ray.MISS;
        }
        return object.volume().distance(ray.seenFrom(there.position(), there.orientation()));
    }
}
