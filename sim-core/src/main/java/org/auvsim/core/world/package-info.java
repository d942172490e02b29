/** The world: all entities, the one way that its time advances, and the events that tell of it. */
@NullMarked
package org.auvsim.core.world;

import org.jspecify.annotations.NullMarked;
