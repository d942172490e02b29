/** How world objects talk to one another: modems, radios, and the waves that carry messages. */
@NullMarked
package org.auvsim.core.communication;

import org.jspecify.annotations.NullMarked;
