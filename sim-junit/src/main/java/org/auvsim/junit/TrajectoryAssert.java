package org.auvsim.junit;

import org.assertj.core.api.AbstractAssert;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/**
 * Assertions on where a body went; one that fails says when, what was found and what was expected,
 * and leaves a picture of the path with the place marked. Bodies are looked at after each step;
 * distances are from origin to origin. All throw {@link IllegalArgumentException} for a tolerance
 * that is negative or not finite.
 */
public final class TrajectoryAssert extends AbstractAssert<TrajectoryAssert, Trajectory> {
    private TrajectoryAssert(Trajectory actual) {
        super(actual, TrajectoryAssert.class);
    }

    /** Begins an assertion. */
    public static TrajectoryAssert assertThatTrajectory(Trajectory actual) {
        return new TrajectoryAssert(actual);
    }

    /** The body never leaves a region. */
    public TrajectoryAssert staysWithin(Region region) {
        return isRight(new Whereabouts(actual).outside(region, List.of()));
    }

    /** The body is never farther than {@code distance} (m) from a point (m, world). */
    public TrajectoryAssert staysWithin(double distance, Vec3 centre) {
        return staysWithin(Region.around(centre, distance));
    }

    /** The body is never farther than {@code distance} (m) from another one. */
    public TrajectoryAssert staysWithin(double distance, Trajectory other) {
        Region region = Region.around(other, distance);
        return isRight(new Whereabouts(actual).outside(region, List.of(other)));
    }

    /** The body is never nearer than {@code distance} (m) to another one. */
    public TrajectoryAssert staysClearOf(Trajectory other, double distance) {
        return isRight(new Whereabouts(actual).tooNear(other, distance));
    }

    /** The body comes within {@code tolerance} (m) of a point (m, world) at some time. */
    public TrajectoryAssert passesNear(Vec3 point, double tolerance) {
        return isRight(new Whereabouts(actual).missed(point, tolerance));
    }

    /** The body is at its end within {@code tolerance} (m) of a point (m, world). */
    public TrajectoryAssert endsNear(Vec3 point, double tolerance) {
        return isRight(new Whereabouts(actual).endsElsewhere(point, tolerance));
    }

    /** The body is never faster than {@code speed} (m/s). */
    public TrajectoryAssert staysSlowerThan(double speed) {
        return isRight(new Whereabouts(actual).tooFast(speed));
    }

    /**
     * The body collides with another one.
     *
     * @throws IllegalArgumentException if the replay has no body of that name
     */
    public TrajectoryAssert collidesWith(String otherName) {
        return isRight(new Meetings(actual).without(actual.replay().trajectory(otherName)));
    }

    /** The body collides with nothing. */
    public TrajectoryAssert collidesWithNothing() {
        return isRight(new Meetings(actual).any());
    }

    /**
     * The body goes where the recording has it: at each time that was recorded, its position
     * differs by at most {@code tolerance} (m).
     *
     * @throws IllegalStateException if no recording was replayed, but a scenario
     */
    public TrajectoryAssert matchesRecording(double tolerance) {
        return matchesRecording(tolerance, Math.PI);
    }

    /** The same, and its orientation differs by at most {@code angle} (rad). */
    public TrajectoryAssert matchesRecording(double tolerance, double angle) {
        return isRight(new Likeness(actual, tolerance, angle).difference());
    }

    private TrajectoryAssert isRight(Optional<Finding> finding) {
        if (finding.isPresent()) {
            throw failed(finding.get());
        }
        return this;
    }

    private AssertionError failed(Finding finding) {
        return failureWithActualExpected(
                finding.actual(),
                finding.expected(),
                "%s%n%s",
                finding.sentence(actual.name()),
                Picture.of(actual, finding));
    }
}
