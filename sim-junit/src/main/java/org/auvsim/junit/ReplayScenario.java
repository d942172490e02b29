package org.auvsim.junit;

import org.junit.jupiter.api.extension.ExtendWith;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Runs a recording or a scenario again, with the present code, and gives it to the test as a
 * parameter of type {@link Replay}. On a class it holds for all of its methods, which share one
 * run; on a method for this one.
 */
@Documented
@Inherited
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.METHOD})
@ExtendWith(ReplayExtension.class)
public @interface ReplayScenario {
    /**
     * The file: a recording or a scenario, whatever its name is. A resource named relative to the
     * test's class, or from the class path's root if it begins with {@code /}; else a file,
     * relative to where the tests run, with Maven the module's folder.
     */
    String value();

    /**
     * World time (s) at which the run ends; a scenario has no end of its own and needs it, a
     * recording ends where it ends.
     */
    double until() default Double.NaN;
}
