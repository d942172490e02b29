/**
 * The Corrective Feedback System (thesis, section 7.2): how what robots measure corrects the world.
 *
 * <p>A {@link org.auvsim.server.feedback.FeedbackTimestepper} puts the parts of a step in order, a
 * {@link org.auvsim.server.feedback.FeedbackProcessor} makes one correction. Both can be a user's
 * own, given to {@code SimulatorBuilder}; a processor can also be named in a provider file, {@code
 * META-INF/services/org.auvsim.server.feedback.FeedbackProcessor}.
 */
@NullMarked
package org.auvsim.server.feedback;

import org.jspecify.annotations.NullMarked;
