package org.auvsim.diagnosis.cause;

import org.auvsim.core.entity.Effect;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/** Whether an effect acts on a body that moves and turns as it does in the runs. */
final class ActingAtOnce {
    /** Share of the speed or rate that a step may change by rounding alone. */
    private static final double ROUNDING = 1e-9;

    private static final Vec3 EACH_WAY = new Vec3(1, 0.7, -0.4);

    private ActingAtOnce() {}

    static boolean on(Setting s, Effect effect) {
        BelievedModel model = s.model();
        Variant believed = model.variant();
        RigidMotion begin = model.start();
        RigidMotion start =
                model.nearestStart(
                        new RigidMotion(
                                begin.position().plus(EACH_WAY.times(s.path().range())),
                                begin.orientation(),
                                EACH_WAY.times(s.path().speed()),
                                EACH_WAY.times(s.rate())));
        RigidMotion[][] motions =
                Ensemble.simulate(
                        model,
                        step(s),
                        0,
                        1,
                        List.of(
                                new Entrant(believed, start),
                                new Entrant(believed.with(b -> b.effect(effect)), start)));
        RigidMotion without = motions[0][1];
        RigidMotion with = motions[1][1];
        return with.velocity().distance(without.velocity()) > ROUNDING * s.path().speed()
                || with.angularVelocity().distance(without.angularVelocity()) > ROUNDING * s.rate();
    }

    private static MeasuredRun step(Setting s) {
        double begin = s.path().begin();
        return MeasuredRun.named("step").at(begin).at(begin + s.timeStep()).build();
    }
}
