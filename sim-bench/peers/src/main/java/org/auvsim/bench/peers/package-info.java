/** Other engines on the workload of the thesis' section 8.2, beside this one. */
@NullMarked
package org.auvsim.bench.peers;

import org.jspecify.annotations.NullMarked;
