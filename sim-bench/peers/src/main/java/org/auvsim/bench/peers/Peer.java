package org.auvsim.bench.peers;

import org.auvsim.experiments.workload.Workload;

/** An engine. */
interface Peer {
    /** Its name and version. */
    String name();

    /** A world of it with this workload's spheres at rest at their places. */
    PeerWorld world(Workload workload);
}
