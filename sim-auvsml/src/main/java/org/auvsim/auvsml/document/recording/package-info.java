/** Recordings as files: written so that a crash costs a second, read as far as they go. */
@NullMarked
package org.auvsim.auvsml.document.recording;

import org.jspecify.annotations.NullMarked;
