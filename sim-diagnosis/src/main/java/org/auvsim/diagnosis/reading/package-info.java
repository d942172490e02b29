/** Reads measured runs from files; docs/measured-runs.md has their format. */
@NullMarked
package org.auvsim.diagnosis.reading;

import org.jspecify.annotations.NullMarked;
