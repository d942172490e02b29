package org.auvsim.diagnosis.verdict;

import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;

import java.util.ArrayList;
import java.util.List;

/**
 * The force that a model lacks along a run: by how much the velocity at the beginning of a short
 * window differs from what the model makes of the window before, times mass over time. The mass is
 * that of the body, of what it is known to carry in the run, and of the water that it carries along
 * each of its axes.
 */
final class MissingForce {
    private MissingForce() {}

    /**
     * Before and after, each by windows that follow the run under that model; none once the search
     * was told to stop.
     */
    static List<ForceResidual> along(
            Stepping stepping, Variant after, Misses run, Noise noise, Course course) {
        List<Force> before = forces(new Shooting(stepping, stepping.variant(), run), noise, course);
        List<Force> with =
                after.equals(stepping.variant())
                        ? before
                        : forces(new Shooting(stepping, after, run), noise, course);
        List<ForceResidual> forces = new ArrayList<>();
        for (int w = 0; w < before.size() && course.goesOn(); w++) {
            forces.add(
                    new ForceResidual(
                            before.get(w).time(), before.get(w).lacking(), with.get(w).lacking()));
        }
        return forces;
    }

    /** At a time (s), in N and the world's axes. */
    private record Force(double time, Vec3 lacking) {}

    private static List<Force> forces(Shooting shooting, Noise noise, Course course) {
        List<Window> windows = new Following(shooting, noise, course).shortWindows();
        List<Force> forces = new ArrayList<>();
        for (int w = 0; w + 1 < windows.size(); w++) {
            forces.add(
                    new Force(
                            shooting.of().run().time(windows.get(w).to()),
                            force(shooting, windows.get(w), windows.get(w + 1))));
        }
        return forces;
    }

    private static Vec3 force(Shooting shooting, Window window, Window next) {
        MeasuredRun run = shooting.of().run();
        Vec3 end = shooting.motion(window)[window.length()].velocity();
        double between = (run.time(next.to()) - run.time(window.from())) / 2;
        Vec3 jump = next.start().velocity().minus(end);
        double mass = shooting.variant().body().mass().orElseThrow() + run.differences().mass();
        return moving(mass, shooting.variant().body(), next.start().orientation(), jump)
                .times(1 / between);
    }

    /** Momentum (kg m/s) of a change of velocity, in the world's axes. */
    private static Vec3 moving(
            double mass, WorldObjectDefinition body, Quat orientation, Vec3 velocity) {
        Vec3 added = body.addedMass().map(AddedMass::linear).orElse(Vec3.ZERO);
        Vec3 v = orientation.rotateInverse(velocity);
        return orientation.rotate(
                new Vec3(
                        (mass + added.x()) * v.x(),
                        (mass + added.y()) * v.y(),
                        (mass + added.z()) * v.z()));
    }
}
