/** JUnit 5 tests on recorded scenarios: where bodies went, what they met, and what has changed. */
@NullMarked
package org.auvsim.junit;

import org.jspecify.annotations.NullMarked;
