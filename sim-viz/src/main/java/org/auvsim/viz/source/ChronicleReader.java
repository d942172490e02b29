package org.auvsim.viz.source;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.recording.ClientCame;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.ClientSentUnreadable;
import org.auvsim.auvsml.recording.ClientWent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.StepFailed;
import org.auvsim.core.math.Quat;
import org.auvsim.core.world.WorldException;
import org.auvsim.viz.scene.Meeting;
import org.auvsim.viz.scene.SeenObject;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Reads a recording into a chronicle. Commands are taken to have been carried out: the recording
 * does not say which were refused.
 */
final class ChronicleReader {
    /** Instants that are no farther apart (s) are one. */
    private static final double SAME_TIME = 1e-6;

    private final RecordingReader reader;
    private final Chronicle chronicle;
    private final ClientDeeds deeds;
    private final List<ClientSent> waiting = new ArrayList<>();

    /** Feedback that has come since the last step is true from here on at the earliest (s). */
    private double earliestFeedback = Double.POSITIVE_INFINITY;

    private int order;
    private int revision;
    private long step;
    private double time;

    /** The end of the step before the one told of (s). */
    private double before;

    private ChronicleReader(RecordingReader reader, long most) {
        this.reader = reader;
        this.chronicle = new Chronicle(most);
        this.deeds = new ClientDeeds(chronicle, reader.scenario());
    }

    /**
     * Reads all that is left.
     *
     * @param name what sentences call it
     * @param most so many states are kept
     * @param progress runs after each entry
     * @throws DocumentException if the recording is damaged
     */
    static Chronicle read(RecordingReader reader, String name, long most, Runnable progress)
            throws DocumentException {
        ChronicleReader into = new ChronicleReader(reader, most);
        try {
            into.readAll(progress);
            return into.chronicle;
        } catch (WorldException | IllegalArgumentException e) {
            throw new DocumentException(
                    "%s: what it tells after step %d cannot be: %s"
                            .formatted(name, into.step, e.getMessage()),
                    e);
        }
    }

    private void readAll(Runnable progress) throws DocumentException {
        chronicle.install(reader.scenario(), 0);
        time = reader.scenario().startTime();
        before = time;
        for (Optional<Entry> next = reader.next(); next.isPresent(); next = reader.next()) {
            order++;
            take(next.get());
            progress.run();
        }
        if (!reader.reach().isWhole()) {
            say("The recording was cut off here.");
        }
        if (chronicle.stride() > 1) {
            chronicle.tell(
                    chronicle.steps().first(),
                    order,
                    "The recording is long: one state of %d is shown."
                            .formatted(chronicle.stride()));
        }
    }

    private void take(Entry entry) {
        if (entry.revision() > revision) {
            revision = entry.revision();
            revised(entry);
        }
        if (entry.step() > step) {
            before = entry.timestamp() - (entry.timestamp() - time) / (entry.step() - step);
            step = entry.step();
            carryOutWaiting(entry.timestamp());
        } else if (entry instanceof StepFailed) {
            carryOutWaiting(entry.timestamp());
        }
        time = entry.timestamp();
        chronicle.step(time);
        tell(entry);
    }

    private void carryOutWaiting(double now) {
        waiting.forEach(sent -> carryOut(sent, now));
        waiting.clear();
    }

    /** The past was corrected, or the world is another one. */
    private void revised(Entry entry) {
        Optional<ClientDeeds.Elsewhere> where = deeds.takeElsewhere();
        if (where.isPresent()) {
            goTo(where.get());
        } else if (entry.timestamp() < time) {
            goTo(new ClientDeeds.Elsewhere(Cut.at(entry.timestamp()), Optional.empty()));
        } else {
            chronicle.meetings().cut(Cut.at(madeAgainFrom()));
            say("Late feedback has corrected the past.");
        }
        earliestFeedback = Double.POSITIVE_INFINITY;
    }

    /** When the step began (s) at whose end, or in which, the first of late feedback is true. */
    private double madeAgainFrom() {
        Times steps = chronicle.steps();
        return steps.get(Math.max(steps.at(earliestFeedback - SAME_TIME), 0));
    }

    /** Older feedback is refused. */
    private boolean isInReach(FeedbackMessage feedback) {
        return feedback.timestamp() > time - reader.scenario().feedbackHorizon();
    }

    private void goTo(ClientDeeds.Elsewhere where) {
        double left = time;
        time = where.cut().time();
        before = time;
        chronicle.cut(where.cut());
        where.scenario().ifPresent(scenario -> chronicle.install(scenario, order));
        chronicle.tell(
                time, order, String.format(Locale.ROOT, "The world came here from %.2f s.", left));
    }

    private void tell(Entry entry) {
        switch (entry) {
            case Happened happened -> {
                happened.message().forEach(this::hear);
                deeds.stepMade(happened.step());
            }
            case ClientSent sent -> {
                measure(sent);
                if (sent.duringStep()) {
                    waiting.add(sent);
                } else {
                    carryOut(sent, time);
                }
            }
            case ClientCame came ->
                    say(
                            "Client %d came from %s as %s."
                                    .formatted(
                                            came.sessionId(), came.peer(), came.role().roleName()));
            case ClientWent went -> say("Client %d went.".formatted(went.sessionId()));
            case ClientSentUnreadable sent ->
                    say("Client %d was refused: %s".formatted(sent.sessionId(), sent.problem()));
            case StepFailed _ -> say("A step could not be made.");
            default -> {
                // nothing to see
            }
        }
    }

    private void say(String sentence) {
        chronicle.tell(time, order, sentence);
    }

    private void hear(Message message) {
        switch (message) {
            case WorldObjectListResponse listed -> listed.worldObject().forEach(this::list);
            case EntityRemovedMessage gone ->
                    chronicle.end(gone.entityId(), gone.timestamp(), order);
            case MovementStateChangeMessage moved -> move(moved);
            case CollisionNotification met ->
                    chronicle
                            .meetings()
                            .add(
                                    met.timestamp(),
                                    order,
                                    new Meeting(
                                            met.timestamp(),
                                            met.entityId(),
                                            met.otherId(),
                                            met.point(),
                                            met.impulse()));
            default -> {
                // nothing to see
            }
        }
    }

    /** It has come since the step before, if it is not of the scenario. */
    private void list(ListedWorldObject listed) {
        Optional<Course> known = chronicle.course(listed.id());
        if (known.isEmpty() || !known.get().object().name().equals(listed.name())) {
            SeenObject object =
                    new SeenObject(listed.id(), listed.name(), deeds.takeAdded(listed.name()));
            deeds.arrived(chronicle.begin(object, before, order));
        }
    }

    private void move(MovementStateChangeMessage moved) {
        Optional<Course> course =
                chronicle
                        .course(moved.worldObjectId())
                        .or(() -> back(moved.worldObjectId(), moved.timestamp()));
        course.ifPresent(
                its ->
                        chronicle.move(
                                its,
                                before,
                                moved.timestamp(),
                                moved.position(),
                                Quat.of(moved.orientation())));
    }

    /** One that had gone is there again, as in a snapshot. */
    private Optional<Course> back(long id, double at) {
        return chronicle.known(id).map(object -> chronicle.begin(object, at, order));
    }

    private void carryOut(ClientSent sent, double now) {
        sent.message().forEach(message -> deeds.carryOut(message, now, order, step));
    }

    private void measure(ClientSent sent) {
        for (Message message : sent.message()) {
            if (message instanceof FeedbackMessage feedback) {
                if (isInReach(feedback)) {
                    earliestFeedback = Math.min(earliestFeedback, feedback.timestamp());
                }
                chronicle
                        .course(feedback.worldObjectId())
                        .ifPresent(course -> mark(course, feedback));
            }
        }
    }

    private void mark(Course course, FeedbackMessage feedback) {
        MeasuredPlace.of(feedback, course.track())
                .ifPresent(place -> course.marks().add(feedback.timestamp(), order, place));
    }
}
