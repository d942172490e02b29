/** The kinds of commands, and the narrow ports to what they act on. */
@NullMarked
package org.auvsim.auvsml.message.command;

import org.jspecify.annotations.NullMarked;
