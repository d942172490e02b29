package org.auvsim.junit;

import static org.auvsim.junit.Figures.text;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** What is wrong with whom a body collides with. */
final class Meetings {
    private final Trajectory body;

    Meetings(Trajectory body) {
        this.body = body;
    }

    Optional<Finding> without(Trajectory other) {
        if (body.collisions().stream().anyMatch(c -> c.involves(other.id()))) {
            return Optional.empty();
        }
        String verb = "never collides with '%s'".formatted(other.name());
        String expected = "expected a collision; it collides with %s".formatted(partners());
        return Optional.of(
                body.nearestTo(other)
                        .map(
                                nearest ->
                                        new Finding(
                                                verb + " and is nearest",
                                                body.at(nearest.time()),
                                                text(nearest.distance())
                                                        + " m from origin to origin",
                                                expected,
                                                List.of(other)))
                        .orElseGet(
                                () ->
                                        new Finding(
                                                verb + " and ends",
                                                body.last(),
                                                "the two never were in the world together",
                                                expected,
                                                List.of(other))));
    }

    private String partners() {
        String partners =
                body.collisions().stream()
                        .map(c -> "'%s'".formatted(c.partner(body.id())))
                        .distinct()
                        .collect(Collectors.joining(", "));
        return partners.isEmpty() ? "nothing" : partners;
    }

    Optional<Finding> any() {
        return body.collisions().stream().findFirst().map(this::unexpected);
    }

    private Finding unexpected(Encounter collision) {
        int more = body.collisions().size() - 1;
        return new Finding(
                "collides with '%s'".formatted(collision.partner(body.id())),
                body.at(collision.time()),
                "at %s with an impulse of %s N s"
                        .formatted(text(collision.point()), text(collision.impulse().norm())),
                more == 0
                        ? "expected no collision"
                        : "expected no collision, but there are %d more".formatted(more));
    }
}
