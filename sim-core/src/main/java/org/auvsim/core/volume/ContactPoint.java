package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/**
 * Where two volumes touch.
 *
 * @param point in world coordinates (m), between the two surfaces
 * @param normal unit vector from the second volume toward the first
 * @param depth how far they overlap along the normal (m); negative while they are apart
 */
public record ContactPoint(Vec3 point, Vec3 normal, double depth) {
    /** The same contact with first and second exchanged. */
    public ContactPoint flipped() {
        return new ContactPoint(point, normal.negated(), depth);
    }
}
