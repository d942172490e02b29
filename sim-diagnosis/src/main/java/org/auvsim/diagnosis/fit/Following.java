package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.LocalMotion;
import org.auvsim.diagnosis.residual.Looseness;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowBlock;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * Cuts a run into windows in which the model follows the measurement: many short ones at first,
 * then twice as long ones, as long as the model can follow. A model without faults needs one
 * window; one that lacks much keeps many.
 */
public final class Following {
    private static final int MOST_WINDOWS = 32;

    /** Of a window; if fixes of its place alone tell how fast it begins, so many of them. */
    private static final int FEWEST_SAMPLES = 8;

    /** A run that is followed in one go is so by these parts of it. */
    private static final List<Integer> PARTS = List.of(8, 4, 2, 1);

    private static final int MOST_ITERATIONS = 12;
    private static final int FEW_ITERATIONS = 4;

    private static final int MOST_HALVINGS = 6;

    /** A window follows if its misses, without the noise, are below the larger of these. */
    private static final double SHARE_OF_RANGE = 0.003;

    /** The same of rates, which a model misses by more than by where they lead. */
    private static final double SHARE_OF_RATES = 0.03;

    private static final double SHARE_OF_NOISE = 0.7;
    private static final double TURN = 0.06;

    /** A window misses far more than noise if chi squared a number is above this. */
    private static final double FAR_OFF = 4;

    /** A share of the cost that is not worth a step, and what is not of any: noise does more. */
    private static final double ENOUGH = 1e-4;

    private static final double LITTLE = 0.3;

    /** A step that leads on takes away this share of the cost. */
    private static final double ON_ITS_WAY = 0.25;

    private final Shooting shooting;
    private final BelievedModel model;
    private final MeasuredRun run;
    private final Misses data;
    private final Noise noise;
    private final Course course;
    private final List<Double> looseness;

    /** Of one run under a variant of the model. */
    public Following(Shooting shooting, Noise noise) {
        this(shooting, noise, Course.UNHEARD);
    }

    /** The same, as far as it has come once it was told to stop. */
    public Following(Shooting shooting, Noise noise, Course course) {
        this.shooting = shooting;
        this.model = shooting.stepping().model();
        this.data = shooting.of();
        this.run = data.run();
        this.noise = noise;
        this.course = course;
        this.looseness = Looseness.of(run, noise);
    }

    /** Windows that follow runs under a hypothesis. */
    public static Fit of(Stepping stepping, Hypothesis hypothesis, List<Misses> data, Noise noise) {
        return of(stepping, hypothesis, data, noise, Course.UNHEARD);
    }

    /** The same, as far as it has come once it was told to stop. */
    public static Fit of(
            Stepping stepping,
            Hypothesis hypothesis,
            List<Misses> data,
            Noise noise,
            Course course) {
        List<List<Window>> windows =
                data.parallelStream()
                        .map(run -> of(stepping, hypothesis, run, noise, course))
                        .toList();
        return new Fit(stepping, data, hypothesis, windows, Knowledge.NONE);
    }

    /**
     * A fit of the same runs in other steps: by its windows, from where they begin, if the model
     * follows in them here, too; or else by new ones.
     */
    public static Fit again(Fit of, Noise noise, Course course) {
        List<List<Window>> windows =
                IntStream.range(0, of.data().size())
                        .parallel()
                        .mapToObj(r -> again(of, r, noise, course))
                        .toList();
        return of.with(of.hypothesis(), windows);
    }

    private static List<Window> again(Fit of, int run, Noise noise, Course course) {
        return new Following(of.shooting(of.data().get(run)), noise, course)
                .fitted(of.windows().get(run))
                .orElseGet(
                        () ->
                                of(
                                        of.stepping(),
                                        of.hypothesis(),
                                        of.data().get(run),
                                        noise,
                                        course));
    }

    /** Windows from where these begin, if the model follows in them. */
    private Optional<List<Window>> fitted(List<Window> windows) {
        List<Fitted> fitted =
                windows.parallelStream()
                        .map(w -> fit(w, near(w.from(), w.start()), MOST_ITERATIONS))
                        .toList();
        return Optional.of(fitted)
                .filter(this::follows)
                .map(all -> all.stream().map(Fitted::window).toList());
    }

    /** A fit of whole runs, those of them begun anew that miss less so. */
    public static Fit anew(Fit of, Noise noise, Course course) {
        List<List<Window>> windows =
                IntStream.range(0, of.data().size())
                        .parallel()
                        .mapToObj(
                                r ->
                                        new Following(of.shooting(of.data().get(r)), noise, course)
                                                .anew(of.windows().get(r).getFirst()))
                        .map(List::of)
                        .toList();
        return of.with(of.hypothesis(), windows);
    }

    private static List<Window> of(
            Stepping stepping, Hypothesis hypothesis, Misses run, Noise noise, Course course) {
        UnseenHeading heading = new UnseenHeading(stepping, hypothesis, run, noise, course);
        if (heading.isUnseen()) {
            return heading.windows();
        }
        Shooting shooting = new Shooting(stepping, hypothesis.in(stepping.variant()), run);
        return new Following(shooting, noise, course).windows();
    }

    /** A window as it was fitted, and by how much it misses. */
    private static final class Fitted {
        private final Window window;
        private final RigidMotion[] motion;
        private final double[] misses;

        /** How many numbers were measured in it. */
        private final int measured;

        /** Chi squared of its samples and of what was known of its start. */
        private final double cost;

        Fitted(Window window, RigidMotion[] motion, double[] misses, int measured, double cost) {
            this.window = window;
            this.motion = motion;
            this.misses = misses;
            this.measured = measured;
            this.cost = cost;
        }

        Window window() {
            return window;
        }

        RigidMotion end() {
            return motion[window.length()];
        }

        /** Whether its motion got out of all bounds. */
        boolean isLost() {
            return !Double.isFinite(cost);
        }

        /** Whether it misses far more than noise. */
        boolean isFarOff() {
            return !(Outcome.squares(misses) < FAR_OFF * measured);
        }
    }

    /**
     * Many short windows, each fitted alone: they follow whatever moves the body, as closely as few
     * steps bring them there.
     */
    public List<Window> shortWindows() {
        return shortest(FEW_ITERATIONS).stream().map(Fitted::window).toList();
    }

    private int mostWindows() {
        int all = run.size() - 1;
        int samples = data.count(Channel.VELOCITY) > 0 ? all : places().orElse(all);
        int count = MOST_WINDOWS;
        while (count > 1 && samples / count < FEWEST_SAMPLES) {
            count /= 2;
        }
        return count;
    }

    /** In how many samples but the last the place was measured, along the axis that has fewest. */
    private OptionalInt places() {
        return data.rows().stream()
                .filter(row -> row.channel() == Channel.POSITION)
                .mapToInt(row -> places(row.axis()))
                .min();
    }

    private int places(int axis) {
        return (int)
                IntStream.range(0, run.size() - 1)
                        .filter(k -> !Double.isNaN(run.value(Channel.POSITION, k, axis)))
                        .count();
    }

    /** The longest windows in which the model follows, of equal length but for the last. */
    public List<Window> windows() {
        Optional<Fitted> one = inOneGo(fitted -> follows(List.of(fitted)));
        if (one.isPresent()) {
            return List.of(one.get().window());
        }
        List<Fitted> fitted = shortest(MOST_ITERATIONS);
        while (fitted.size() > 1) {
            List<Fitted> longer = longer(fitted);
            if (!follows(longer)) {
                break;
            }
            fitted = longer;
        }
        return fitted.stream().map(Fitted::window).toList();
    }

    /**
     * All of a run from where it begins: if that is not stated, by more and more of it, as a few
     * samples of a noisy path do not tell the start well enough.
     *
     * @param goesOn whether what was fitted to a part is worth more of the run
     */
    private Optional<Fitted> inOneGo(Predicate<Fitted> goesOn) {
        int last = run.size() - 1;
        RigidMotion start = begin(Math.max(1, last / PARTS.getFirst()));
        KnownStart known = run.start().map(this::asFarAsKnown).orElse(near(0, start));
        Optional<Fitted> fitted = Optional.empty();
        for (int part : run.start().isPresent() ? List.of(1) : PARTS) {
            Window longer = new Window(0, Math.max(1, last / part), start);
            fitted = Optional.of(fit(longer, known, FEW_ITERATIONS)).filter(goesOn);
            if (fitted.isEmpty()) {
                break;
            }
            start = fitted.get().window().start();
        }
        return fitted;
    }

    /**
     * How a run begins, by its first part up to a sample: as fast as in the model, or as was
     * measured, whichever leads nearer to it.
     */
    private RigidMotion begin(int to) {
        RigidMotion asBelieved = LocalMotion.begin(run, model);
        if (run.start().isPresent()) {
            return asBelieved;
        }
        RigidMotion asMeasured = measured(0, to);
        Fitted one = fit(0, to, asBelieved, FEW_ITERATIONS);
        Fitted other = fit(0, to, asMeasured, FEW_ITERATIONS);
        return other.cost < one.cost ? asMeasured : asBelieved;
    }

    /** The window of a whole run, or one that was begun anew if it misses less. */
    private Window anew(Window whole) {
        double missed = Outcome.squares(shooting.misses(whole, shooting.motion(whole)));
        return inOneGo(fitted -> !fitted.isLost())
                .filter(begun -> Outcome.squares(begun.misses) < missed)
                .map(Fitted::window)
                .orElse(whole);
    }

    /** Each begins where the one before has led, or where the measurement says. */
    private List<Fitted> shortest(int mostIterations) {
        int[] borders = borders(mostWindows());
        List<Fitted> fitted = new ArrayList<>();
        for (int w = 0; w + 1 < borders.length; w++) {
            int from = borders[w];
            int to = borders[w + 1];
            RigidMotion guess =
                    w == 0
                            ? run.start().map(this::stated).orElseGet(() -> measured(0, to))
                            : endOf(fitted.getLast(), to);
            Fitted one = fit(from, to, guess, mostIterations);
            if (one.isFarOff() && course.goesOn()) {
                Fitted other = fit(from, to, measured(from, to), mostIterations);
                one = other.cost < one.cost ? other : one;
            }
            fitted.add(one);
        }
        return fitted;
    }

    /** Where a window has led; if it got lost, what was measured there. */
    private RigidMotion endOf(Fitted before, int to) {
        return before.isLost() ? measured(before.window().to(), to) : before.end();
    }

    private RigidMotion measured(int from, int to) {
        return model.nearestStart(LocalMotion.at(run, model.start(), from, to));
    }

    private RigidMotion stated(KnownStart known) {
        return model.nearestStart(known.motion());
    }

    /** Half as many, from the starts of every second one. */
    private List<Fitted> longer(List<Fitted> shorter) {
        int[] borders = borders(shorter.size() / 2);
        return IntStream.range(0, borders.length - 1)
                .parallel()
                .mapToObj(
                        w -> {
                            RigidMotion start = shorter.get(2 * w).window().start();
                            return fit(borders[w], borders[w + 1], start, MOST_ITERATIONS);
                        })
                .toList();
    }

    private int[] borders(int count) {
        int[] borders = new int[count + 1];
        for (int i = 0; i <= count; i++) {
            borders[i] = (int) ((long) i * (run.size() - 1) / count);
        }
        return borders;
    }

    private Fitted fit(int from, int to, RigidMotion guess, int mostIterations) {
        return fit(new Window(from, to, guess), near(from, guess), mostIterations);
    }

    /** What is known of the start of a window: what the run does not show of it stays. */
    private KnownStart near(int from, RigidMotion guess) {
        if (from == 0 && run.start().isPresent()) {
            return asFarAsKnown(run.start().get());
        }
        boolean[] isShown = data.shown(from);
        List<Double> loose =
                from == 0 ? looseness : Looseness.afterwards(run, looseness, data.turns(from));
        List<Double> deviations = new ArrayList<>();
        for (int i = 0; i < isShown.length; i++) {
            deviations.add(isShown[i] ? loose.get(i) : WindowBlock.NOTHING);
        }
        return new KnownStart(guess, deviations);
    }

    /**
     * What is not known of a start is near what the model has: a body that is not upside down. What
     * the run does not show of it either stays.
     */
    private KnownStart asFarAsKnown(KnownStart start) {
        boolean[] isShown = data.shown(0);
        List<Double> deviations = new ArrayList<>();
        for (int i = 0; i < isShown.length; i++) {
            double loose = isShown[i] || start.isKnown(i) ? looseness.get(i) : WindowBlock.NOTHING;
            deviations.add(Math.min(start.deviations().get(i), loose));
        }
        return new KnownStart(start.motion(), deviations);
    }

    /** Gauss-Newton steps, halved until they help: so many, and more where they lead far. */
    private Fitted fit(Window start, KnownStart known, int iterations) {
        Fitted best = judged(start, known);
        boolean isOnItsWay = true;
        for (int i = 0; isOnItsWay && i < MOST_ITERATIONS && course.goesOn(); i++) {
            Fitted next = better(best, known);
            double worth = i + 1 < iterations ? ENOUGH : ON_ITS_WAY;
            isOnItsWay = best.cost - next.cost > Math.max(LITTLE, best.cost * worth);
            best = next;
        }
        return best;
    }

    private Fitted better(Fitted from, KnownStart known) {
        if (from.isLost()) {
            return from; // nothing says where it would be better
        }
        WindowDerivatives derivatives =
                shooting.derivatives(from.window(), from.motion, 1, Moves.NONE);
        WindowBlock block =
                new WindowBlock(
                        model,
                        List.of(derivatives),
                        data.shown(from.window().from()),
                        Optional.of(known));
        double share = 1;
        for (int halving = 0; halving < MOST_HALVINGS; halving++) {
            Fitted tried = judged(block.moved(new double[0], share).getFirst(), known);
            if (tried.cost < from.cost) {
                return tried;
            }
            share /= 2;
        }
        return from;
    }

    private Fitted judged(Window window, KnownStart known) {
        RigidMotion[] motion = shooting.motion(window);
        double[] misses = shooting.misses(window, motion);
        double cost = Outcome.squares(misses) + Outcome.squares(known, window.start());
        return new Fitted(
                window,
                motion,
                misses,
                measured(window, misses.length),
                Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost);
    }

    /** How many of the numbers of a window were measured. */
    private int measured(Window window, int numbers) {
        int first = window.from() * data.rows().size();
        return (int) IntStream.range(first, first + numbers).filter(data::isMeasured).count();
    }

    private boolean follows(List<Fitted> fitted) {
        return fitted.stream().noneMatch(Fitted::isLost)
                && follows(fitted, Channel.POSITION, SHARE_OF_RANGE * range(Channel.POSITION))
                && follows(fitted, Channel.ORIENTATION, TURN)
                && (tellsMore(Channel.POSITION, Channel.VELOCITY)
                        || followsRates(fitted, Channel.VELOCITY))
                && (tellsMore(Channel.ORIENTATION, Channel.ANGULAR_VELOCITY)
                        || followsRates(fitted, Channel.ANGULAR_VELOCITY));
    }

    private boolean followsRates(List<Fitted> fitted, Channel channel) {
        return follows(fitted, channel, SHARE_OF_RATES * range(channel));
    }

    private boolean follows(List<Fitted> fitted, Channel channel, double share) {
        double allowed = Math.max(share, SHARE_OF_NOISE * noise.of(channel));
        return fitted.stream().noneMatch(window -> systematic(window, channel) > allowed);
    }

    /** Whether a channel is measured along as many axes as its rates are: then it tells more. */
    private boolean tellsMore(Channel channel, Channel rates) {
        return data.count(channel) >= data.count(rates);
    }

    private double range(Channel channel) {
        return Looseness.range(run, channel);
    }

    /** Root of what the mean square miss has beyond noise, in the channel's unit. */
    private double systematic(Fitted window, Channel channel) {
        List<Misses.Row> rows = data.rows();
        int first = window.window().from() * rows.size();
        double sum = 0;
        int count = 0;
        for (int i = 0; i < window.misses.length; i++) {
            boolean isOfChannel = rows.get(i % rows.size()).channel() == channel;
            if (isOfChannel && data.isMeasured(first + i)) {
                double noise = data.deviation(first + i);
                sum += (window.misses[i] * window.misses[i] - 1) * noise * noise;
                count++;
            }
        }
        return count == 0 ? 0 : Math.sqrt(Math.max(0, sum / count));
    }
}
