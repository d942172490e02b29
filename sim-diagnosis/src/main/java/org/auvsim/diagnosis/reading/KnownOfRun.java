package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.Run;
import org.auvsim.auvsml.run.RunStart;
import org.auvsim.auvsml.run.RunStart.KnownOrientation;
import org.auvsim.auvsml.run.RunStart.KnownVector;
import org.auvsim.auvsml.run.TimedPush;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.KnownDifferences;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.run.ScheduledForce;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Tells runs what is stated of them: by the document beside their file, or else of all runs. */
final class KnownOfRun {
    private final Run run;
    private final Optional<RunStart> start;
    private boolean hasBegun;

    /** By the document of a run, and how runs begin whose document does not say so. */
    KnownOfRun(Run run, Optional<RunStart> usualStart) {
        this.run = run;
        this.start = run.start().or(() -> usualStart);
    }

    /** What follows is another run, which begins as stated, too. */
    void restart() {
        hasBegun = false;
    }

    /** Tells the next part; the start is that of the first of a run. */
    void tell(MeasuredRunBuilder part) {
        if (!hasBegun) {
            start.map(KnownOfRun::start).ifPresent(part::start);
        }
        hasBegun = true;
        run.scheduledForce().stream().map(KnownOfRun::force).forEach(part::force);
        run.differences()
                .map(d -> new KnownDifferences(d.mass(), d.effect(), d.currents()))
                .ifPresent(part::differences);
    }

    private static ScheduledForce force(TimedPush push) {
        return new ScheduledForce(
                push.from(),
                push.until(),
                new NamedForce(push.name(), push.frame(), push.vector(), push.point()));
    }

    private static KnownStart start(RunStart start) {
        List<Double> deviations = new ArrayList<>();
        add(start.position().map(KnownVector::deviation), deviations);
        add(start.orientation().map(KnownOrientation::deviation), deviations);
        add(start.velocity().map(KnownVector::deviation), deviations);
        add(start.angularVelocity().map(KnownVector::deviation), deviations);
        return new KnownStart(
                new RigidMotion(
                        vector(start.position()),
                        start.orientation().map(KnownOrientation::quaternion).orElse(Quat.IDENTITY),
                        vector(start.velocity()),
                        vector(start.angularVelocity())),
                deviations);
    }

    private static Vec3 vector(Optional<KnownVector> known) {
        return known.map(KnownVector::vector).orElse(Vec3.ZERO);
    }

    private static void add(Optional<Double> deviation, List<Double> to) {
        for (int axis = 0; axis < 3; axis++) {
            to.add(deviation.orElse(Double.POSITIVE_INFINITY));
        }
    }
}
