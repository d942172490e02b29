/** The desktop viewer: shows and steers a simulation as an ordinary client does. */
@NullMarked
package org.auvsim.viz;

import org.jspecify.annotations.NullMarked;
