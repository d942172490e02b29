/** How fast worlds go on, how true they stay, and tables and charts of it. */
@NullMarked
package org.auvsim.experiments.bench;

import org.jspecify.annotations.NullMarked;
