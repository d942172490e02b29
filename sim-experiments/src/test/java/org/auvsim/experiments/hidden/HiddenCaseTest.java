package org.auvsim.experiments.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.Collections;
import java.util.List;

class HiddenCaseTest {
    /** One of whose thrusters points elsewhere. */
    private static final HiddenCase TURNED = CaseBook.draw(CaseKind.SINGLE, 0.01, 22);

    private static Finding found(HiddenEffect effect, String... numbers) {
        List<Quantity> quantities =
                List.of(numbers).stream().map(name -> new Quantity(name, "rad", 0.1)).toList();
        return new Finding(effect.cause(), effect.subject(), quantities, List.of(), 1, true);
    }

    @Test
    void aPredictionThatGetsLostIsInfinitelyFarOff() {
        RigidMotion lost =
                new RigidMotion(new Vec3(Double.NaN, 0, 0), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        int samples = TURNED.heldOut().getFirst().size();

        assertThat(TURNED.error(0, Collections.nCopies(samples, lost)))
                .isEqualTo(Double.POSITIVE_INFINITY);
    }

    @Test
    void anotherNumberOfTheSameCauseIsNoHit() {
        HiddenEffect angle = TURNED.hidden().getFirst();

        assertThat(angle.cause()).isEqualTo("thruster_misalignment");
        assertThat(TURNED.isHit(angle, found(angle, "angle"))).isTrue();
        assertThat(TURNED.isHit(angle, found(angle, "tilt"))).isFalse();
        assertThat(TURNED.isHit(angle, found(angle))).isFalse();
    }
}
