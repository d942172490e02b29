/** Users' own jars, in which commands find effects, messages, processors and whatever else. */
@NullMarked
package org.auvsim.cli.extension;

import org.jspecify.annotations.NullMarked;
