package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.List;
import java.util.stream.Stream;

/** Each cause moves a body as docs/causes.md says, by equations written down once more here. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
abstract class CauseEquationsContract {
    private static final int SAMPLES = 41;
    private static final double END = (SAMPLES - 1) * Tank.SPACING;

    /** Causes of some families. */
    abstract Stream<CauseCase> cases();

    /** What the port and the starboard thruster are told. */
    double[] levels() {
        return new double[] {0.6, 0.4};
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("cases")
    void movesTheBodyAsItsEquationSays(CauseCase c) {
        BelievedModel model = Tank.model("", c.believed());
        Cause cause =
                Library.of(model, List.of(commanded(Tank.run(model, SAMPLES)))).stream()
                        .filter(one -> one.id().equals(c.id()))
                        .filter(one -> one.subject().orElse("").equals(c.subject()))
                        .findFirst()
                        .orElseThrow();
        Variant variant = cause.in(model.variant(), c.theta(cause));
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        commanded(Tank.times(SAMPLES)),
                        0,
                        SAMPLES - 1,
                        List.of(new Ensemble.Entrant(variant, Tank.START)))[0];
        double[] expected = c.equations().after(END, numbers(Tank.START));
        double[] actual = numbers(motion[SAMPLES - 1]);
        for (int i = 0; i < expected.length; i++) {
            assertThat(Math.abs(actual[i] - expected[i])).as("number %s", i).isLessThan(c.error());
        }
    }

    /** The same run, in which the thrusters are told something. */
    private MeasuredRun commanded(MeasuredRun run) {
        MeasuredRunBuilder told = MeasuredRun.named("told").commands(List.of("port", "starboard"));
        for (int k = 0; k < run.size(); k++) {
            told.at(run.time(k)).command(0, levels()[0]).command(1, levels()[1]);
            run.vector(Channel.POSITION, k).ifPresent(p -> told.position(p.x(), p.y(), p.z()));
            run.orientation(k).ifPresent(told::orientation);
        }
        return told.build();
    }

    private static double[] numbers(RigidMotion m) {
        var w = m.orientation().rotateInverse(m.angularVelocity());
        return new double[] {
            m.position().x(),
            m.position().y(),
            m.position().z(),
            m.orientation().w(),
            m.orientation().x(),
            m.orientation().y(),
            m.orientation().z(),
            m.velocity().x(),
            m.velocity().y(),
            m.velocity().z(),
            w.x(),
            w.y(),
            w.z()
        };
    }
}
