package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.OrdinaryWindows;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.fit.StepLength;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;

import java.util.List;
import java.util.function.Function;

/** Looks for the causes that explain what a model misses of measured runs. */
public final class Search {
    /** A model that lacks nothing needs few; how badly another one fits need not be known well. */
    private static final int NONE_STEPS = 8;

    /** Share of the work that is done at its end. */
    public static final double END = 0.9;

    private final BelievedModel model;
    private final List<MeasuredRun> runs;
    private final Noise noise;
    private final Fit base;
    private final List<Cause> library;
    private final Course course;
    private final Way way;

    /** Of a library, in some way. */
    public Search(
            BelievedModel model,
            List<MeasuredRun> runs,
            List<Cause> library,
            Way way,
            Course course) {
        this(model, runs, library, way, course, StepLength::converged);
    }

    private Search(
            BelievedModel model,
            List<MeasuredRun> runs,
            List<Cause> library,
            Way way,
            Course course,
            Function<Fit, Stepping> length) {
        this.model = model;
        this.runs = runs;
        this.noise = Noise.of(runs);
        List<Misses> data = Misses.of(runs, noise);
        course.at("following the runs", 0.02);
        Stepping first = Stepping.longer(model).getFirst();
        Fit asStated = Following.of(first, Hypothesis.NONE, data, noise, course);
        Stepping stepping =
                course.goesOn() ? length.apply(OrdinaryWindows.of(asStated, noise)) : first;
        this.base =
                stepping.fine().equals(model)
                        ? asStated.in(stepping)
                        : Following.again(asStated.in(stepping), noise, course);
        this.library = library;
        this.course = course;
        this.way = way;
    }

    /**
     * What was found.
     *
     * @param none the model as it is believed
     * @param best the best set of causes; that of none if no set is better
     * @param judged all sets, the best first
     * @param competitors sets that explain the runs about as well as the best
     * @param traces what causes leave in the data beside those of the best
     * @param byRun causes of which one explains each run by itself, but of other numbers; usually
     *     none
     * @param misreading whether the runs are told in another way than they were read
     */
    public record Found(
            Judged none,
            Judged best,
            List<Judged> judged,
            List<Judged> competitors,
            Traces traces,
            Noise noise,
            List<Hypothesis> byRun,
            Misreading misreading) {
        /** The model, in steps that are short enough. */
        public Stepping stepping() {
            return none.fit().stepping();
        }

        /** The same, if none of what was found is true. */
        public Found nothing() {
            return new Found(none, none, judged, List.of(), traces, noise, byRun, misreading);
        }

        /** The best, one of its causes left out. */
        public Judged without(int cause) {
            if (best.size() == 1) {
                return none;
            }
            Hypothesis fewer = best.fit().hypothesis().without(cause);
            return judged.stream()
                    .filter(j -> j.fit().hypothesis().causes().equals(fewer.causes()))
                    .findFirst()
                    .orElseGet(() -> fitted(fewer));
        }

        private Judged fitted(Hypothesis hypothesis) {
            Fit fit = best.fit().with(hypothesis, best.fit().windows());
            return Descent.of(fit).steps(Tournament.TO_THE_END);
        }
    }

    /** What is found, again in shorter steps, or in those to each sample, if it would need them. */
    public Found found() {
        Found found = selection().found();
        Fit best = found.best().fit();
        if (!course.goesOn()) {
            return found;
        }
        if (found.best().isWhite() && !StepLength.areFine(best)) {
            return again(found, StepLength.finer(best), StepLength::converged);
        }
        return StepLength.doFor(found.best())
                ? found
                : again(found, model, StepLength::atEachSample);
    }

    private Found again(Found before, BelievedModel stepping, Function<Fit, Stepping> length) {
        return new Search(stepping, runs, library, way, course.more(END), length)
                .selection()
                .foundAgain(before);
    }

    private Selection selection() {
        course.at("fitting the model as it is", 0.1);
        Judged none = begunAnew(nearby(Refinement.approach(base, 1)));
        return new Selection(base, none, noise, library, way, course);
    }

    private Judged nearby(Judged judged) {
        return Descent.of(judged).steps(NONE_STEPS, Double.POSITIVE_INFINITY, course);
    }

    /** From new starts of the runs, if it misses something and less from there. */
    private Judged begunAnew(Judged none) {
        if (none.isWhite() || !course.goesOn()) {
            return none;
        }
        Judged anew = nearby(Judged.of(Following.anew(none.fit(), noise, course)));
        return anew.cost() < none.cost() ? anew : none;
    }
}
