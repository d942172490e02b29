/**
 * Recording: what decides a simulation's course is written down, with what came of it. Replay: it
 * is given to the same simulation again, and what comes of it is compared.
 */
@NullMarked
package org.auvsim.server.replay;

import org.jspecify.annotations.NullMarked;
