/** A client's side of a connection to a simulator. */
@NullMarked
package org.auvsim.auvsml.client;

import org.jspecify.annotations.NullMarked;
