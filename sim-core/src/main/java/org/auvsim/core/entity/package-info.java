/**
 * What a world is made of: entities, fields, collidables, rigid bodies, and the components of world
 * objects.
 */
@NullMarked
package org.auvsim.core.entity;

import org.jspecify.annotations.NullMarked;
