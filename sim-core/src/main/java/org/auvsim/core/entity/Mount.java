package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * What holds a body to some of its six ways of motion; its momenta along the others stay zero.
 * Directions are unit vectors at right angles to each other, in world axes.
 */
public interface Mount {
    /** The directions in which the origin may move. */
    List<Vec3> freeTranslations();

    /** The axes about which the body may turn. */
    List<Vec3> freeRotations();
}
