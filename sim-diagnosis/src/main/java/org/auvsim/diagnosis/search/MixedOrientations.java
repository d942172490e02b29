package org.auvsim.diagnosis.search;

import static org.auvsim.diagnosis.run.Channel.ANGULAR_VELOCITY;
import static org.auvsim.diagnosis.run.Channel.ORIENTATION;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.run.Axes;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;

import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Whether the model as it is predicts runs but for their orientations, or these and the rates at
 * which they change, and comes far nearer to them once they are read otherwise: then they are told
 * in another way than was said.
 */
final class MixedOrientations {
    /** Enough for the starts. */
    private static final int STEPS = 8;

    /** What is left of the squares of what is missed beyond noise; for there may be more wrong. */
    private static final double LEFT = 0.1;

    /** Squares of what is missed (standard deviations) a number that noise alone does not reach. */
    private static final double MUCH = 2;

    private final Judged none;
    private final Course course;

    /** Of the model as it is believed, fitted. */
    MixedOrientations(Judged none, Course course) {
        this.none = none;
        this.course = course;
    }

    /** What was told in place of an orientation, and of rates that are told with it. */
    private enum Mix {
        /** From the world to the body, or angles that grow the other way round. */
        OPPOSITE(
                "read the other way round",
                "do the quaternions turn the world into the body, or do angles grow the other way?"
                        + " If so, map their columns with a scale of -1: qx, qy and qz, or the"
                        + " angles"),

        /** As many programs write them. */
        SCALAR_LAST(
                "read as quaternions x, y, z, w",
                "are these the quaternions' columns? If so, rename them (--rename"
                        + " qw=qx,qx=qy,qy=qz,qz=qw)"),

        /** While positions are not, or the other way round. */
        OTHER_AXES(
                "read in axes other than positions are: one of them in east, north, up, the other"
                        + " in north, east, down",
                "are headings clockwise from north, as a compass has them, and positions x east, y"
                        + " north, or headings from east towards north and positions x north, y"
                        + " east? If so, map headings with a scale of -1 and an offset of a quarter"
                        + " turn (--mapping), or turn quaternions before");

        private final String told;
        private final String remedy;

        Mix(String told, String remedy) {
            this.told = told;
            this.remedy = remedy;
        }

        /** Whether channels are told otherwise by it: rates have no scalar. */
        private boolean tells(Set<Channel> some) {
            return this != SCALAR_LAST || !some.contains(ANGULAR_VELOCITY);
        }

        /** The orientation that was told so. */
        private Quat unmixed(Quat q) {
            return switch (this) {
                case OPPOSITE -> q.conjugate();
                case SCALAR_LAST -> new Quat(q.z(), q.w(), q.x(), q.y());
                case OTHER_AXES -> Axes.NED.orientation(q);
            };
        }

        /** The rate that was told so. */
        private Vec3 unmixed(Vec3 rate, Frame frame) {
            return switch (this) {
                case OPPOSITE -> rate.times(-1);
                case SCALAR_LAST -> rate;
                case OTHER_AXES -> frame == Frame.BODY ? Axes.NED.body(rate) : Axes.NED.world(rate);
            };
        }
    }

    /** A mix, the channels that were told so, and how well the model does without it. */
    private record Unmixed(Mix of, Set<Channel> told, Judged with) {}

    /** What is to be said of it; empty where none does. */
    Optional<String> notice() {
        return best(EnumSet.of(ORIENTATION))
                .or(() -> best(EnumSet.of(ORIENTATION, ANGULAR_VELOCITY)))
                .map(MixedOrientations::words);
    }

    private Optional<Unmixed> best(Set<Channel> told) {
        return areMissedAlone(told)
                ? Arrays.stream(Mix.values())
                        .filter(mix -> mix.tells(told) && course.goesOn())
                        .map(mix -> new Unmixed(mix, told, unmixed(mix, told)))
                        .filter(is -> isFarNearer(is.with()))
                        .min(Comparator.comparingDouble(is -> is.with().cost()))
                : Optional.empty();
    }

    /** Whether the model predicts all else that was measured. */
    private boolean areMissedAlone(Set<Channel> some) {
        boolean areMeasured = runs().stream().allMatch(of -> some.stream().allMatch(of::measures));
        if (none.isWhite() || !areMeasured) {
            return false;
        }
        List<MeasuredRun> others = runs();
        for (Channel channel : some) {
            others = others.stream().map(of -> of.without(channel)).toList();
        }
        return others.stream().allMatch(MixedOrientations::tellsSomething)
                && IntStream.range(0, others.size())
                        .boxed()
                        .sorted(Comparator.comparingDouble(this::missed).reversed())
                        .map(others::get)
                        .allMatch(this::isNearlyPredicted)
                && fitted(others).isWhite();
    }

    private double missed(int run) {
        return Outcome.squares(none.outcome().misses().get(run));
    }

    /** By itself: most runs that miss more than their orientations are told at the first. */
    private boolean isNearlyPredicted(MeasuredRun run) {
        Judged alone = fitted(List.of(run));
        return alone.cost() < MUCH * alone.outcome().count();
    }

    private static boolean tellsSomething(MeasuredRun run) {
        return Arrays.stream(Channel.values()).anyMatch(run::measures);
    }

    private List<MeasuredRun> runs() {
        return none.fit().data().stream().map(Misses::run).toList();
    }

    private Judged unmixed(Mix mix, Set<Channel> told) {
        return fitted(
                runs().stream()
                        .map(of -> of.turned(mix::unmixed))
                        .map(of -> told.contains(ANGULAR_VELOCITY) ? spinning(of, mix) : of)
                        .toList());
    }

    private static MeasuredRun spinning(MeasuredRun of, Mix mix) {
        return of.spinning(rate -> mix.unmixed(rate, of.frame(ANGULAR_VELOCITY)));
    }

    /** The model as it is, begun where these runs say. */
    private Judged fitted(List<MeasuredRun> runs) {
        Noise noise = Noise.of(runs);
        List<Misses> data = Misses.of(runs, noise);
        Stepping stepping = none.fit().stepping();
        Fit followed = Following.of(stepping, Hypothesis.NONE, data, noise, course);
        Judged fitted = nearer(Refinement.approach(followed, 1));
        if (fitted.isWhite() || !course.goesOn()) {
            return fitted;
        }
        Judged anew = nearer(Judged.of(Following.anew(fitted.fit(), noise, course)));
        return anew.cost() < fitted.cost() ? anew : fitted;
    }

    private Judged nearer(Judged of) {
        return Descent.of(of).steps(STEPS, Double.POSITIVE_INFINITY, course);
    }

    /** Whether it predicts as many numbers, of which one that never changes is none, far better. */
    private boolean isFarNearer(Judged with) {
        return with.outcome().count() >= none.outcome().count()
                && with.beyondNoise() < LEFT * none.beyondNoise();
    }

    private static String words(Unmixed unmixed) {
        boolean areRates = unmixed.told().contains(ANGULAR_VELOCITY);
        return "the model as it is predicts the runs far better if their orientations%s are %s: %s%s"
                .formatted(
                        areRates ? " and rates" : "",
                        unmixed.of().told,
                        unmixed.of().remedy,
                        areRates ? ", and rates about the same axes with a scale of -1" : "");
    }
}
