/**
 * One time step: stages that shorten it, partition the world, find the earliest collision and
 * respond.
 */
@NullMarked
package org.auvsim.core.step;

import org.jspecify.annotations.NullMarked;
