package org.auvsim.server.replay;

import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.Reach;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.recording.ClientCame;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.ClientSentUnreadable;
import org.auvsim.auvsml.recording.ClientWent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.RecordedInput;
import org.auvsim.auvsml.recording.RecordingEnded;
import org.auvsim.auvsml.recording.StateHash;
import org.auvsim.auvsml.recording.StepFailed;
import org.auvsim.auvsml.recording.WaitTimedOut;
import org.auvsim.core.world.World;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.simulator.Input;
import org.auvsim.server.simulator.InputSource;
import org.auvsim.server.simulator.SimulationReplay;
import org.auvsim.server.simulator.SimulatorBuilder;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;

/**
 * Runs a recording again, step by step: gives the recorded inputs to the simulation at the places
 * where they were taken, and compares what comes of it. Nothing in it depends on a clock.
 */
public final class Replayer implements AutoCloseable {
    private final RecordingReader recording;
    private final RecordedEntries entries;
    private final SimulationReplay simulation;
    private final Comparison comparison;
    private final Queue<Entry> transcript = new ArrayDeque<>();
    private final Map<Long, ClientSession> sessions = new HashMap<>();

    /**
     * A replay at its beginning.
     *
     * @param recording at its beginning, too; stays the caller's to close
     * @param simulator of the recording's scenario, with the processors and messages that it had
     * @throws org.auvsim.server.net.TransportException if a transport cannot be opened
     */
    public Replayer(RecordingReader recording, SimulatorBuilder simulator) {
        this.recording = recording;
        this.entries = new RecordedEntries(recording);
        Transcript replayed = new Transcript(recording.recording().hashEvery(), transcript::add);
        this.simulation = simulator.log(new TranscriptLog(replayed)).replay(new Waiting());
        this.comparison = new Comparison(simulation.world());
        compareTranscript();
    }

    /** The world as it is now; to be read between steps, by the thread that makes them. */
    public World world() {
        return simulation.world();
    }

    /** Number of steps made. */
    public long steps() {
        return simulation.steps();
    }

    /** Number of recorded hashes that were found again. */
    public long hashes() {
        return comparison.hashes();
    }

    /** Where the replay first differs from the recording; empty as long as it does not. */
    public Optional<Divergence> divergence() {
        return comparison.divergence();
    }

    /** How far the recording goes; known when {@link #advanceTimestep} has found its end. */
    public Reach reach() {
        return recording.reach();
    }

    /**
     * Lets viewers ask what they like until the next step is due, and replays up to after that.
     *
     * @return false if the recording has no more steps
     * @throws DocumentException if the recording cannot be read any further
     */
    public boolean advanceTimestep() throws DocumentException {
        simulation.attend();
        boolean isMade = takeInputs() && makeStep();
        entries.requireReadable();
        return isMade;
    }

    /** Takes what comes before the next step; false if none follows. */
    private boolean takeInputs() {
        while (entries.next().isPresent()) {
            Entry next = entries.next().get();
            boolean isHere = next.step() == simulation.steps();
            if (isHere && next instanceof RecordedInput input && !input.duringStep()) {
                entries.advance();
                input(input).ifPresent(simulation::take);
            } else if (isHere && (next instanceof Happened || next instanceof StateHash)) {
                entries.advance();
                comparison.missing(next);
            } else {
                return !entries.endBeforeStepAfter(simulation.steps());
            }
        }
        return false;
    }

    private boolean makeStep() {
        try {
            simulation.advanceTimestep();
        } catch (RuntimeException e) {
            return failed(e);
        }
        passOverUntakenAnswers();
        compareTranscript();
        return true;
    }

    /** A step that could not be made then cannot be made now: that is a good replay. */
    private boolean failed(RuntimeException why) {
        Optional<Entry> next = entries.next();
        if (next.isPresent() && next.get() instanceof StepFailed) {
            entries.advance();
            return true;
        }
        next.ifPresent(
                entry ->
                        comparison.differ(
                                entry,
                                new FirstDifference(
                                        "the step", "made", String.valueOf(why.getMessage()))));
        return false;
    }

    /** What was recorded of a step that went on without it. */
    private void passOverUntakenAnswers() {
        for (Optional<Entry> next = entries.next();
                next.isPresent()
                        && next.get().step() < simulation.steps()
                        && !(next.get() instanceof RecordingEnded);
                next = entries.next()) {
            comparison.differ(
                    next.get(),
                    new FirstDifference(
                            "the wait for feedback", "longer", "over before its inputs"));
            entries.advance();
        }
    }

    private void compareTranscript() {
        for (Entry replayed = transcript.poll(); replayed != null; replayed = transcript.poll()) {
            Optional<Entry> recorded = entries.next();
            if (recorded.isEmpty()) {
                transcript.clear(); // the recording was cut off here
            } else if (recorded.get() instanceof Happened || recorded.get() instanceof StateHash) {
                comparison.compare(recorded.get(), replayed);
                entries.advance();
            } else {
                comparison.surplus(replayed);
            }
        }
    }

    private Optional<Input> input(RecordedInput entry) {
        return switch (entry) {
            case ClientCame came -> {
                ClientSession session =
                        simulation.session(came.sessionId(), came.peer(), came.role());
                sessions.put(came.sessionId(), session);
                yield Optional.of(new Input.Came(session));
            }
            case ClientSent sent ->
                    session(sent.sessionId())
                            .map(
                                    session ->
                                            new Input.Sent(
                                                    session,
                                                    new Incoming.Request(
                                                            sent.requestId(), sent.message())));
            case ClientSentUnreadable sent ->
                    session(sent.sessionId())
                            .map(
                                    session ->
                                            new Input.Unreadable(
                                                    session,
                                                    new Incoming.Rejected(
                                                            sent.requestId(), fault(sent))));
            case ClientWent went ->
                    Optional.ofNullable(sessions.remove(went.sessionId())).map(Input.Went::new);
            case WaitTimedOut _ -> Optional.of(new Input.TimedOut());
        };
    }

    /** Empty for one that has not come, as only a recording that was edited has. */
    private Optional<ClientSession> session(long id) {
        return Optional.ofNullable(sessions.get(id));
    }

    private static Fault fault(ClientSentUnreadable sent) {
        return new Fault(sent.code(), sent.problem(), sent.path(), sent.line(), sent.column());
    }

    /** Waits no longer for steps to be due, and for viewers; may be called by every thread. */
    public void hurry() {
        simulation.stopAttending();
    }

    /** Ends the sessions of viewers. */
    @Override
    public void close() {
        simulation.close();
    }

    /** The inputs that were recorded while the step that is being made waited. */
    private final class Waiting implements InputSource {
        @Override
        public Optional<Input> next(long nanos) {
            Optional<RecordedInput> recorded = recorded();
            recorded.ifPresent(_ -> entries.advance());
            return recorded.flatMap(Replayer.this::input);
        }

        @Override
        public boolean isClosed() {
            return recorded().isEmpty();
        }

        private Optional<RecordedInput> recorded() {
            return entries.next()
                    .filter(RecordedInput.class::isInstance)
                    .map(RecordedInput.class::cast)
                    .filter(RecordedInput::duringStep)
                    .filter(input -> input.step() == simulation.steps());
        }
    }
}
