/** Worlds that go on in a simulator while robots take part over TCP, as the thesis had them. */
@NullMarked
package org.auvsim.experiments.live;

import org.jspecify.annotations.NullMarked;
