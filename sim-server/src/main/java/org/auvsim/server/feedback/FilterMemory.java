package org.auvsim.server.feedback;

import org.apache.commons.math3.linear.RealMatrix;

/**
 * What a Kalman filter knows of an object beside the object itself.
 *
 * @param time of its last measurement (s)
 * @param covariance of the error of the object's motion after that, 12 x 12, see {@link
 *     RigidMotion#plus}
 * @param surprise the last innovation squared, in units of its covariance; of a filter that fits,
 *     it is on average how many numbers were measured (Bar-Shalom, Li &amp; Kirubarajan 2001,
 *     section 5.4)
 */
record FilterMemory(double time, RealMatrix covariance, double surprise) {}
