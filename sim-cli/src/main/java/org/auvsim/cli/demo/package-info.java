/**
 * The demonstration: a simulated robot is flown by commands, a physical one moves differently, and
 * its feedback corrects the simulation.
 */
@NullMarked
package org.auvsim.cli.demo;

import org.jspecify.annotations.NullMarked;
