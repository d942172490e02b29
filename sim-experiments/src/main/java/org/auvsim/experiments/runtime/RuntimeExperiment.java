package org.auvsim.experiments.runtime;

import org.auvsim.experiments.Conduct;
import org.auvsim.experiments.ThesisExperiment;
import org.auvsim.experiments.thesis.StageCost;
import org.auvsim.experiments.workload.Targets;
import org.auvsim.experiments.workload.Workload;
import org.auvsim.plot.page.Report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Cubes of 10, 20, .., 100 spheres that are driven together (thesis, section 8.2). */
public final class RuntimeExperiment implements ThesisExperiment {
    private static final double QUICK_SECONDS = 2;
    private static final int STEP = 10;

    /** Bodies, and world time (s), of the cube whose size is watched. */
    private static final int WATCHED = 27;

    private static final double WATCHED_SECONDS = 60;

    @Override
    public Optional<Report> run(Conduct conduct) {
        double seconds = conduct.quick() ? QUICK_SECONDS : StageCost.WORLD_SECONDS;
        conduct.tell("a first run that is not counted, in which the machine code gets ready");
        Measured.of(Workload.of(STEP), seconds, conduct);
        List<Measured> own = measure(Targets.OWN, seconds, conduct);
        List<Measured> common = measure(Targets.COMMON, seconds, conduct);
        if (conduct.isStopped()) {
            return Optional.empty();
        }
        CubeSize watched = CubeSize.watch(Workload.of(WATCHED), WATCHED_SECONDS);
        return Optional.of(new RuntimeReport(seconds, own, common, watched).report());
    }

    private static List<Measured> measure(Targets targets, double seconds, Conduct conduct) {
        List<Measured> measured = new ArrayList<>();
        int most = conduct.quick() ? 5 * STEP : 10 * STEP;
        for (int n = STEP; n <= most && !conduct.isStopped(); n += STEP) {
            conduct.tell(
                    "%d spheres, %s, %s s of world time with both steppers"
                            .formatted(
                                    n,
                                    targets == Targets.OWN ? "targets of their own" : "one target",
                                    seconds));
            measured.add(Measured.of(Workload.of(n).withTargets(targets), seconds, conduct));
        }
        return measured;
    }
}
