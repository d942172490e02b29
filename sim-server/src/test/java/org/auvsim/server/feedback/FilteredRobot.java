package org.auvsim.server.feedback;

import org.auvsim.auvsml.message.feedback.Covariance;
import org.auvsim.auvsml.message.feedback.DifferentStateFeedbackMessage;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A body in a world of its own, whose measurements a Kalman filter uses. */
final class FilteredRobot {
    static final double STEP = 0.05;

    /** What the filter remembered after each measurement. */
    final List<FilterMemory> memories = new ArrayList<>();

    final World world;
    final StepRecord step;

    /** The filter, and a witness of what it remembers. */
    private record Witnessed(KalmanFilterFeedbackHandler filter, List<FilterMemory> memories)
            implements FeedbackProcessor {
        @Override
        public String name() {
            return filter.name();
        }

        @Override
        public Phase phase() {
            return filter.phase();
        }

        @Override
        public boolean looksBack() {
            return filter.looksBack();
        }

        @Override
        public void process(Correction correction) {
            filter.process(correction);
            memories.add(correction.memory(FilterMemory.class).orElseThrow());
        }
    }

    FilteredRobot(KalmanFilterFeedbackHandler filter, WorldObjectDefinition body) {
        world = World.builder().timeStep(STEP).add(body).build();
        step =
                new StepRecord(
                        world,
                        SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1)),
                        new Witnessed(filter, memories));
    }

    /** A ball in free space. */
    static WorldObjectDefinition ball(Vec3 velocity, Vec3 angularVelocity) {
        return WorldObjectDefinition.named("ball")
                .id(1)
                .mass(3)
                .volume(new Sphere(1))
                .velocity(velocity.x(), velocity.y(), velocity.z())
                .angularVelocity(angularVelocity.x(), angularVelocity.y(), angularVelocity.z())
                .build();
    }

    void measures(
            double time,
            Optional<Vec3> position,
            Optional<Quat> orientation,
            Optional<Vec3> velocity,
            Optional<Vec3> angularVelocity,
            Optional<Covariance> covariance) {
        step.send(
                new DifferentStateFeedbackMessage(
                        1,
                        time,
                        "KalmanFilterFeedbackHandler",
                        Optional.empty(),
                        position,
                        orientation,
                        velocity,
                        angularVelocity,
                        covariance));
    }

    void measures(double time, Vec3 position, Covariance covariance) {
        measures(
                time,
                Optional.of(position),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.of(covariance));
    }
}
