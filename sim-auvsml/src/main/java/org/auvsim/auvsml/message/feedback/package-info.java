/** What robots measure, and what the simulator made of it. */
@NullMarked
package org.auvsim.auvsml.message.feedback;

import org.jspecify.annotations.NullMarked;
