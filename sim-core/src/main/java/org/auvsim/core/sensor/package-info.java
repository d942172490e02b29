/**
 * What a world object measures of itself and of the world around it: sensors, their errors, and
 * their readings.
 */
@NullMarked
package org.auvsim.core.sensor;

import org.jspecify.annotations.NullMarked;
