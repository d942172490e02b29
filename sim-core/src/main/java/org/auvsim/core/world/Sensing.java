package org.auvsim.core.world;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.sensor.Datum;
import org.auvsim.core.sensor.Kinematics;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.Sensor;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The sensors of a world: lets each measure at its instants along the way from the beginning of a
 * part of a step to its end, and tells their readings when they arrive.
 *
 * <p>How a body moves between the two is taken from its states there. A collision in between is
 * smoothed by that; at the end itself nothing is.
 */
final class Sensing {
    private static final Comparator<WorldEvent.SensorRead> BY_ARRIVAL =
            Comparator.comparingDouble(WorldEvent.SensorRead::time);

    /** What tells a sensor from all others, whatever its parameters are now. */
    private record Place(long objectId, String sensor) {
        static Place of(Station station) {
            return new Place(station.object().id(), station.sensor().name());
        }
    }

    private final Population population;
    private final Optional<Datum> datum;
    private final Announcements announcements;
    private final List<Station> stations = new ArrayList<>();

    /** Readings that are still on their way, in order of arrival. */
    private final List<WorldEvent.SensorRead> underWay = new ArrayList<>();

    private final Course course;
    private int listedAt = -1;
    private double began;

    Sensing(Population population, Optional<Datum> datum, Announcements announcements) {
        this.population = population;
        this.datum = datum;
        this.announcements = announcements;
        course = new Course(population);
    }

    /** The same for a copy of its world. */
    Sensing(Sensing original, Population population, Announcements announcements) {
        this(population, original.datum, announcements);
        for (Station station : original.stations) {
            population
                    .findObject(station.object().id())
                    .ifPresent(
                            object ->
                                    stations.add(
                                            new Station(object, station.sensor(), station.last())));
        }
        underWay.addAll(original.underWay);
    }

    /**
     * Nothing if all sensors of an object can work in this world.
     *
     * @throws WorldException naming the sensor and what it lacks
     */
    void requireFit(WorldObjectDefinition definition) {
        for (Component component : definition.component()) {
            if (component instanceof Sensor sensor) {
                sensor.lacks(datum)
                        .ifPresent(
                                what -> {
                                    throw new WorldException(
                                            "the sensor '%s' of '%s' %s"
                                                    .formatted(
                                                            sensor.name(),
                                                            definition.name(),
                                                            what));
                                });
            }
        }
    }

    /** A part of a step begins at a time (s) and is to take no longer than {@code wanted} (s). */
    void begin(double time, double wanted) {
        list(time);
        began = time;
        course.begin(time);
        if (stations.isEmpty()) {
            return; // no garbage in worlds without sensors, not even an iterator
        }
        for (Station station : stations) {
            if (station.next(time) < time + wanted) {
                course.keep(station.object());
                if (station.sensor().looksAround()) {
                    course.keepAll();
                }
            }
        }
    }

    /** Finds the sensors that there are, if that may have changed. */
    private void list(double time) {
        int changes = population.bodies().equipmentChanges();
        if (changes == listedAt) {
            return;
        }
        listedAt = changes;
        Map<Place, Station> before = new HashMap<>();
        stations.forEach(station -> before.put(Place.of(station), station));
        stations.clear();
        for (WorldObject object : population.objects()) {
            for (Sensor sensor : object.components(Sensor.class)) {
                Station former = before.get(new Place(object.id(), sensor.name()));
                Kinematics last = former == null ? Kinematics.of(object, time) : former.last();
                stations.add(new Station(object, sensor, last));
            }
        }
        underWay.removeIf(reading -> population.findObject(reading.objectId()).isEmpty());
    }

    /** The part of the step ends at a time (s); bodies are there. */
    void measureUntil(double time) {
        if (stations.isEmpty() && underWay.isEmpty()) {
            return;
        }
        course.end(time);
        for (Station station : stations) {
            measure(station, time);
        }
        underWay.sort(BY_ARRIVAL);
        while (!underWay.isEmpty() && Sampling.isBy(underWay.getFirst().time(), time)) {
            announcements.announce(underWay.removeFirst());
        }
    }

    private void measure(Station station, double time) {
        Sampling sampling = station.sensor().sampling();
        long k = sampling.firstAfter(began);
        long end = sampling.firstAfter(time);
        // What arrives at once, and nobody hears, need not be made.
        if (k < end && sampling.delay() == 0 && announcements.isUnheard()) {
            station.pass(course.at(station.object(), sampling.time(end - 1)));
            return;
        }
        for (; k < end; k++) {
            Kinematics now = course.at(station.object(), sampling.time(k));
            SensorScene scene = new SensorScene(population, datum, course, station.object(), now);
            station.measure(k, now, scene).ifPresent(underWay::add);
        }
    }
}
