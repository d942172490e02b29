package org.auvsim.auvsml.mapping;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.core.description.ElementName;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.ByteArrayInputStream;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * What every message owes: {@code decode(encode(m)).equals(m)}, for random values in all
 * components.
 *
 * <p>To test messages of your own, extend this and name their types; nothing else is needed:
 *
 * <pre>{@code
 * class MyMessagesTest extends RoundTripContract {
 *     @Override
 *     protected Stream<Class<?>> types() {
 *         return Stream.of(ShutDownPropulsors.class);
 *     }
 * }
 * }</pre>
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
public abstract class RoundTripContract {
    private static final int SEEDS = 20;

    private final MessageCatalogue catalogue =
            MessageCatalogue.load(RoundTripContract.class.getClassLoader());

    /**
     * The message types to test; all that the class path's provider files name, if not overridden.
     */
    protected Stream<Class<?>> types() {
        return catalogue.types().stream();
    }

    Stream<Arguments> cases() {
        return types().flatMap(
                        type ->
                                LongStream.rangeClosed(1, SEEDS)
                                        .mapToObj(
                                                seed ->
                                                        Arguments.of(
                                                                ElementName.of(type), seed, type)));
    }

    @ParameterizedTest(name = "{0}, seed {1}")
    @MethodSource("cases")
    void whatIsWrittenIsReadAsWhatItWas(String name, long seed, Class<?> type) throws Exception {
        Message message =
                (Message) new RandomRecords(catalogue.mapper(), new Random(seed)).record(type);

        byte[] bytes =
                new AuvsmlWriter(catalogue).write(Optional.of(name + " " + seed), List.of(message));

        AuvsmlReader reader =
                new AuvsmlReader(
                        new ByteArrayInputStream(bytes),
                        RootDecoder.strict(catalogue, Limits.MESSAGE),
                        Limits.MESSAGE);
        assertThat(reader.next())
                .isEqualTo(new Incoming.Request(Optional.of(name + " " + seed), List.of(message)));
    }
}
