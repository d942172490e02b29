package org.auvsim.core.description;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The value that a record component has when a document leaves it out.
 *
 * <p>Written as in the document; for a nested record, the values of its scalars in order, separated
 * by blanks: {@code @Default("0 0 0") Vec3 position}.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.RECORD_COMPONENT)
public @interface Default {
    /** The value, as a document would state it. */
    String value();
}
