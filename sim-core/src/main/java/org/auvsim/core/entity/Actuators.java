package org.auvsim.core.entity;

import java.util.Arrays;
import java.util.List;

/** The actuators of all bodies whose push is not constant, by slot. */
public final class Actuators {
    private static final Actuator[] NONE = {};

    private Actuator[][] bySlot;

    /** How many bodies have some. */
    private int users;

    Actuators(int capacity) {
        bySlot = new Actuator[capacity][];
        Arrays.fill(bySlot, NONE);
    }

    private Actuators(Actuators original) {
        bySlot = original.bySlot.clone();
        users = original.users;
    }

    /** The actuators are immutable and shared. */
    Actuators copy() {
        return new Actuators(this);
    }

    void grow(int capacity) {
        int before = bySlot.length;
        bySlot = Arrays.copyOf(bySlot, capacity);
        Arrays.fill(bySlot, before, capacity, NONE);
    }

    void set(int slot, List<Actuator> actuators) {
        Actuator[] varying = varying(actuators);
        users += (varying.length == 0 ? 0 : 1) - (bySlot[slot].length == 0 ? 0 : 1);
        bySlot[slot] = varying;
    }

    /** Those whose push is not constant; commands come at every step, so it is no stream. */
    private static Actuator[] varying(List<Actuator> actuators) {
        Actuator[] varying = new Actuator[actuators.size()];
        int count = 0;
        for (Actuator actuator : actuators) {
            if (actuator.constantPush().isEmpty()) {
                varying[count] = actuator;
                count++;
            }
        }
        return count == 0 ? NONE : Arrays.copyOf(varying, count);
    }

    void remove(int slot, int count) {
        set(slot, List.of());
        System.arraycopy(bySlot, slot + 1, bySlot, slot, count - slot - 1);
        bySlot[count - 1] = NONE;
    }

    /** Whether no body has any. */
    public boolean isEmpty() {
        return users == 0;
    }

    /** Whether a body of the block has some. */
    public boolean push(Block b) {
        for (int i = 0; users > 0 && i < b.count; i++) {
            if (bySlot[b.slot(i)].length > 0) {
                return true;
            }
        }
        return false;
    }

    /** Adds what they exert on the bodies of the block. */
    public void add(Block b) {
        for (int i = 0; users > 0 && i < b.count; i++) {
            for (Actuator actuator : bySlot[b.slot(i)]) {
                actuator.add(b, i);
            }
        }
    }
}
