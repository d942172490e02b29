package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.server.net.ClientSession;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The clients that a simulation in lock-step goes on with, by name. What they send for a step waits
 * until all have answered it, and is then used in an order that does not depend on its arrival.
 */
final class Members {
    private static final Comparator<Held> ORDER =
            Comparator.comparingLong(Held::objectId).thenComparing(held -> held.session().name());

    private final Map<String, Member> byName = new TreeMap<>();
    private final List<Held> ofThoseWhoLeft = new ArrayList<>();

    /** The last step that was shown; one that could not be made is shown again, as the next. */
    private long step;

    private WhenLate whenLate = WhenLate.WAIT;

    /** What those who have joined since the last step have sent for its end, in order. */
    List<Held> takeOpenings() {
        List<Held> openings = new ArrayList<>();
        byName.values().forEach(member -> openings.addAll(member.takeOpening(step + 1)));
        openings.sort(ORDER);
        return openings;
    }

    /** Clients are shown where the next step will end; those who are members now answer it. */
    void stepShown() {
        step++;
    }

    /** So many steps are made, shown or not. */
    void stepsMade(long number) {
        step = Math.max(step, number);
    }

    /** The last step that was shown. */
    long step() {
        return step;
    }

    /**
     * Makes a client a member.
     *
     * @return the first step that it has to answer
     */
    long join(ClientSession session) {
        session.setInLockstep(true);
        return byName.computeIfAbsent(session.name(), _ -> new Member(session, step + 1)).owes();
    }

    /** The member that a client is. */
    Optional<Member> of(ClientSession session) {
        return Optional.ofNullable(byName.get(session.name()))
                .filter(member -> member.session() == session);
    }

    /**
     * Takes a member's answer to a step.
     *
     * @throws RefusedException if the client is no member, or has to answer another step
     */
    void ready(ClientSession session, long answered) {
        of(session)
                .orElseThrow(
                        () ->
                                new RefusedException(
                                        ErrorCode.REFUSED,
                                        "%s is no member of a lock-step; say hello-command first"
                                                .formatted(session.name())))
                .ready(answered, step);
    }

    /** Those whose answer to the step that is under way is missing, in order of their names. */
    List<ClientSession> missing() {
        return late().stream().map(Member::session).toList();
    }

    private List<Member> late() {
        return byName.values().stream()
                .filter(member -> member.countsIn(step) && member.owes() <= step)
                .toList();
    }

    /** Whether no answer to the step that is under way is missing. */
    boolean haveAnswered() {
        return late().isEmpty();
    }

    /** Goes on without the answers that are missing. */
    void skipMissing() {
        late().forEach(member -> member.skip(step));
    }

    /** What is done when answers are missing for too long. */
    WhenLate whenLate() {
        return whenLate;
    }

    /** Sets what is done when answers are missing for too long. */
    void setWhenLate(WhenLate whenLate) {
        this.whenLate = whenLate;
    }

    /** Ends a membership; what was sent up to the last answer is used yet, the rest is not. */
    void leave(ClientSession session) {
        of(session)
                .ifPresent(
                        member -> {
                            session.setInLockstep(false);
                            byName.remove(session.name());
                            ofThoseWhoLeft.addAll(member.takeAnswer());
                        });
    }

    /** Ends all memberships, and gives back what was sent, in order. */
    List<Held> dissolve() {
        List<Held> all = new ArrayList<>(ofThoseWhoLeft);
        ofThoseWhoLeft.clear();
        for (Member member : byName.values()) {
            member.session().setInLockstep(false);
            all.addAll(member.takeAll());
        }
        byName.clear();
        all.sort(ORDER);
        return all;
    }

    /**
     * The feedback and, apart from it, the commands that belong to the steps answered, in order.
     */
    Answers takeAnswers() {
        List<Held> all = new ArrayList<>(ofThoseWhoLeft);
        ofThoseWhoLeft.clear();
        for (Member member : byName.values()) {
            if (member.countsIn(step)) {
                all.addAll(member.takeAnswer());
            }
        }
        all.sort(ORDER);
        return new Answers(
                all.stream().filter(held -> held.message() instanceof FeedbackMessage).toList(),
                all.stream().filter(held -> !(held.message() instanceof FeedbackMessage)).toList());
    }

    /** What members have sent for a step, each in the order in which it is used. */
    record Answers(List<Held> feedback, List<Held> commands) {}
}
