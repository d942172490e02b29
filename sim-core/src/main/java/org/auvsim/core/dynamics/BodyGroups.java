package org.auvsim.core.dynamics;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.BodyState;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * Which bodies have to be integrated in one block, as effects couple them: groups of bodies that
 * can move, and beside each group its anchors, the fixed bodies that it is coupled to. Bodies go by
 * their slots.
 */
public final class BodyGroups {
    private static final int NONE = -1;

    /** The group of each body; empty if nothing is coupled. */
    private final int[] group;

    private final int[][] members;
    private final int[][] anchors;

    /** A body's place if those of a group stand together, and the body at each place. */
    private final int[] place;

    private final int[] inOrder;
    private final int capacity;

    BodyGroups(BodyState bodies, List<BlockEffect> effects) {
        List<int[]> couples = new ArrayList<>();
        effects.forEach(effect -> couples.addAll(effect.couples()));
        int count = couples.isEmpty() ? 0 : bodies.count();
        int[] leader = new int[count];
        Arrays.setAll(leader, slot -> slot);
        boolean[] isCoupled = new boolean[count];
        for (int[] couple : couples) {
            join(couple, leader, isCoupled, bodies.inverseMass());
        }
        group = new int[count];
        List<TreeSet<Integer>> found = new ArrayList<>();
        for (int slot = 0; slot < count; slot++) {
            int first = find(leader, slot);
            if (first == slot && isCoupled[slot]) {
                group[slot] = found.size();
                found.add(new TreeSet<>());
            }
            group[slot] = isCoupled[slot] ? group[first] : NONE;
            if (isCoupled[slot]) {
                found.get(group[slot]).add(slot);
            }
        }
        members = found.stream().map(BodyGroups::toArray).toArray(int[][]::new);
        anchors = anchors(couples, bodies.inverseMass());
        place = new int[count];
        inOrder = new int[count];
        standTogether();
        capacity = largest();
    }

    private static void join(
            int[] couple, int[] leader, boolean[] isCoupled, double[] inverseMass) {
        int first = NONE;
        for (int slot : couple) {
            if (inverseMass[slot] > 0) {
                isCoupled[slot] = true;
                int other = find(leader, slot);
                first = first == NONE ? other : first;
                leader[Math.max(first, other)] = Math.min(first, other);
                first = Math.min(first, other);
            }
        }
    }

    private static int find(int[] leader, int slot) {
        int at = slot;
        while (leader[at] != at) {
            at = leader[at];
        }
        return at;
    }

    private int[][] anchors(List<int[]> couples, double[] inverseMass) {
        List<TreeSet<Integer>> found = new ArrayList<>();
        for (int k = 0; k < members.length; k++) {
            found.add(new TreeSet<>());
        }
        for (int[] couple : couples) {
            int[] moving = Arrays.stream(couple).filter(s -> inverseMass[s] > 0).toArray();
            for (int slot : couple) {
                if (inverseMass[slot] == 0 && moving.length > 0) {
                    found.get(group[moving[0]]).add(slot);
                }
            }
        }
        return found.stream().map(BodyGroups::toArray).toArray(int[][]::new);
    }

    private static int[] toArray(SortedSet<Integer> slots) {
        return slots.stream().mapToInt(Integer::intValue).toArray();
    }

    private void standTogether() {
        int next = 0;
        for (int slot = 0; slot < group.length; slot++) {
            if (group[slot] == NONE) {
                inOrder[next++] = slot;
            } else if (members[group[slot]][0] == slot) {
                for (int member : members[group[slot]]) {
                    inOrder[next++] = member;
                }
            }
        }
        for (int k = 0; k < next; k++) {
            place[inOrder[k]] = k;
        }
    }

    private int largest() {
        int most = Block.SIZE;
        for (int k = 0; k < members.length; k++) {
            most = Math.max(most, members[k].length + anchors[k].length);
        }
        return most;
    }

    /** Whether nothing is coupled. */
    public boolean isEmpty() {
        return members.length == 0;
    }

    /** Whether a body is in a group. */
    public boolean isCoupled(int slot) {
        return members.length > 0 && group[slot] != NONE;
    }

    /** The bodies of a coupled body's group, itself included, none of them fixed, in order. */
    public int[] members(int slot) {
        return members[group[slot]];
    }

    /** All bodies that effects couple to a body, itself and fixed ones included, in order. */
    int[] companions(int slot) {
        TreeSet<Integer> found = new TreeSet<>(List.of(slot));
        for (int k = 0; k < members.length; k++) {
            if (Arrays.binarySearch(members[k], slot) >= 0
                    || Arrays.binarySearch(anchors[k], slot) >= 0) {
                Arrays.stream(members[k]).forEach(found::add);
                Arrays.stream(anchors[k]).forEach(found::add);
            }
        }
        return toArray(found);
    }

    /** How many bodies are to be integrated with a body, itself included, without anchors. */
    public int size(int slot) {
        return isCoupled(slot) ? members[group[slot]].length : 1;
    }

    /** How many bodies a block has to hold for the largest group. */
    public int capacity() {
        return capacity;
    }

    /** All slots, those of a group side by side; empty if nothing is coupled. */
    public int[] inOrder() {
        return inOrder.clone();
    }

    /** Sorts slots so that those of a group stand side by side. */
    public void sort(int[] slots, int number) {
        if (isEmpty()) {
            Arrays.sort(slots, 0, number);
            return;
        }
        for (int k = 0; k < number; k++) {
            slots[k] = place[slots[k]];
        }
        Arrays.sort(slots, 0, number);
        for (int k = 0; k < number; k++) {
            slots[k] = inOrder[slots[k]];
        }
    }

    /**
     * Copies as many of the slots as fit into one block, groups whole and side by side.
     *
     * @return how many they are; behind them stand the anchors
     */
    public int fill(int[] slots, int first, int end, Batch batch) {
        int number = 0;
        batch.count = 0;
        int anchored = 0;
        if (isEmpty()) {
            number = Math.min(capacity, end - first);
            System.arraycopy(slots, first, batch.slots, 0, number);
            batch.count = number;
            return number;
        }
        while (first + number < end) {
            int slot = slots[first + number];
            int size = size(slot);
            int fixed = isCoupled(slot) ? anchors[group[slot]].length : 0;
            if (number + size + anchored + fixed > capacity) {
                break;
            }
            System.arraycopy(slots, first + number, batch.slots, number, size);
            number += size;
            anchored += fixed;
        }
        batch.count = number;
        for (int k = 0; k < number; k += size(batch.slots[k])) {
            if (isCoupled(batch.slots[k])) {
                for (int anchor : anchors[group[batch.slots[k]]]) {
                    batch.slots[batch.count++] = anchor;
                }
            }
        }
        return number;
    }

    /** The slots of the bodies of one block; scratch of one thread. */
    public static final class Batch {
        /** The slots, in the first {@link #count} places. */
        public final int[] slots;

        /** How many bodies there are, anchors included. */
        public int count;

        /** For blocks of a capacity. */
        public Batch(int capacity) {
            slots = new int[capacity];
        }
    }
}
