package org.auvsim.server.replay;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.recording.ClientCame;
import org.auvsim.auvsml.recording.ClientSent;
import org.auvsim.auvsml.recording.ClientSentUnreadable;
import org.auvsim.auvsml.recording.ClientWent;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.auvsml.recording.StepFailed;
import org.auvsim.auvsml.recording.WaitTimedOut;
import org.auvsim.core.world.World;
import org.auvsim.server.simulator.Input;
import org.auvsim.server.simulator.InputLog;
import org.auvsim.server.simulator.InputPlace;
import org.auvsim.server.simulator.StepMade;

import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Records a simulation: hand it to {@link org.auvsim.server.simulator.SimulatorBuilder#log}, and
 * close it after the simulation has ended.
 *
 * <p>A thread of its own writes, once a second or more often. Where that cannot keep up, the
 * simulation waits for it, but not for long; where it cannot write any more, the recording ends and
 * the simulation goes on. What the program around the simulator changes by {@link
 * org.auvsim.server.simulator.Simulator#ask} is not recorded: no recording knows how.
 */
public final class Recorder implements InputLog, AutoCloseable {
    private final EntryQueue queue;
    private final Transcript transcript;

    private Recorder(EntryQueue queue, int hashEvery) {
        this.queue = queue;
        this.transcript = new Transcript(hashEvery, queue::put);
    }

    /**
     * Begins a recording.
     *
     * @param writer which is closed with the recorder
     * @param scenario whose world is to be recorded
     * @throws IOException if its beginning cannot be written
     * @throws IllegalArgumentException if the scenario has something that AUVSML cannot state
     */
    public static Recorder start(RecordingWriter writer, Recording recording, Scenario scenario)
            throws IOException {
        writer.begin(recording, scenario);
        return new Recorder(new EntryQueue(writer, scenario.startTime()), recording.hashEvery());
    }

    /**
     * Says whom to tell, once and on some thread, if the recording ends before the simulation does:
     * with the reason, a sentence without a full stop.
     */
    public void whenEnded(Consumer<String> listener) {
        queue.whenEnded(listener);
    }

    @Override
    public void begun(World world) {
        transcript.begin(world);
    }

    @Override
    public void taken(InputPlace place, Input input) {
        entry(place, input).ifPresent(queue::put);
    }

    @Override
    public void stepFailed(InputPlace place) {
        queue.put(new StepFailed(place.revision(), place.step(), place.time()));
    }

    @Override
    public void stepMade(StepMade step) {
        transcript.stepMade(step);
    }

    private static Optional<Entry> entry(InputPlace p, Input input) {
        return switch (input) {
            case Input.Came(var session) ->
                    Optional.of(
                            new ClientCame(
                                    p.revision(),
                                    p.step(),
                                    p.index(),
                                    p.duringStep(),
                                    p.time(),
                                    session.id(),
                                    session.peer(),
                                    session.role()));
            case Input.Sent(var session, Incoming.Request(var requestId, var messages)) ->
                    Optional.of(
                            new ClientSent(
                                    p.revision(),
                                    p.step(),
                                    p.index(),
                                    p.duringStep(),
                                    p.time(),
                                    session.id(),
                                    requestId,
                                    messages));
            case Input.Unreadable(var session, Incoming.Rejected(var requestId, var fault)) ->
                    Optional.of(
                            new ClientSentUnreadable(
                                    p.revision(),
                                    p.step(),
                                    p.index(),
                                    p.duringStep(),
                                    p.time(),
                                    session.id(),
                                    requestId,
                                    fault.code(),
                                    fault.problem(),
                                    fault.path(),
                                    fault.line(),
                                    fault.column()));
            case Input.Went(var session) ->
                    Optional.of(
                            new ClientWent(
                                    p.revision(),
                                    p.step(),
                                    p.index(),
                                    p.duringStep(),
                                    p.time(),
                                    session.id()));
            case Input.TimedOut() ->
                    Optional.of(
                            new WaitTimedOut(
                                    p.revision(), p.step(), p.index(), p.duringStep(), p.time()));
            case Input.Asked _ -> Optional.empty();
        };
    }

    /**
     * Why the recording does not reach to the simulation's end, a sentence without a full stop;
     * after {@link #close}, empty if it does.
     */
    public Optional<String> failure() {
        return queue.failure();
    }

    /** Ends the recording, when all is written; nothing happens if it has ended. */
    @Override
    public void close() {
        queue.close("the simulation has ended");
    }
}
