package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * Effects of one class of which a body may have several that do not add up to one: the first of
 * each body is laid out, then the second of those that have two, and so on.
 */
final class Layers implements BlockEffect {
    private final BlockEffect[] layers;

    private Layers(List<BlockEffect> layers) {
        this.layers = layers.toArray(BlockEffect[]::new);
    }

    /**
     * Lays them out.
     *
     * @param layer lays out effects of which a body has one at most
     */
    static BlockEffect of(
            List<List<Effect>> bySlot, Function<List<List<Effect>>, BlockEffect> layer) {
        List<BlockEffect> layers = new ArrayList<>();
        int most = bySlot.stream().mapToInt(List::size).max().orElse(0);
        for (int k = 0; k < Math.max(most, 1); k++) {
            int from = k;
            layers.add(
                    layer.apply(
                            bySlot.stream()
                                    .map(
                                            e ->
                                                    e.subList(
                                                            Math.min(from, e.size()),
                                                            Math.min(from + 1, e.size())))
                                    .toList()));
        }
        return layers.size() == 1 ? layers.getFirst() : new Layers(layers);
    }

    @Override
    public void add(Block block) {
        for (BlockEffect layer : layers) {
            layer.add(block);
        }
    }

    @Override
    public boolean mayTurn() {
        return layers[0].mayTurn();
    }

    @Override
    public boolean readsOrientation() {
        return layers[0].readsOrientation();
    }

    @Override
    public boolean mayBeStiff() {
        return layers[0].mayBeStiff();
    }
}
