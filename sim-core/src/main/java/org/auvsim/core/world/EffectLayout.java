package org.auvsim.core.world;

import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObject;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Lays out the effects of all objects, class by class in the order in which they first appear. */
final class EffectLayout {
    private EffectLayout() {}

    static List<BlockEffect> of(List<WorldObject> bySlot) {
        Map<Class<?>, List<List<Effect>>> byClass = new LinkedHashMap<>();
        for (WorldObject object : bySlot) {
            for (Effect effect : object.effects()) {
                byClass.computeIfAbsent(effect.getClass(), c -> emptySlots(bySlot.size()))
                        .set(object.slot(), ofClass(effect.getClass(), object));
            }
        }
        List<BlockEffect> layout = new ArrayList<>();
        for (List<List<Effect>> slots : byClass.values()) {
            layout.add(firstOf(slots).layOut(slots));
        }
        return List.copyOf(layout);
    }

    private static List<List<Effect>> emptySlots(int count) {
        List<List<Effect>> slots = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            slots.add(List.of());
        }
        return slots;
    }

    private static List<Effect> ofClass(Class<?> type, WorldObject object) {
        return object.effects().stream().filter(e -> e.getClass() == type).toList();
    }

    private static Effect firstOf(List<List<Effect>> slots) {
        return slots.stream().flatMap(List::stream).findFirst().orElseThrow();
    }
}
