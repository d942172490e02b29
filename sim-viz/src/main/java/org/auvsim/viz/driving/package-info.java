/** How keys and sticks become orders to propulsors and fins. */
@NullMarked
package org.auvsim.viz.driving;

import org.jspecify.annotations.NullMarked;
