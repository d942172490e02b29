/** The simulator as a server that robots connect to. */
@NullMarked
package org.auvsim.server;

import org.jspecify.annotations.NullMarked;
