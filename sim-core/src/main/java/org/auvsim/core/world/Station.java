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
    private final Noise noise;
    private Kinematics last;

    Station(WorldObject object, Sensor sensor, Kinematics last) {
        this.object = object;
        this.sensor = sensor;
        this.noise = Noise.of(object.id(), sensor.name(), sensor.sampling(), 0);
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

    /** It passes an instant without a reading. */
    void pass(Kinematics now) {
        last = now;
    }

    /**
     * It measures for sample {@code k}; empty if there is nothing to read, or the reading is lost.
     */
    Optional<WorldEvent.SensorRead> measure(long k, Kinematics now, Scene scene) {
        Kinematics before = last;
        last = now;
        Noise ofSample = noise.at(k);
        if (ofSample.uniform(DROPOUT) < sensor.sampling().dropout()) {
            return Optional.empty();
        }
        Optional<SensorReading> reading = sensor.read(new Sample(now, before, scene, ofSample));
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
