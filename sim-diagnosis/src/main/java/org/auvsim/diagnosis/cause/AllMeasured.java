package org.auvsim.diagnosis.cause;

import org.auvsim.core.entity.Actuator;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;

import java.util.Collections;
import java.util.List;

/** A run in which all is measured and told that can be of a body: no cause is left out for it. */
final class AllMeasured {
    private static final int SAMPLES = 40;
    private static final double DEVIATION = 0.1;

    private AllMeasured() {}

    static MeasuredRun of(BelievedModel model) {
        List<String> actuators =
                model.variant().body().component().stream()
                        .filter(Actuator.class::isInstance)
                        .map(component -> ((Actuator) component).name())
                        .toList();
        MeasuredRunBuilder run = MeasuredRun.named("all").commands(actuators);
        Vec3 ahead = new Vec3(1, 0.5, 0.2);
        for (int k = 0; k < SAMPLES; k++) {
            run.at(k)
                    .position(k * ahead.x(), k * ahead.y(), k * ahead.z())
                    .orientation(Quat.ofAxisAngle(ahead.normalized(), k))
                    .measured(Channel.VELOCITY, ahead.x(), ahead.y(), ahead.z())
                    .measured(Channel.ANGULAR_VELOCITY, ahead.x(), ahead.y(), ahead.z());
            for (int i = 0; i < actuators.size(); i++) {
                run.command(i, DEVIATION);
            }
        }
        RigidMotion spinning = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, ahead, ahead);
        return run.start(new KnownStart(spinning, Collections.nCopies(RigidMotion.SIZE, DEVIATION)))
                .build();
    }
}
