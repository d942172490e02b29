package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.LocalMotion;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Growth;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;

/**
 * Runs in parts over which what was measured can be followed in one go. What nothing steadies, as a
 * torpedo's heading under the rudder of an autopilot that was recorded, goes elsewhere by the
 * slightest error of a start; over a long run no fit finds a start that is right enough.
 *
 * @param runs those that are steady as they are, and parts of the others, each with a start of its
 *     own
 * @param notices which were cut, and why
 */
public record SteadyParts(List<MeasuredRun> runs, List<String> notices) {
    /** Where errors grow by more over a run, it is no run to be followed in one go. */
    private static final double FAR = 1e3;

    /** Over a part of it they grow by so much at most, if they grow evenly. */
    private static final double NEAR = 100;

    private static final int MOST = 8;

    /**
     * Windows lead to one another where these gaps between them (rad, root mean square) are less.
     */
    private static final double MOST_TURN = 0.2;

    /** The same of velocities, as a share of the speed. */
    private static final double MOST_OFF = 0.5;

    /** Larger numbers are told by their power of ten. */
    private static final int MOST_DIGITS = 6;

    /** Of runs by the model as it is believed; those that were cut before are left as they are. */
    public static SteadyParts of(BelievedModel model, List<MeasuredRun> runs, Course course) {
        List<MeasuredRun> begun = runs.stream().map(run -> LocalMotion.begun(run, model)).toList();
        Noise noise = Noise.of(begun);
        Stepping stepping = Stepping.longer(model).getFirst();
        Fit following =
                Following.of(stepping, Hypothesis.NONE, Misses.of(begun, noise), noise, course);
        List<List<WindowDerivatives>> alongRuns = following.derivatives(Moves.NONE);
        List<List<WindowDerivatives>> inOneGo = following.whole().derivatives(Moves.NONE);
        List<MeasuredRun> steady = new ArrayList<>();
        List<String> notices = new ArrayList<>();
        for (int r = 0; r < runs.size(); r++) {
            MeasuredRun run = runs.get(r);
            double growth = growth(alongRuns.get(r), inOneGo.get(r));
            int count = growth > FAR && !run.isPart() ? count(run, growth) : 1;
            steady.addAll(run.parts(count));
            if (count > 1) {
                notices.add(words(run, growth, count));
            }
        }
        return new SteadyParts(steady, notices);
    }

    /**
     * Along what was measured; but where the windows that follow it lead elsewhere than to one
     * another, as those of a noisy run do, they say nothing of how the body moves. Then where the
     * model goes by itself, if that is less.
     */
    private static double growth(
            List<WindowDerivatives> alongRun, List<WindowDerivatives> inOneGo) {
        double along = Growth.of(alongRun);
        return areChained(alongRun) || inOneGo.getFirst().isLost()
                ? along
                : Math.min(along, Growth.of(inOneGo));
    }

    private static boolean areChained(List<WindowDerivatives> windows) {
        double turns = 0;
        double speedsOff = 0;
        double speeds = 0;
        for (int w = 1; w < windows.size(); w++) {
            RigidMotion start = windows.get(w).window.start();
            double[] gap = windows.get(w - 1).end.minus(start);
            turns += square(gap, 3);
            speedsOff += square(gap, 6);
            speeds += start.velocity().dot(start.velocity());
        }
        double mostTurns = MOST_TURN * MOST_TURN * (windows.size() - 1);
        return turns <= mostTurns && speedsOff <= MOST_OFF * MOST_OFF * speeds;
    }

    /** Of three numbers from one on. */
    private static double square(double[] numbers, int from) {
        double sum = 0;
        for (int i = from; i < from + 3; i++) {
            sum += numbers[i] * numbers[i];
        }
        return sum;
    }

    private static int count(MeasuredRun run, double growth) {
        double enough = Math.ceil(StrictMath.log(growth) / StrictMath.log(NEAR));
        int most = Math.clamp(run.size() / MeasuredRun.FEWEST, 1, MOST);
        return (int) Math.min(enough, most);
    }

    private static String words(MeasuredRun run, double growth, int count) {
        return "%s: an error of its start grows more than %s-fold over it, so it is taken in %d parts of %s s, each with a start of its own"
                .formatted(
                        run.name(),
                        atLeast(growth),
                        count,
                        Numbers.rounded(run.duration() / count));
    }

    /** The power of ten below. */
    private static String atLeast(double growth) {
        int digits = (int) Math.floor(StrictMath.log10(growth));
        return digits > MOST_DIGITS ? "1e" + digits : "1" + "0".repeat(digits);
    }
}
