package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/**
 * A boat that goes round under way, its place fixed once a second and its heading and rate of
 * turning ten times as often.
 */
class SparseFixesTest {
    private static final int SAMPLES = 334;
    private static final String BOAT =
            """
            <scenario><time-step delta="0.05"/>
              <world-object name="Boat" mass="80">
                <box><size x="1.8" y="0.9" z="0.4"/></box>
                <inertia xx="8" yy="25" zz="30"/>
                <added-mass><linear x="10" y="40" z="0"/><angular x="0" y="0" z="8"/></added-mass>
                <held z="1" turn-x="1" turn-y="1"/>
                <damping><linear x="15" y="55" z="0"/><quadratic x="22" y="130" z="0"/>
                  <angular-linear x="0" y="0" z="18"/><angular-quadratic x="0" y="0" z="12"/></damping>
                <propulsor name="port" maximum-thrust="80">
                  <position x="-0.8" y="0.35" z="0"/></propulsor>
                <propulsor name="starboard" maximum-thrust="80">
                  <position x="-0.8" y="-0.35" z="0"/></propulsor>
              </world-object>
            </scenario>
            """;

    private static final RigidMotion START =
            new RigidMotion(
                    new Vec3(-0.3, 3.4, 0),
                    Quat.ofAxisAngle(new Vec3(0, 0, 1), 1.2),
                    new Vec3(0.9, 0.7, 0),
                    new Vec3(0, 0, 0.8));

    private static MeasuredRun measured(RigidMotion[] motion) {
        Random random = new Random(66);
        MeasuredRunBuilder run =
                MeasuredRun.named("boat")
                        .commands(List.of("port", "starboard"))
                        .frame(Channel.ANGULAR_VELOCITY, Frame.BODY);
        for (int k = 0; k < SAMPLES; k++) {
            run.at(0.1 * k).command(0, 0.5).command(1, k < 120 ? 0.7 : 0.4);
            if (motion.length > 0) {
                Vec3 p = motion[k].position();
                double rate = motion[k].angularVelocity().z();
                boolean isFix = k % 10 == 0;
                Quat off = Quat.ofAxisAngle(new Vec3(0, 0, 1), 0.01 * random.nextGaussian());
                run.position(
                                isFix ? p.x() + 0.15 * random.nextGaussian() : Double.NaN,
                                isFix ? p.y() + 0.15 * random.nextGaussian() : Double.NaN,
                                Double.NaN)
                        .orientation(off.times(motion[k].orientation()), false, false, true)
                        .measured(
                                Channel.ANGULAR_VELOCITY,
                                Double.NaN,
                                Double.NaN,
                                rate + 0.01 * random.nextGaussian());
            }
        }
        return run.build();
    }

    @Test
    void theModelThatIsRightFollowsAllTheWay() throws Exception {
        BelievedModel model = Believed.model(BOAT, "Boat");
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        measured(new RigidMotion[0]),
                        0,
                        SAMPLES - 1,
                        List.of(new Ensemble.Entrant(model.variant(), START)))[0];
        List<MeasuredRun> runs = List.of(measured(motion));
        Noise noise = Noise.of(runs);

        Fit fit =
                Following.of(Stepping.exact(model), Hypothesis.NONE, Misses.of(runs, noise), noise);

        List<Window> windows = fit.windows().getFirst();
        assertThat(windows).hasSize(1);
        assertThat(windows.getFirst().start().velocity().distance(START.velocity()))
                .isLessThan(0.1);
    }
}
