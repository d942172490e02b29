package org.auvsim.core.world;

import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Surroundings;
import org.auvsim.core.entity.WorldObject;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Lays out the effects of all objects, class by class in the order in which they first appear. */
final class EffectLayout {
    private EffectLayout() {}

    static List<BlockEffect> of(Bodies bodies) {
        List<WorldObject> bySlot = bodies.objects();
        Set<Long> ids = new HashSet<>();
        bySlot.forEach(object -> ids.add(object.id()));
        Map<Class<?>, List<List<Effect>>> byClass = new LinkedHashMap<>();
        for (WorldObject object : bySlot) {
            for (Effect effect : object.effects()) {
                if (!isWhole(effect, ids)) {
                    continue;
                }
                byClass.computeIfAbsent(effect.getClass(), c -> emptySlots(bySlot.size()))
                        .set(object.slot(), ofClass(effect.getClass(), object, ids));
            }
        }
        Surroundings around = bodies.surroundings();
        return byClass.values().stream()
                .map(effects -> firstOf(effects).layOut(effects, around))
                .toList();
    }

    /** A coupled effect ends when one of its partners leaves. */
    private static boolean isWhole(Effect effect, Set<Long> ids) {
        return !(effect instanceof CoupledEffect coupled) || ids.containsAll(coupled.partners());
    }

    private static List<List<Effect>> emptySlots(int count) {
        List<List<Effect>> slots = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            slots.add(List.of());
        }
        return slots;
    }

    private static List<Effect> ofClass(Class<?> type, WorldObject object, Set<Long> ids) {
        return object.effects().stream()
                .filter(e -> e.getClass() == type && isWhole(e, ids))
                .toList();
    }

    private static Effect firstOf(List<List<Effect>> slots) {
        return slots.stream().flatMap(List::stream).findFirst().orElseThrow();
    }
}
