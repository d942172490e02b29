package org.auvsim.core.world;

import static java.util.Objects.requireNonNull;

import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObject;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Lays out the effects of all objects, class by class in the order in which they first appear. */
final class EffectLayout {
    private EffectLayout() {}

    static List<BlockEffect> of(List<WorldObject> bySlot) {
        Map<Long, Integer> slots = new HashMap<>();
        bySlot.forEach(object -> slots.put(object.id(), object.slot()));
        Map<Class<?>, List<List<Effect>>> byClass = new LinkedHashMap<>();
        for (WorldObject object : bySlot) {
            for (Effect effect : object.effects()) {
                if (!isWhole(effect, slots)) {
                    continue;
                }
                byClass.computeIfAbsent(effect.getClass(), c -> emptySlots(bySlot.size()))
                        .set(object.slot(), ofClass(effect.getClass(), object, slots));
            }
        }
        List<BlockEffect> layout = new ArrayList<>();
        for (List<List<Effect>> effects : byClass.values()) {
            layout.add(layOut(firstOf(effects), effects, slots));
        }
        return List.copyOf(layout);
    }

    /** A coupled effect ends when one of its partners leaves. */
    private static boolean isWhole(Effect effect, Map<Long, Integer> slots) {
        return !(effect instanceof CoupledEffect coupled)
                || slots.keySet().containsAll(coupled.partners());
    }

    private static BlockEffect layOut(
            Effect first, List<List<Effect>> effects, Map<Long, Integer> slots) {
        return first instanceof CoupledEffect coupled
                ? coupled.layOut(effects, id -> requireNonNull(slots.get(id)))
                : first.layOut(effects);
    }

    private static List<List<Effect>> emptySlots(int count) {
        List<List<Effect>> slots = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            slots.add(List.of());
        }
        return slots;
    }

    private static List<Effect> ofClass(
            Class<?> type, WorldObject object, Map<Long, Integer> slots) {
        return object.effects().stream()
                .filter(e -> e.getClass() == type && isWhole(e, slots))
                .toList();
    }

    private static Effect firstOf(List<List<Effect>> slots) {
        return slots.stream().flatMap(List::stream).findFirst().orElseThrow();
    }
}
