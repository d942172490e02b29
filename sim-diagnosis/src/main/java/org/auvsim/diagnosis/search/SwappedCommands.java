package org.auvsim.diagnosis.search;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.entity.Component;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Whether the model as it is comes far nearer to runs that nothing explains once two of their
 * commands are swapped: then the columns are mixed up, or the wires.
 */
final class SwappedCommands {
    /** Enough to see which pairs it may be. */
    private static final int FIRST_STEPS = 1;

    /** So many of those go further. */
    private static final int FEW = 3;

    /** Enough for the starts. */
    private static final int STEPS = 8;

    /** What is left of the squares of what is missed beyond noise; for there may be more wrong. */
    private static final double LEFT = 0.1;

    /** What is left of a channel's squares, if that is more than noise. */
    private static final double NEARER = 0.3;

    /** Squares of what is missed (standard deviations) a number that noise alone does not reach. */
    private static final double MUCH = 2;

    /** What misses far more than noise: squares of standard deviations a number. */
    private static final double FAR = 30;

    private static final Comparator<Swap> NEAREST_FIRST =
            Comparator.comparingDouble(swap -> swap.with().cost());

    private final Fit base;
    private final Judged none;
    private final Noise noise;
    private final Course course;

    /**
     * Of the model as it is believed.
     *
     * @param base what follows the measurement by it
     * @param none the same, fitted
     */
    SwappedCommands(Fit base, Judged none, Noise noise, Course course) {
        this.base = base;
        this.none = none;
        this.noise = noise;
        this.course = course;
    }

    /** Two commands, and how well the model does with each told what the other was. */
    record Swap(String one, String other, Judged with) {
        private Swap further() {
            return new Swap(one, other, Descent.of(with.fit()).steps(STEPS));
        }

        /**
         * Whether it comes far nearer to the runs, and nearer in each channel that it misses: where
         * angles grow the other way, a vehicle with swapped thrusters turns as they are told, and
         * goes elsewhere.
         */
        private boolean isFarNearerThan(Judged none) {
            return with.beyondNoise() < LEFT * none.beyondNoise()
                    && Arrays.stream(Channel.values()).allMatch(of -> isNearer(of, none));
        }

        private boolean isNearer(Channel channel, Judged none) {
            Outcome.Squares here = with.outcome().of(channel);
            return here.sum() <= MUCH * here.count()
                    || here.sum() < NEARER * none.outcome().of(channel).sum();
        }

        /** What is to be said of it. */
        String notice() {
            return "the model as it is predicts the runs far better if the commands of '%s' and '%s' are swapped: are these columns mixed up, or the wires of the vehicle? If so, rename the columns (--rename %s=%s,%s=%s)"
                    .formatted(one, other, one, other, other, one);
        }
    }

    /**
     * The two with which the model as it is leaves nothing but noise of runs that it misses by far.
     * The run that is missed most is asked first, alone: in windows that follow it, so that no
     * motion gets lost, most pairs are seen to be further from it than what was told.
     */
    Optional<Swap> certain() {
        if (!(none.cost() > FAR * none.outcome().count())) {
            return Optional.empty();
        }
        Fit worst = base.ofRun(missedMost());
        double asTold = Refinement.leastOfWindows(worst);
        return pairs().parallelStream()
                .map(pair -> new Glance(pair, Refinement.leastOfWindows(swapped(worst, pair))))
                .toList()
                .stream()
                .filter(glance -> glance.least() < asTold)
                .sorted(Comparator.comparingDouble(Glance::least))
                .map(Glance::pair)
                .limit(FEW)
                .filter(pair -> course.goesOn() && followed(worst, pair).isWhite())
                .map(pair -> new Swap(pair.getFirst(), pair.getLast(), followed(base, pair)))
                .filter(swap -> swap.with().isWhite())
                .findFirst();
    }

    /** What two commands that are swapped miss at least in windows by themselves. */
    private record Glance(List<String> pair, double least) {}

    private int missedMost() {
        List<double[]> misses = none.outcome().misses();
        return IntStream.range(0, misses.size())
                .boxed()
                .max(Comparator.comparingDouble(run -> Outcome.squares(misses.get(run))))
                .orElseThrow();
    }

    /** As near as the model as it is comes with two commands swapped, followed anew. */
    private Judged followed(Fit start, List<String> pair) {
        Fit swapped = swapped(start, pair);
        Fit anew =
                Following.of(
                        swapped.stepping(), swapped.hypothesis(), swapped.data(), noise, course);
        Judged near = Refinement.approach(anew, 1);
        return near.isWhite() ? near : Descent.of(near).steps(STEPS);
    }

    /** The two that come nearest, if they come far nearer than none, and nowhere less near. */
    Optional<Swap> nearest() {
        return pairs().parallelStream()
                .filter(_ -> course.goesOn())
                .map(this::swapped)
                .sorted(NEAREST_FIRST)
                .limit(FEW)
                .toList()
                .parallelStream()
                .map(Swap::further)
                .min(NEAREST_FIRST)
                .filter(swap -> swap.isFarNearerThan(none));
    }

    /** Those of which each can do what the other was told. */
    private List<List<String>> pairs() {
        List<String> names = commands().map(Command::name).distinct().toList();
        List<List<String>> pairs = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            for (int k = i + 1; k < names.size(); k++) {
                String one = names.get(i);
                String other = names.get(k);
                if (canDo(one, other) && canDo(other, one)) {
                    pairs.add(List.of(one, other));
                }
            }
        }
        return pairs;
    }

    private Stream<Command> commands() {
        return none.fit().data().stream().flatMap(of -> of.run().commands().stream());
    }

    /** Whether one is an actuator of the other's kind, and has its range; or both are forces. */
    private boolean canDo(String one, String other) {
        Optional<Component> a = component(one);
        Optional<Component> b = component(other);
        if (a.isPresent() && a.get() instanceof Fin fin) {
            return b.isPresent() && b.get() instanceof Fin && largest(other) <= fin.maximumAngle();
        }
        return a.map(Component::getClass).equals(b.map(Component::getClass));
    }

    /** None, if a force has the name. */
    private Optional<Component> component(String name) {
        return none.fit().model().variant().body().component().stream()
                .filter(of -> of.name().equals(name))
                .findFirst();
    }

    /** What it was told, to either side. */
    private double largest(String name) {
        return none.fit().data().stream()
                .map(Misses::run)
                .flatMapToDouble(
                        run ->
                                run.commands().stream()
                                        .filter(of -> of.name().equals(name))
                                        .flatMapToDouble(
                                                of ->
                                                        IntStream.range(0, run.size())
                                                                .mapToDouble(of::level)))
                .map(Math::abs)
                .max()
                .orElse(0);
    }

    private Swap swapped(List<String> pair) {
        return new Swap(
                pair.getFirst(),
                pair.getLast(),
                Descent.of(swapped(none.fit(), pair)).steps(FIRST_STEPS));
    }

    private Fit swapped(Fit fit, List<String> pair) {
        List<MeasuredRun> runs =
                fit.data().stream()
                        .map(of -> of.run().swapping(pair.getFirst(), pair.getLast()))
                        .toList();
        return new Fit(
                fit.stepping(),
                Misses.of(runs, noise),
                fit.hypothesis(),
                fit.windows(),
                fit.knowledge());
    }
}
