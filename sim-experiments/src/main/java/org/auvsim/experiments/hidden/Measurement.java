package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.run.ScheduledForce;
import org.auvsim.experiments.hidden.Manoeuvre.TimedPush;
import org.auvsim.experiments.hidden.Manoeuvre.Track;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * Measures runs.
 *
 * @param away noise of positions (m)
 * @param turned noise of attitudes (rad); 0: they are not measured
 * @param isHeavyTailed whether large errors come often (Student's t)
 */
record Measurement(double away, double turned, boolean isHeavyTailed) {
    MeasuredRun of(String name, List<Pose> poses, Manoeuvre done, KnownStart start, Draws draws) {
        MeasuredRunBuilder run =
                MeasuredRun.named(name)
                        .commands(done.commands().stream().map(Track::name).toList())
                        .start(start);
        for (int k = 0; k < poses.size(); k++) {
            Vector3D p = poses.get(k).position().add(errors(away, draws));
            run.at(done.time(k)).position(p.getX(), p.getY(), p.getZ());
            Attitude error = Attitude.turned(errors(turned, draws));
            if (turned > 0) {
                run.orientation(quat(error.after(poses.get(k).attitude())));
            }
            for (int c = 0; c < done.commands().size(); c++) {
                run.command(c, done.commands().get(c).level(k));
            }
        }
        for (int i = 0; i < done.pushes().size(); i++) {
            TimedPush push = done.pushes().get(i);
            run.force(
                    new ScheduledForce(
                            push.from(),
                            push.until(),
                            new NamedForce(
                                    "push " + i,
                                    Frame.WORLD,
                                    vec(push.force()),
                                    vec(push.point()))));
        }
        return run.build();
    }

    private Vector3D errors(double deviation, Draws draws) {
        return isHeavyTailed
                ? new Vector3D(draws.heavyTailed(), draws.heavyTailed(), draws.heavyTailed())
                        .scalarMultiply(deviation)
                : draws.normals(deviation);
    }

    static RigidMotion motion(Instant at) {
        return new RigidMotion(
                vec(at.position()),
                quat(at.attitude()),
                vec(at.velocity()),
                vec(at.turningInWorld()));
    }

    static Vec3 vec(Vector3D v) {
        return new Vec3(v.getX(), v.getY(), v.getZ());
    }

    static Quat quat(Attitude a) {
        return new Quat(a.w(), a.x(), a.y(), a.z());
    }
}
