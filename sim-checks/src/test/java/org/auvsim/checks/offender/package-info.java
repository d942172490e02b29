/** Classes that break the rules, so that the tests see that each rule can be broken. */
@NullMarked
package org.auvsim.checks.offender;

import org.jspecify.annotations.NullMarked;
