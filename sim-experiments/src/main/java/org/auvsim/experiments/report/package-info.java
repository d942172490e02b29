/** Reports of experiments: headings, tables and charts in one HTML file that needs nothing else. */
@NullMarked
package org.auvsim.experiments.report;

import org.jspecify.annotations.NullMarked;
