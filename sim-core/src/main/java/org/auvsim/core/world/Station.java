package org.auvsim.core.world;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.sensor.Kinematics;
import org.auvsim.core.sensor.Noise;
import org.auvsim.core.sensor.Sample;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.Scene;
import org.auvsim.core.sensor.Sensor;
import org.auvsim.core.sensor.SensorReading;

import java.util.Optional;

/** One sensor of one object, and how the object moved when it last measured. */
final class Station {
    /** The channel of a sensor's noise that decides on dropouts, before those of its readings. */
    private static final int DROPOUT = -1;

    private final WorldObject object;
    private final Sensor sensor;
    private Kinematics last;

    Station(WorldObject object, Sensor sensor, Kinematics last) {
        this.object = object;
        this.sensor = sensor;
        this.last = last;
    }

    WorldObject object() {
        return object;
    }

    Sensor sensor() {
        return sensor;
    }

    Kinematics last() {
        return last;
    }

    /** When it measures next after a time (s). */
    double next(double time) {
        Sampling sampling = sensor.sampling();
        return sampling.time(sampling.firstAfter(time));
    }

    /** It measures for sample {@code k}, and only if it is wanted is a reading made. */
    Optional<WorldEvent.SensorRead> measure(long k, Kinematics now, Scene scene, boolean isWanted) {
        Kinematics before = last;
        last = now;
        Noise noise = Noise.of(object.id(), sensor.name(), sensor.sampling(), k);
        if (!isWanted || noise.uniform(DROPOUT) < sensor.sampling().dropout()) {
            return Optional.empty();
        }
        Optional<SensorReading> reading = sensor.read(new Sample(now, before, scene, noise));
        double taken = sensor.sampling().time(k);
        return reading.map(
                of ->
                        new WorldEvent.SensorRead(
                                taken + sensor.sampling().delay(),
                                object.id(),
                                sensor.name(),
                                taken,
                                of));
    }
}
