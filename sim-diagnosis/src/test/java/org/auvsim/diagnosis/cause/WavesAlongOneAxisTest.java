package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/**
 * Waves along the one axis on which a body goes: the equation of docs/causes.md, by another
 * integrator.
 */
class WavesAlongOneAxisTest {
    private static final double SINE = 30;
    private static final double COSINE = -20;
    private static final double OMEGA = 3;
    private static final int SAMPLES = 61;

    /** Waves that run along the axis, against it, or are the same everywhere. */
    @ParameterizedTest
    @ValueSource(doubles = {1, -1, 0})
    void move(double dispersion) {
        BelievedModel model =
                Tank.model("", "<held y=\"1\" z=\"1\" turn-x=\"1\" turn-y=\"1\" turn-z=\"1\"/>");
        Cause waves =
                Library.of(model, List.of(Tank.run(model, SAMPLES))).stream()
                        .filter(cause -> cause.id().equals("wave_forcing"))
                        .findFirst()
                        .orElseThrow();
        double[] theta = {SINE, COSINE, OMEGA, dispersion};

        RigidMotion[] moved = Tank.motion(model, waves.in(model.variant(), theta), SAMPLES);

        double end = (SAMPLES - 1) * Tank.SPACING;
        double[] expected = after(end, dispersion * OMEGA * OMEGA / 9.80665);
        assertThat(moved[SAMPLES - 1].position().x()).isCloseTo(expected[0], within(2e-5));
        assertThat(moved[SAMPLES - 1].velocity().x()).isCloseTo(expected[1], within(2e-5));
        assertThat(told(waves, theta, "amplitude"))
                .isCloseTo(Math.sqrt(SINE * SINE + COSINE * COSINE), within(1e-12));
        assertThat(told(waves, theta, "wave_number"))
                .isCloseTo(dispersion * OMEGA * OMEGA / 9.80665, within(1e-12));
    }

    private static double told(Cause cause, double[] theta, String name) {
        return cause.quantities(theta).stream()
                .filter(quantity -> quantity.name().equals(name))
                .mapToDouble(Quantity::value)
                .findFirst()
                .orElseThrow();
    }

    /** Place and speed. */
    private static double[] after(double seconds, double waveNumber) {
        double[] y = {Tank.START.position().x(), Tank.START.velocity().x()};
        FirstOrderDifferentialEquations newton =
                new FirstOrderDifferentialEquations() {
                    @Override
                    public int getDimension() {
                        return 2;
                    }

                    @Override
                    public void computeDerivatives(double t, double[] at, double[] rate) {
                        double angle = OMEGA * t - waveNumber * at[0];
                        rate[0] = at[1];
                        rate[1] =
                                (SINE * Math.sin(angle) + COSINE * Math.cos(angle))
                                        / CauseCase.MASS;
                    }
                };
        new DormandPrince853Integrator(1e-9, 0.05, 1e-11, 1e-11)
                .integrate(newton, 0, y, seconds, y);
        return y;
    }
}
