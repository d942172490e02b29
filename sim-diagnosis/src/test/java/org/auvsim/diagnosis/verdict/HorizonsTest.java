package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.IntStream;

class HorizonsTest {
    /** A motor of 0.8 of the thrust that is believed: the further ahead, the further off. */
    @Test
    void whatIsMissedGrowsWithTimeAheadUnlessItWasFound() throws Exception {
        Cart cart = new Cart(0.8, 1e-5, 0);
        List<MeasuredRun> runs = List.of(cart.run());
        Trial trial = new Trial(Stepping.exact(Cart.believed()), runs, Noise.of(runs));
        Hypothesis weaker =
                new Hypothesis(List.of(cart.cause("thruster_gain")), List.of(new double[] {-0.2}));
        List<HorizonGain> gains =
                trial.horizons(trial.prediction(weaker), weaker.in(Cart.believed().variant()));

        assertThat(gains).hasSizeGreaterThan(2);
        assertThat(gains)
                .extracting(HorizonsTest::ofPosition)
                .allSatisfy(gain -> assertThat(gain.after()).isLessThan(2 * gain.noise()));
        Gain nearest = ofPosition(gains.getFirst());
        Gain furthest = ofPosition(gains.getLast());
        assertThat(furthest.before()).isGreaterThan(10 * nearest.before());
        assertThat(furthest.before()).isGreaterThan(100 * furthest.after());
        assertThat(gains.getFirst().ahead()).isLessThan(gains.getLast().ahead());
    }

    private static Gain ofPosition(HorizonGain of) {
        return Objects.requireNonNull(of.errors().get(Channel.POSITION));
    }

    @Test
    void everyNumberCountsOfEveryChannelForItself() {
        HorizonErrors one = new HorizonErrors(2);
        one.add(Channel.POSITION, 0, 3);
        one.add(Channel.POSITION, 0, -1);
        one.add(Channel.ORIENTATION, 1, 0.1);
        HorizonErrors other = new HorizonErrors(2);
        other.add(Channel.POSITION, 0, 2);
        HorizonErrors both = one.plus(other);
        assertThat(both.of(Channel.POSITION, 0).orElseThrow())
                .isCloseTo(Math.sqrt(14.0 / 3), within(1e-15));
        assertThat(both.of(Channel.ORIENTATION, 1)).hasValue(0.1);
        assertThat(both.of(Channel.POSITION, 1)).isEmpty();
        assertThat(both.of(Channel.VELOCITY, 0)).isEmpty();
        assertThat(one.of(Channel.POSITION, 0)).hasValue(Math.sqrt(5));

        other.add(Channel.POSITION, 0, Double.NaN);
        assertThat(one.plus(other).of(Channel.POSITION, 0))
                .as("of one model that got lost")
                .hasValue(Double.POSITIVE_INFINITY);
    }

    /** The faster it goes, the more the water pushes it on (N s/m). */
    private record Pushing(double coefficient) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            block.addForce(i, block.velocity(i).times(coefficient));
        }
    }

    /** Of ten times the speed after every 1.2 s: after 20 s it is nowhere. */
    @Test
    void whereAModelGetsLostItsErrorHasNoBounds() throws Exception {
        World world =
                World.builder()
                        .timeStep(0.05)
                        .add(
                                Cart.believed()
                                        .variant()
                                        .with(body -> body.effect(new Pushing(20)))
                                        .body())
                        .build();
        BelievedModel pushed = new BelievedModel(Scenario.of(world), "cart");
        List<MeasuredRun> runs = List.of(new Cart(1, 1e-5, 0).run());
        Trial trial = new Trial(Stepping.exact(pushed), runs, Noise.of(runs));

        List<HorizonGain> gains =
                trial.horizons(trial.prediction(Hypothesis.NONE), Cart.believed().variant());

        assertThat(ofPosition(gains.getFirst()).before()).isFinite();
        assertThat(ofPosition(gains.getLast()).before()).isInfinite();
        assertThat(gains)
                .extracting(HorizonsTest::ofPosition)
                .allSatisfy(gain -> assertThat(gain.after()).isFinite());
    }

    /** Sums depend on their order in their last digits. */
    @Test
    void theNumberOfProcessorsMakesNoDifference() throws Exception {
        MeasuredRun run = new Cart(0.8, 1e-5, 0).run();
        List<MeasuredRun> runs =
                IntStream.range(0, 13)
                        .mapToObj(i -> run.part("part " + i, 30 * i, 30 * i + 29))
                        .toList();
        Trial trial = new Trial(Stepping.exact(Cart.believed()), runs, Noise.of(runs));
        Judged prediction = trial.prediction(Hypothesis.NONE);
        Variant believed = Cart.believed().variant();

        List<List<HorizonGain>> gains = new ArrayList<>();
        for (int processors : List.of(1, 2, 8)) {
            try (ForkJoinPool pool = new ForkJoinPool(processors)) {
                gains.add(pool.submit(() -> trial.horizons(prediction, believed)).get());
            }
        }

        assertThat(gains.getFirst()).isNotEmpty();
        assertThat(gains).containsOnly(gains.getFirst());
    }
}
