package org.auvsim.auvsml.document;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlTree;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.step.Lanes;
import org.auvsim.core.step.Overlap;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;
import org.jdom2.Content;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** What only the finished world can tell of a scenario: objects that do not go together. */
final class WorldFaults {
    /** So many overlaps are told one by one. */
    private static final int MOST_LISTED = 10;

    private final XmlTree tree;
    private final Map<String, PlacedElement> byName = new HashMap<>();
    private final List<Fault> faults = new ArrayList<>();

    private WorldFaults(XmlTree tree) {
        this.tree = tree;
        for (int i = 0; i < tree.root().getContentSize(); i++) {
            if (tree.root().getContent(i) instanceof PlacedElement entity
                    && entity.getAttribute("name") != null) {
                byName.put(entity.getAttributeValue("name"), entity);
            }
        }
    }

    /**
     * Overlaps have the place of the object that comes later in the text; what else keeps a world
     * from being built has the scenario's own.
     */
    static List<Fault> in(Scenario scenario, XmlTree tree) {
        try {
            return overlaps(scenario, tree);
        } catch (WorldException | IllegalArgumentException e) {
            WorldFaults found = new WorldFaults(tree);
            found.add(String.valueOf(e.getMessage()), tree.root());
            return found.faults;
        }
    }

    /**
     * The overlaps among the objects of a tree without the elements that have faults.
     *
     * @param known the faults of the tree
     */
    static List<Fault> inSoundPart(XmlTree tree, List<Fault> known, AuvsmlMapper mapper) {
        List<Content> all = List.copyOf(tree.root().getContent());
        if (!SoundPart.keep(tree.root(), known)) {
            return List.of();
        }
        try {
            return overlaps(mapper.decode(Scenario.class, tree), tree);
        } catch (AuvsmlException | WorldException | IllegalArgumentException _) {
            // What is left does not stand without what was taken away: there is no more to tell.
            return List.of();
        } finally {
            tree.root().setContent(all);
        }
    }

    private static List<Fault> overlaps(Scenario scenario, XmlTree tree) {
        World world = scenario.world(Lanes.ONE, /* overlapsAllowed= */ true);
        WorldFaults found = new WorldFaults(tree);
        if (!scenario.allowOverlaps()) {
            found.addAll(world.overlaps());
        }
        return found.faults;
    }

    private void addAll(List<Overlap> overlaps) {
        overlaps.stream().limit(MOST_LISTED).forEach(this::add);
        int more = overlaps.size() - MOST_LISTED;
        if (more > 0) {
            add("%d pairs more overlap at the start".formatted(more), tree.root());
        }
    }

    private void add(Overlap overlap) {
        boolean isInOrder =
                element(overlap.first()).place().compareTo(element(overlap.second()).place()) < 0;
        RigidBody earlier = isInOrder ? overlap.first() : overlap.second();
        RigidBody later = isInOrder ? overlap.second() : overlap.first();
        add(
                "'%s' overlaps '%s' of line %d by %s; move them apart or set allow-overlaps"
                        .formatted(
                                later.name(),
                                earlier.name(),
                                element(earlier).place().line(),
                                overlap.depthInMetres()),
                element(later));
    }

    private PlacedElement element(RigidBody body) {
        return byName.getOrDefault(body.name(), tree.root());
    }

    private void add(String sentence, PlacedElement at) {
        faults.add(
                new Fault(
                        ErrorCode.INVALID_VALUE,
                        sentence,
                        /* path= */ "",
                        at.place().line(),
                        at.place().column()));
    }
}
