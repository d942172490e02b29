package org.auvsim.examples.mine;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Component;

/**
 * What a vehicle can bear.
 *
 * @param strength points that are left, 0 or more
 */
public record Hull(String name, @Default("100.0") double strength) implements Component {
    /** This hull after some damage (points). */
    public Hull damaged(double points) {
        return new Hull(name, Math.max(0, strength - points));
    }
}
