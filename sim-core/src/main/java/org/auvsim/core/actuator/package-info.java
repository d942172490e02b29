/** What drives and steers a vehicle: propulsors with their batteries, and fins. */
@NullMarked
package org.auvsim.core.actuator;

import org.jspecify.annotations.NullMarked;
