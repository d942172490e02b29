package org.auvsim.core.step;

import org.auvsim.core.entity.Contact;
import org.auvsim.core.math.Vec3;

/**
 * A contact that was responded to.
 *
 * @param contact as it was before
 * @param impulse what {@link Contact#self} received (N s, world)
 */
public record Collision(Contact contact, Vec3 impulse) {}
