package org.auvsim.auvsml;

import java.util.Comparator;
import java.util.List;

/**
 * A text that cannot be turned into a record; it has one fault or more, in order of their places;
 * but what is missing comes last, since it is often there under a name that is misspelt.
 */
public final class AuvsmlException extends Exception {
    private static final Comparator<Fault> BY_PLACE =
            Comparator.comparing((Fault fault) -> fault.code() == ErrorCode.MISSING_VALUE)
                    .thenComparingInt(Fault::line)
                    .thenComparingInt(Fault::column);

    private final transient List<Fault> faults;

    /** For these faults, of which there is at least one. */
    public AuvsmlException(List<Fault> faults) {
        List<Fault> sorted = faults.stream().sorted(BY_PLACE).toList();
        super(sorted.getFirst().toString());
        this.faults = sorted;
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
