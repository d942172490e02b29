/**
 * Motions in windows of measured runs (multiple shooting: Bock 1983), and how they change with
 * starts and parameters: simulated along the measured motion, a window cannot get lost as a run
 * can.
 */
@NullMarked
package org.auvsim.diagnosis.shooting;

import org.jspecify.annotations.NullMarked;
