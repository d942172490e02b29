package org.auvsim.diagnosis.result;

import org.auvsim.core.math.Vec3;

/**
 * The force that a model lacks at a time of a run, by how the measured motion departs from it over
 * a short while.
 *
 * @param time in the middle of that while (s)
 * @param before as the model was believed (N, world)
 * @param after with what was found (N, world)
 */
public record ForceResidual(double time, Vec3 before, Vec3 after) {}
