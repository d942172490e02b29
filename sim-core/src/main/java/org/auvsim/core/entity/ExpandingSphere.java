package org.auvsim.core.entity;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The front of a wave, of pressure or radio: a ball about a fixed place that grows at a constant
 * speed until it has its greatest radius, and then is over. It meets each object once.
 *
 * @param centre (m, world)
 * @param start when it begins to grow (s)
 * @param radius that it begins with (m), above 0
 * @param speed of its front (m/s)
 * @param greatest radius at which it is over (m)
 * @param effect what it does to whom it meets, beside remembering it
 * @param met ids of those that it has met
 */
public record ExpandingSphere(
        long id,
        String name,
        @Unit("m") Vec3 centre,
        @Unit("s") double start,
        @Unit("m") double radius,
        @Unit("m/s") double speed,
        @Unit("m") double greatest,
        Optional<CollisionResponse> effect,
        List<Long> met)
        implements Collidable {
    /**
     * A wave that has met these.
     *
     * @throws IllegalArgumentException if a number is not finite, the first radius or the speed not
     *     above 0, or the greatest radius below the first one
     */
    public ExpandingSphere {
        if (!centre.isFinite() || !Double.isFinite(start) || !Double.isFinite(greatest)) {
            throw new IllegalArgumentException(
                    "centre, start and greatest radius of wave '%s' must be finite, but are %s m, %s s and %s m"
                            .formatted(name, centre, start, greatest));
        }
        if (!(radius > 0) || !(speed > 0) || Double.isInfinite(speed) || !(greatest >= radius)) {
            throw new IllegalArgumentException(
                    "wave '%s' needs a radius above 0 m, a finite speed above 0 m/s and a greatest radius no smaller than the first, but has %s m, %s m/s and %s m"
                            .formatted(name, radius, speed, greatest));
        }
        met = List.copyOf(met);
    }

    /** A wave that has met nobody yet and only remembers whom it meets. */
    public static ExpandingSphere of(
            long id,
            String name,
            Vec3 centre,
            double start,
            double radius,
            double speed,
            double greatest) {
        return new ExpandingSphere(
                id, name, centre, start, radius, speed, greatest, Optional.empty(), List.of());
    }

    /** The same wave with an effect on those whom it meets. */
    public ExpandingSphere withEffect(CollisionResponse response) {
        return new ExpandingSphere(
                id, name, centre, start, radius, speed, greatest, Optional.of(response), met);
    }

    /** Radius of the front (m) at {@code time} (s). */
    public double radiusAt(double time) {
        return Math.min(greatest, radius + speed * Math.max(0, time - start));
    }

    /** When it has its greatest radius (s). */
    public double end() {
        return start + (greatest - radius) / speed;
    }

    @Override
    public Vec3 positionAt(double time) {
        return centre;
    }

    @Override
    public Volume volumeAt(double time) {
        return new Sphere(radiusAt(time));
    }

    @Override
    public double fastestSurface(double from, double to) {
        return from < end() && to > start ? speed : 0;
    }

    @Override
    public boolean meets(Collidable other) {
        return !met.contains(other.id());
    }

    @Override
    public boolean isOver(double time) {
        return time >= end();
    }

    @Override
    public Optional<CollisionResponse> response() {
        return Optional.of(this::respond);
    }

    private List<Change> respond(Contact contact) {
        long other = contact.other().id();
        List<Change> changes = new ArrayList<>();
        effect.ifPresent(response -> changes.addAll(response.respond(contact)));
        changes.add(new Change.Update<>(id, ExpandingSphere.class, wave -> wave.having(other)));
        return changes;
    }

    /** The same wave, having met one more. */
    public ExpandingSphere having(long other) {
        List<Long> all = new ArrayList<>(met);
        all.add(other);
        return new ExpandingSphere(id, name, centre, start, radius, speed, greatest, effect, all);
    }
}
