package org.auvsim.diagnosis.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

class GroundTest {
    private static final double G = 9.80665;
    private static final RigidMotion START =
            new RigidMotion(new Vec3(0, 0, 1.1), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

    private static BelievedModel ballOver(String floor, String ball) throws Exception {
        return ballOver(floor, "<half-space/></world-object>", ball);
    }

    private static BelievedModel ballOver(String floor, String objects, String ball)
            throws Exception {
        String xml =
                """
                <scenario>
                  <time-step delta="0.05"/>
                  <world-object name="floor" fixed="1" %s>%s
                  <world-object name="ball" mass="1" restitution="0.5">%s<position x="0" y="0" z="1.1"/>
                    <sphere radius="0.1"/><gravity/></world-object>
                </scenario>
                """
                        .formatted(floor, objects, ball);
        return new BelievedModel(
                ScenarioLoader.load(GroundTest.class.getClassLoader())
                        .parse(xml.getBytes(StandardCharsets.UTF_8)),
                "ball");
    }

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("drop");
        for (int k = 0; k < 15; k++) {
            run.at(0.05 * k);
        }
        return run.build();
    }

    /** Height 0.7 s after a drop from 1 m, the last part of it after a bounce. */
    private static double height(double restitution) {
        double fall = Math.sqrt(2 / G);
        double up = restitution * G * fall;
        double since = 0.7 - fall;
        return 0.1 + up * since - G * since * since / 2;
    }

    @Test
    void variantsBounceOffTheGroundAndNotOffEachOther() throws Exception {
        BelievedModel model = ballOver("", "");
        List<Entrant> balls = new ArrayList<>();
        for (int i = 0; i < 300; i++) {
            double e = 0.3 + 0.002 * i;
            balls.add(new Entrant(model.variant().with(b -> b.restitution(e)), START));
        }
        RigidMotion[][] motions = Ensemble.simulate(model, run(), 0, 14, balls);
        for (int i = 0; i < balls.size(); i++) {
            double e = 0.3 + 0.002 * i;
            assertThat(motions[i][14].position().z()).isCloseTo(height(e), within(2e-3));
        }
    }

    @Test
    void whatTheBodyIgnoresIsNotThere() throws Exception {
        BelievedModel model = ballOver("layer=\"3\"", "<ignores layer=\"3\"/>");
        RigidMotion[][] motions =
                Ensemble.simulate(
                        model, run(), 0, 14, List.of(new Entrant(model.variant(), START)));
        assertThat(motions[0][14].position().z()).isCloseTo(1.1 - G * 0.49 / 2, within(1e-9));
    }

    @Test
    void whatWasMeasuredInTheGroundBeginsUponIt() throws Exception {
        BelievedModel model = ballOver("", "");
        RigidMotion within =
                new RigidMotion(
                        new Vec3(0.3, 0, 0.095), Quat.IDENTITY, new Vec3(1, 0, 0), Vec3.ZERO);
        RigidMotion[] motion =
                Ensemble.simulate(
                        model, run(), 0, 14, List.of(new Entrant(model.variant(), within)))[0];
        assertThat(motion[0].position().x()).isEqualTo(0.3);
        for (RigidMotion at : motion) {
            assertThat(at.position().z()).isCloseTo(0.1, within(1e-5));
        }
    }

    @Test
    void inACornerABodyIsMovedOutOfFloorAndWall() throws Exception {
        String wall =
                """
                <half-space/></world-object>
                <world-object name="wall" fixed="1"><position x="-0.5" y="0" z="0"/>
                  <orientation w="0.7071067811865476" x="0" y="0.7071067811865476" z="0"/><half-space/>
                </world-object>
                """;
        BelievedModel model = ballOver("", wall, "");
        RigidMotion inBoth =
                new RigidMotion(new Vec3(-0.43, 0, 0.07), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        RigidMotion begun = Ground.under(model).beside(model.variant().body().volume(), inBoth);
        assertThat(begun.position().x()).isCloseTo(-0.4, within(1e-12));
        assertThat(begun.position().z()).isCloseTo(0.1, within(1e-12));
    }
}
