package org.auvsim.experiments.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.util.List;

/** The most heap in use at one time, garbage that has not been collected yet included. */
final class PeakMemory {
    private final List<MemoryPoolMXBean> pools =
            ManagementFactory.getMemoryPoolMXBeans().stream()
                    .filter(pool -> pool.getType() == MemoryType.HEAP)
                    .toList();

    /** Collects garbage and begins anew. */
    void reset() {
        ManagementFactory.getMemoryMXBean().gc();
        pools.forEach(MemoryPoolMXBean::resetPeakUsage);
    }

    /** Bytes. */
    long bytes() {
        return pools.stream().mapToLong(pool -> pool.getPeakUsage().getUsed()).sum();
    }
}
