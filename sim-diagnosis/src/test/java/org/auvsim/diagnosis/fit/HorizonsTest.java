package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.HorizonGain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Objects;

class HorizonsTest {
    /** A motor of 0.8 of the thrust that is believed: the further ahead, the further off. */
    @Test
    void whatIsMissedGrowsWithTimeAheadUnlessItWasFound() throws Exception {
        Cart cart = new Cart(0.8, 1e-5, 0);
        List<MeasuredRun> runs = List.of(cart.run());
        Trial trial = new Trial(Stepping.exact(Cart.believed()), runs, Noise.of(runs));
        Hypothesis weaker =
                new Hypothesis(List.of(cart.cause("thruster_gain")), List.of(new double[] {-0.2}));
        List<HorizonGain> gains = trial.horizons(weaker.in(Cart.believed().variant()));

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
        other.add(Channel.POSITION, 0, Double.NaN);
        HorizonErrors both = one.plus(other);
        assertThat(both.of(Channel.POSITION, 0).orElseThrow())
                .isCloseTo(Math.sqrt(14.0 / 3), within(1e-15));
        assertThat(both.of(Channel.ORIENTATION, 1)).hasValue(0.1);
        assertThat(both.of(Channel.POSITION, 1)).isEmpty();
        assertThat(both.of(Channel.VELOCITY, 0)).isEmpty();
        assertThat(one.of(Channel.POSITION, 0)).hasValue(Math.sqrt(5));
    }
}
