/** Who wants to hear what. */
@NullMarked
package org.auvsim.auvsml.message.listening;

import org.jspecify.annotations.NullMarked;
