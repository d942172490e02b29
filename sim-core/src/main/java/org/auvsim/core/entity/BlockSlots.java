package org.auvsim.core.entity;

import java.util.Arrays;

/** Which bodies are in a block: the slot of each, and where in the block each slot's body is. */
final class BlockSlots {
    private final int[] slots;
    private int count;

    /** Whether the slots follow one another. */
    private boolean areNeighbours = true;

    /** Where each slot may be, to be believed if it is there. */
    private int[] places = new int[0];

    private boolean hasPlaces;

    /** By length, what was found last. */
    private int[][] found = new int[0][];

    BlockSlots(int capacity) {
        slots = new int[capacity];
    }

    void take(int first, int howMany) {
        count = howMany;
        hasPlaces = false;
        areNeighbours = true;
        for (int i = 0; i < count; i++) {
            slots[i] = first + i;
        }
    }

    void take(int[] these, int howMany) {
        count = howMany;
        hasPlaces = false;
        areNeighbours = false;
        System.arraycopy(these, 0, slots, 0, count);
    }

    int get(int i) {
        return slots[i];
    }

    int indexOf(int slot) {
        if (!hasPlaces) {
            notePlaces();
        }
        int i = slot < places.length ? places[slot] : count;
        return i < count && slots[i] == slot ? i : -1;
    }

    private void notePlaces() {
        for (int i = 0; i < count; i++) {
            if (slots[i] >= places.length) {
                places = Arrays.copyOf(places, 2 * slots[i] + 1);
            }
            places[slots[i]] = i;
        }
        hasPlaces = true;
    }

    int[] find(int[] these) {
        int size = these.length;
        if (found.length <= size) {
            found = new int[size + 1][];
            Arrays.setAll(found, k -> new int[k]);
        }
        for (int k = 0; k < size; k++) {
            int i = indexOf(these[k]);
            if (i < 0) {
                return found[0];
            }
            found[size][k] = i;
        }
        return found[size];
    }

    void gather(double[] bySlot, double[] to) {
        if (areNeighbours) {
            System.arraycopy(bySlot, slots[0], to, 0, count);
            return;
        }
        for (int i = 0; i < count; i++) {
            to[i] = bySlot[slots[i]];
        }
    }

    void scatter(double[] from, double[] bySlot) {
        if (areNeighbours) {
            System.arraycopy(from, 0, bySlot, slots[0], count);
            return;
        }
        for (int i = 0; i < count; i++) {
            bySlot[slots[i]] = from[i];
        }
    }
}
