/**
 * What stands beside a measured run: what its rows do not tell, and how its columns are to be read.
 * docs/measured-runs.md has the format.
 */
@NullMarked
package org.auvsim.auvsml.run;

import org.jspecify.annotations.NullMarked;
