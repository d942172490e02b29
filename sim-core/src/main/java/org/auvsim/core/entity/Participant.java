package org.auvsim.core.entity;

import java.util.Optional;

/**
 * One of the two in a contact.
 *
 * @param id its id
 * @param kind the class of the entity
 * @param body its motion, if it is a rigid body
 */
public record Participant(
        long id, String name, Class<? extends Collidable> kind, Optional<BodyMotion> body) {}
