package org.auvsim.core.contact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RestitutionRuleTest {
    private static final double GRAVITY = 9.81;

    @ParameterizedTest(name = "approach {0}, restitution {1}, repeats {2}: {3}, {4} m/s")
    @CsvSource({
        "2,     0.5,  0, RESTITUTION,             1",
        "2,     0.5,  1, ELASTIC_IN_CONTACT_TIME, 2",
        "2,     0.5,  2, REST_AS_REPEATED,        0",
        "2,     0.5,  4, REST_AS_REPEATED,        0",
        "0.098, 0.5,  0, REST_AS_SLOW,            0",
        "0.098, 0.5,  1, REST_AS_SLOW,            0",
        "0.102, 0.5,  0, RESTITUTION,             0.051",
        "9,     0,    0, REST_AS_SLOW,            0",
        "2e-6,  1,    0, RESTITUTION,             2e-6",
        "2e-6,  1,  100, ELASTIC_IN_CONTACT_TIME, 2e-6",
        "2e-6,  1,  101, REST_AS_REPEATED,        0",
        "9e-7,  1,    0, REST_AS_SLOW,            0"
    })
    void aPairPartsByTheRuleThatHolds(
            double approach, double restitution, int repeats, Bounce expected, double target) {
        Bounce bounce = RestitutionRule.of(restitution).decide(approach, restitution, repeats);
        assertThat(bounce).isEqualTo(expected);
        assertThat(bounce.target(approach, restitution)).isCloseTo(target, within(1e-15));
        assertThat(bounce.rests()).isEqualTo(target == 0);
    }

    @Test
    void onlyHitsOnTopOfEachOtherAreCounted() {
        RestitutionRule rule = RestitutionRule.INELASTIC;
        int first = rule.repeats(Double.POSITIVE_INFINITY, 0);
        int second = rule.repeats(0.009, first);
        int third = rule.repeats(0.009, second);
        int later = rule.repeats(0.011, third);
        assertThat(new int[] {first, second, third, later}).containsExactly(0, 1, 2, 0);
    }

    /** A ball that is dropped: with an unruled restitution it hits infinitely often. */
    @ParameterizedTest(name = "restitution {0}")
    @ValueSource(doubles = {0, 0.1, 0.5, 0.9, 0.99})
    void aDroppedBallComesToRestAndNeverGainsSpeed(double restitution) {
        RestitutionRule rule = RestitutionRule.of(restitution);
        double speed = 5;
        double since = Double.POSITIVE_INFINITY;
        int repeats = 0;
        int hits = 0;
        while (speed > 0) {
            repeats = rule.repeats(since, repeats);
            double next = rule.decide(speed, restitution, repeats).target(speed, restitution);
            assertThat(next).isLessThanOrEqualTo(speed);
            since = 2 * next / GRAVITY;
            speed = next;
            assertThat(++hits).isLessThan(700);
        }
    }

    @Test
    void anElasticBallGoesOnHittingTheFloor() {
        RestitutionRule rule = RestitutionRule.of(1);
        int repeats = 0;
        for (int hit = 0; hit < 10_000; hit++) {
            repeats = rule.repeats(2 * 1e-3 / GRAVITY, repeats);
            assertThat(rule.decide(1e-3, 1, repeats)).isEqualTo(Bounce.RESTITUTION);
        }
    }

    @Test
    void impossibleNumbersAreRefused() {
        assertThatThrownBy(() -> new RestitutionRule(-1, 0, 3))
                .hasMessageContaining("not -1.0, 0.0 and 3.");
        assertThatThrownBy(() -> new RestitutionRule(0, Double.NaN, 3))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new RestitutionRule(0, 0, -1))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
