/** What an accelerometer and a gyro tell beyond the motion of a model: that the body shakes. */
@NullMarked
package org.auvsim.diagnosis.shaking;

import org.jspecify.annotations.NullMarked;
