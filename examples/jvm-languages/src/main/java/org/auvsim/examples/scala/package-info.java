/** An effect and a feedback processor whose work is done in Scala. */
@NullMarked
package org.auvsim.examples.scala;

import org.jspecify.annotations.NullMarked;
