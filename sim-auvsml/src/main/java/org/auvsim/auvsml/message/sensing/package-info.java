/** What sensors read. */
@NullMarked
package org.auvsim.auvsml.message.sensing;

import org.jspecify.annotations.NullMarked;
