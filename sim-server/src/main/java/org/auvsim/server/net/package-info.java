/**
 * Clients and the way to them: transports, sessions, who hears what, and what is on its way out.
 *
 * <p>Registrations and notifications belong to the simulation thread; an {@link
 * org.auvsim.server.net.Outbox} is where that thread and a client's writer meet.
 */
@NullMarked
package org.auvsim.server.net;

import org.jspecify.annotations.NullMarked;
