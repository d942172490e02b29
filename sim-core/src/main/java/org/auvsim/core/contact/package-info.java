/** Bodies that touch: the impulses that part them or hold them, with Coulomb friction. */
@NullMarked
package org.auvsim.core.contact;

import org.jspecify.annotations.NullMarked;
