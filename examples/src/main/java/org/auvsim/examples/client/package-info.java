/** Clients that drive vehicles over AUVSML. */
@NullMarked
package org.auvsim.examples.client;

import org.jspecify.annotations.NullMarked;
