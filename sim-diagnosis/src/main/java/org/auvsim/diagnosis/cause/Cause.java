package org.auvsim.diagnosis.cause;

import org.auvsim.diagnosis.model.Variant;

import java.util.List;

/** Something that a model may lack or have wrong; a whole family of them, by its parameters. */
public interface Cause {
    /** By which reports name it, as {@code quadratic_drag}. */
    String id();

    /** What it depends on. */
    List<Parameter> parameters();

    /**
     * The model with it.
     *
     * @param theta a number for each parameter
     */
    Variant in(Variant model, double[] theta);
}
