/** Reports: headings, tables and charts in one HTML file that needs nothing else. */
@NullMarked
package org.auvsim.plot.page;

import org.jspecify.annotations.NullMarked;
