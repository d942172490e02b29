package org.auvsim.bench;

import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.framing.Frame;
import org.auvsim.auvsml.framing.FrameReader;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * A movement message as a live world has it, all 18 numbers with all their digits: bytes to record,
 * record to bytes, and both, which must stay below 8 us.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(1)
public class MovementMessageBenchmark {
    private final MessageCatalogue catalogue =
            MessageCatalogue.load(MovementMessageBenchmark.class.getClassLoader());
    private final AuvsmlWriter writer = new AuvsmlWriter(catalogue);
    private final RootDecoder decoder = RootDecoder.strict(catalogue, Limits.MESSAGE);
    private final FrameReader frames = new FrameReader(Limits.MESSAGE);
    private final MovementStateChangeMessage message =
            new MovementStateChangeMessage(
                    7.800000000000001,
                    46,
                    false,
                    new Vec3(1.0 / 3, -27.123456789012344, 1234.5678901234567),
                    Quat.ofAxisAngle(new Vec3(1, -2, 3), 1.234).toMatrix(),
                    new Vec3(Math.PI, -Math.E * 1e3, 1.0 / 7),
                    new Vec3(1e-3 / 3, 2e2 / 3, -Math.sqrt(2)));
    private final byte[] bytes = writer.write(message);

    /** One message's bytes, without framing, to its record. */
    @Benchmark
    public Incoming decode() {
        return decoder.decode(new Frame.Root(bytes, 1, 1));
    }

    /** One record to its message's bytes. */
    @Benchmark
    public byte[] encode() {
        return writer.write(message);
    }

    /** There and back. */
    @Benchmark
    public byte[] decodeAndEncode() {
        return switch (decoder.decode(new Frame.Root(bytes, 1, 1))) {
            case Incoming.Request request ->
                    writer.write(request.requestId(), List.copyOf(request.messages()));
            case Incoming.Rejected rejected ->
                    throw new IllegalStateException(rejected.fault().toString());
            case Incoming.End _ -> throw new IllegalStateException("no message");
        };
    }

    /** One message's bytes found in a stream. */
    @Benchmark
    public Optional<Frame> frame() {
        frames.feed(bytes, 0, bytes.length);
        return frames.next();
    }
}
