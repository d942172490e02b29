package org.auvsim.core.entity;

import java.util.List;

/**
 * What an entity does when it collides (thesis, section 3.2): bounce, explode, take damage.
 *
 * <p>Responses of one instant are all asked before anything changes; what they return is then
 * applied in order of the ids of those who responded.
 */
public interface CollisionResponse {
    /** The changes that this contact causes; {@link Contact#self} is the one that responds. */
    List<Change> respond(Contact contact);
}
