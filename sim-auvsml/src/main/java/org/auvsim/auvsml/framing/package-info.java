/** A stream of bytes as messages, and messages as bytes. */
@NullMarked
package org.auvsim.auvsml.framing;

import org.jspecify.annotations.NullMarked;
