package org.auvsim.auvsml.mapping;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTreeReader;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.util.Random;
import java.util.stream.LongStream;

class ScenarioRoundTripTest {
    private final AuvsmlMapper mapper = AuvsmlMapper.load(getClass().getClassLoader());

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 30);
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void whatIsWrittenIsReadAsWhatItWas(long seed) throws Exception {
        Record scenario = new RandomRecords(mapper, new Random(seed)).record(Scenario.class);

        byte[] text = mapper.encode(scenario).getBytes(UTF_8);

        assertThat(mapper.decode(Scenario.class, new XmlTreeReader(Limits.SCENARIO).read(text)))
                .isEqualTo(scenario);
    }
}
