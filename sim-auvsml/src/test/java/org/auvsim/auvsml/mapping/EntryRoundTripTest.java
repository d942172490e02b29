package org.auvsim.auvsml.mapping;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.recording.EntryTypes;
import org.auvsim.auvsml.recording.StateHash;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTreeReader;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.Random;
import java.util.stream.LongStream;

class EntryRoundTripTest {
    private final AuvsmlMapper mapper = AuvsmlMapper.load(getClass().getClassLoader());

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 20);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void anEntryIsOneLineAndReadAsWhatItWas(long seed) throws Exception {
        Random random = new Random(seed);
        for (Class<?> type : EntryTypes.all()) {
            Record entry =
                    type == StateHash.class
                            ? StateHash.of(1, 2, 0.1, random.nextLong())
                            : new RandomRecords(mapper, random).record(type);

            byte[] line = mapper.encodeLine(entry);

            assertThat(line).containsOnlyOnce('\n').endsWith('\n');
            assertThat(mapper.decode(type, new XmlTreeReader(Limits.RECORDING).read(line)))
                    .isEqualTo(entry);
        }
    }
}
