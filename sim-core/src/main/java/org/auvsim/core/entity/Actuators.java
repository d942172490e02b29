package org.auvsim.core.entity;

import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;

/**
 * The actuators of all bodies whose push is not constant, by slot. What those push that are timed
 * is worked out once for bodies side by side that carry the same: variants of one body, told alike.
 */
public final class Actuators {
    private static final Actuator[] NONE = {};

    private Actuator[][] timed;
    private Actuator[][] moved;

    /** How many bodies have some. */
    private int users;

    Actuators(int capacity) {
        timed = none(capacity);
        moved = none(capacity);
    }

    private Actuators(Actuators original) {
        timed = original.timed.clone();
        moved = original.moved.clone();
        users = original.users;
    }

    private static Actuator[][] none(int capacity) {
        Actuator[][] none = new Actuator[capacity][];
        Arrays.fill(none, NONE);
        return none;
    }

    /** The actuators are immutable and shared. */
    Actuators copy() {
        return new Actuators(this);
    }

    void grow(int capacity) {
        timed = grown(timed, capacity);
        moved = grown(moved, capacity);
    }

    private static Actuator[][] grown(Actuator[][] bySlot, int capacity) {
        Actuator[][] grown = none(capacity);
        System.arraycopy(bySlot, 0, grown, 0, bySlot.length);
        return grown;
    }

    void set(int slot, List<Actuator> actuators) {
        users -= isUser(slot) ? 1 : 0;
        timed[slot] = varying(actuators, Actuator::isTimed);
        moved[slot] = varying(actuators, actuator -> !actuator.isTimed());
        users += isUser(slot) ? 1 : 0;
    }

    private boolean isUser(int slot) {
        return timed[slot].length + moved[slot].length > 0;
    }

    /** Those whose push is not constant; commands come at every step, so it is no stream. */
    private static Actuator[] varying(List<Actuator> actuators, Predicate<Actuator> which) {
        Actuator[] varying = new Actuator[actuators.size()];
        int count = 0;
        for (Actuator actuator : actuators) {
            if (which.test(actuator) && actuator.constantPush().isEmpty()) {
                varying[count] = actuator;
                count++;
            }
        }
        return count == 0 ? NONE : Arrays.copyOf(varying, count);
    }

    void remove(int slot, int count) {
        set(slot, List.of());
        closeGap(timed, slot, count);
        closeGap(moved, slot, count);
    }

    private static void closeGap(Actuator[][] bySlot, int slot, int count) {
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
            if (isUser(b.slot(i))) {
                return true;
            }
        }
        return false;
    }

    /** Adds what they exert on the bodies of the block. */
    public void add(Block b) {
        if (users == 0) {
            return;
        }
        Actuator[] last = NONE;
        for (int i = 0; i < b.count; i++) {
            Actuator[] own = timed[b.slot(i)];
            if (own.length > 0) {
                if (!areSame(own, last)) {
                    sumUp(own, b);
                    last = own;
                }
                b.addFromBody(i, b.timedPush);
            }
            for (Actuator actuator : moved[b.slot(i)]) {
                actuator.add(b, i);
            }
        }
    }

    private static void sumUp(Actuator[] actuators, Block b) {
        Arrays.fill(b.timedPush, 0);
        for (Actuator actuator : actuators) {
            actuator.push(b, b.timedPush);
        }
    }

    @SuppressWarnings("ReferenceEquality") // those that are equal cost more to compare than to ask
    private static boolean areSame(Actuator[] some, Actuator[] others) {
        if (some.length != others.length) {
            return false;
        }
        for (int k = 0; k < some.length; k++) {
            if (some[k] != others[k]) {
                return false;
            }
        }
        return true;
    }
}
