package org.auvsim.core.step;

import org.auvsim.core.dynamics.BodyGroups;
import org.auvsim.core.entity.Block;

import java.util.Arrays;

/**
 * How all bodies are shared out into blocks that are integrated from a frame's beginning: in the
 * order of slots or, if effects couple some, with those of a group side by side.
 */
final class FrameBlocks {
    private final boolean isPlain;

    /** Where effects couple bodies: all slots with groups side by side. */
    private final int[] inOrder;

    /** Where in that order each block begins; the last entry is the end. */
    private final int[] start;

    FrameBlocks(BodyGroups groups, int bodies) {
        isPlain = groups.isEmpty();
        inOrder = groups.inOrder();
        start = isPlain ? evenStarts(bodies) : startsOf(groups);
    }

    private static int[] evenStarts(int bodies) {
        int[] starts = new int[(bodies + Block.SIZE - 1) / Block.SIZE + 1];
        Arrays.setAll(starts, b -> Math.min(b * Block.SIZE, bodies));
        return starts;
    }

    private int[] startsOf(BodyGroups groups) {
        BodyGroups.Batch batch = new BodyGroups.Batch(groups.capacity());
        int[] starts = new int[inOrder.length + 1];
        int blocks = 0;
        while (starts[blocks] < inOrder.length) {
            int from = starts[blocks++];
            starts[blocks] = from + groups.fill(inOrder, from, inOrder.length, batch);
        }
        return Arrays.copyOf(starts, blocks + 1);
    }

    int count() {
        return start.length - 1;
    }

    /** Loads the bodies of block {@code b} as they are at the frame's beginning. */
    void load(int b, SegmentIntegrator to) {
        if (isPlain) {
            to.loadRow(start[b], start[b + 1]);
        } else {
            to.loadAtBeginning(inOrder, start[b], start[b + 1]);
        }
    }
}
