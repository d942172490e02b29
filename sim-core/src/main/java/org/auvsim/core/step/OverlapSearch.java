package org.auvsim.core.step;

import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.volume.Manifold;
import org.auvsim.core.volume.PairQueries;
import org.auvsim.core.volume.Pose;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Finds the bodies that share space in their present states, by the engine's broad phase. */
final class OverlapSearch implements ColumnGrid.Pairs {
    /** Surfaces that touch may overlap by this share of the smaller radius, as rounding has it. */
    private static final double TOLERANCE = 1e-6;

    /** When so many are known, the rest is not looked at. */
    private static final int MOST = 10_000;

    private final List<WorldObject> objects;
    private final BodyTraits traits;
    private final Touch touch;
    private final Manifold manifold = new Manifold();
    private final List<Overlap> found = new ArrayList<>();

    private OverlapSearch(
            List<WorldObject> objects, BodyTraits traits, BodyState bodies, PairQueries queries) {
        this.objects = objects;
        this.traits = traits;
        this.touch = new Touch(bodies, traits, queries);
    }

    /** All pairs, or the first {@value #MOST} met, in order of their ids. */
    static List<Overlap> among(
            List<WorldObject> bySlot, BodyTraits traits, BodyState bodies, PairQueries queries) {
        OverlapSearch search = new OverlapSearch(bySlot, traits, bodies, queries);
        double[] boxes = new double[6 * bySlot.size()];
        Pose pose = new Pose();
        for (int slot = 0; slot < bySlot.size(); slot++) {
            pose.set(bySlot.get(slot).position(), bySlot.get(slot).orientation());
            traits.volume[slot].bounds(pose, boxes, 6 * slot);
        }
        ColumnGrid grid = new ColumnGrid(boxes, new int[bySlot.size()], bySlot.size(), Lanes.ONE);
        grid.build();
        grid.sweep(0, grid.columns(), search);
        grid.sweepLarge(search);
        search.found.sort(
                Comparator.comparingLong((Overlap o) -> o.first().id())
                        .thenComparingLong(o -> o.second().id()));
        return search.found;
    }

    @Override
    public void meet(int a, int b) {
        if (found.size() == MOST || !traits.mayCollide(a, b)) {
            return;
        }
        touch.find(a, b, 0, manifold);
        double depth = -manifold.leastGap();
        if (depth > TOLERANCE * Math.min(traits.radius[a], traits.radius[b])) {
            boolean inOrder = objects.get(a).id() < objects.get(b).id();
            found.add(
                    new Overlap(objects.get(inOrder ? a : b), objects.get(inOrder ? b : a), depth));
        }
    }
}
