package org.auvsim.auvsml;

import java.util.List;

/**
 * A text that cannot be turned into a record; it has one fault or more, in order of their places.
 */
public final class AuvsmlException extends Exception {
    private final transient List<Fault> faults;

    /** For these faults, of which there is at least one. */
    public AuvsmlException(List<Fault> faults) {
        super(faults.getFirst().toString());
        this.faults = List.copyOf(faults);
    }

    /** For one fault. */
    public AuvsmlException(Fault fault) {
        this(List.of(fault));
    }

    /** The first fault. */
    public Fault fault() {
        return faults.getFirst();
    }

    /** All faults. */
    public List<Fault> faults() {
        return faults;
    }
}
