/** XML as far as AUVSML needs it: a reader that no text can harm, and a writer. */
@NullMarked
package org.auvsim.auvsml.xml;

import org.jspecify.annotations.NullMarked;
