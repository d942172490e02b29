package org.auvsim.core.step;

import org.auvsim.core.dynamics.BodyGroups;

import java.util.Arrays;

/**
 * The pairs that stay together for the rest of a frame, and the islands that they and coupled
 * effects join bodies to. Fixed bodies join nothing. A pair that turns out to bounce, or not to
 * touch, is released: it joins nothing any more, unless it is held again, but keeps its number.
 */
final class HeldPairs {
    private static final int NONE = -1;

    private final BodyTraits traits;
    private final BodyGroups groups;
    private int[] a = new int[64];
    private int[] b = new int[64];
    private boolean[] isHeld = new boolean[64];
    private double[] reach = new double[64];
    private double[] limit = new double[64];
    private int count;

    /**
     * Chains of the pairs of each body: node 2 k belongs to the first of pair k, 2 k + 1 to the
     * second.
     */
    private final int[] chain;

    private int[] next = new int[128];
    private final boolean[] isMember;
    private int[] members = new int[64];
    private int memberCount;
    private int[] pairs = new int[64];
    private int pairCount;

    HeldPairs(BodyTraits traits, BodyGroups groups) {
        this.traits = traits;
        this.groups = groups;
        chain = new int[traits.rank.length];
        Arrays.fill(chain, NONE);
        isMember = new boolean[traits.rank.length];
    }

    /** Forgets all pairs. */
    void clear() {
        for (int k = 0; k < count; k++) {
            chain[a[k]] = NONE;
            chain[b[k]] = NONE;
        }
        count = 0;
    }

    boolean isEmpty() {
        return count == 0;
    }

    /** How many pairs have been held, released ones among them. */
    int count() {
        return count;
    }

    int first(int pair) {
        return a[pair];
    }

    int second(int pair) {
        return b[pair];
    }

    /** Whether a body is in a pair that is held. */
    boolean holds(int body) {
        for (int node = chain[body]; node != NONE; node = next[node]) {
            if (isHeld[node >> 1]) {
                return true;
            }
        }
        return false;
    }

    /**
     * Holds a pair from now on.
     *
     * @param reach gaps up to this (m) count as contacts of the two
     * @param limit the pair bounces if it would part faster than this (m/s)
     */
    void hold(int first, int second, double reach, double limit) {
        int pair = find(first, second);
        if (pair == NONE) {
            pair = count;
            add(first, second);
        } else {
            isHeld[pair] = true;
        }
        this.reach[pair] = reach;
        this.limit[pair] = limit;
    }

    double reach(int pair) {
        return reach[pair];
    }

    double limit(int pair) {
        return limit[pair];
    }

    boolean isHeld(int first, int second) {
        int pair = find(first, second);
        return pair != NONE && isHeld[pair];
    }

    private int find(int first, int second) {
        int from = traits.isFixed[first] ? second : first;
        int to = from == first ? second : first;
        for (int node = chain[from]; node != NONE; node = next[node]) {
            int pair = node >> 1;
            if (a[pair] == to || b[pair] == to) {
                return pair;
            }
        }
        return NONE;
    }

    private void add(int first, int second) {
        if (count == a.length) {
            a = Arrays.copyOf(a, 2 * count);
            b = Arrays.copyOf(b, 2 * count);
            reach = Arrays.copyOf(reach, 2 * count);
            limit = Arrays.copyOf(limit, 2 * count);
            isHeld = Arrays.copyOf(isHeld, 2 * count);
            next = Arrays.copyOf(next, 4 * count);
        }
        a[count] = first;
        b[count] = second;
        isHeld[count] = true;
        next[2 * count] = chain[first];
        chain[first] = 2 * count;
        next[2 * count + 1] = chain[second];
        chain[second] = 2 * count + 1;
        count++;
    }

    /** Whether a pair has not been released. */
    boolean isHeld(int pair) {
        return isHeld[pair];
    }

    /** Lets a pair of the island go; the island stays as it has been found. */
    void release(int pair) {
        isHeld[pair] = false;
    }

    /**
     * Finds all that hang together with two bodies, which may be one; they are the only ones if
     * they hang free.
     */
    void findIsland(int one, int another) {
        memberCount = 0;
        pairCount = 0;
        addToIsland(one);
        addToIsland(another);
        finishIsland();
    }

    private void addToIsland(int body) {
        int from = memberCount;
        addMember(body);
        for (int k = from; k < memberCount; k++) {
            addGroup(members[k]);
            for (int node = chain[members[k]]; node != NONE; node = next[node]) {
                int pair = node >> 1;
                if (isHeld[pair]) {
                    addPair(pair);
                    addMember(a[pair]);
                    addMember(b[pair]);
                }
            }
        }
    }

    private void addGroup(int body) {
        if (groups.isCoupled(body)) {
            for (int mate : groups.members(body)) {
                addMember(mate);
            }
        }
    }

    private void addMember(int body) {
        if (isMember[body] || traits.isFixed[body]) {
            return;
        }
        if (memberCount == members.length) {
            members = Arrays.copyOf(members, 2 * memberCount);
        }
        isMember[body] = true;
        members[memberCount++] = body;
    }

    /** Each pair of two that move is met twice; {@link #finishIsland} drops the second. */
    private void addPair(int pair) {
        if (pairCount == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * pairCount);
        }
        pairs[pairCount++] = pair;
    }

    /**
     * Puts members and pairs of the island into the order of slots, groups side by side, and of
     * holding.
     */
    private void finishIsland() {
        for (int k = 0; k < memberCount; k++) {
            isMember[members[k]] = false;
        }
        groups.sort(members, memberCount);
        Arrays.sort(pairs, 0, pairCount);
        int kept = 0;
        for (int k = 0; k < pairCount; k++) {
            if (k == 0 || pairs[k] != pairs[k - 1]) {
                pairs[kept++] = pairs[k];
            }
        }
        pairCount = kept;
    }

    /**
     * The slots of the island's bodies, none of them fixed, in order; {@link #memberCount} of them.
     */
    int[] members() {
        return members;
    }

    int memberCount() {
        return memberCount;
    }

    /** The held pairs of the island; {@link #pairCount} of them. */
    int[] pairs() {
        return pairs;
    }

    int pairCount() {
        return pairCount;
    }
}
