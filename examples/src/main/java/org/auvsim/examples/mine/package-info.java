/** A mine: a collision response that adds an entity, and a collidable that is no body. */
@NullMarked
package org.auvsim.examples.mine;

import org.jspecify.annotations.NullMarked;
