package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/** Where a body is (m, world) and how it lies. */
record Pose(Vector3D position, Attitude attitude) {}
