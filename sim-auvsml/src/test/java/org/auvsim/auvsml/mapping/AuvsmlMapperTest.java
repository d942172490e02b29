package org.auvsim.auvsml.mapping;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTreeReader;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.description.Name;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.stream.Stream;

class AuvsmlMapperTest {
    enum Light {
        RED,
        GREEN
    }

    interface Tool {}

    record Lamp(Light light, @Default("60.5") double wattHours) implements Tool {}

    record GPSFix(String name) implements Tool {}

    record Leg(OptionalInt joints, List<Leg> leg) {}

    record Robot(
            long id,
            int legCount,
            boolean isOn,
            double mass,
            Optional<String> owner,
            Optional<Light> light,
            OptionalDouble depth,
            OptionalLong parent,
            @Default("1 2 3") Vec3 position,
            Optional<Vec3> target,
            List<Leg> leg,
            @Default("lamp GREEN") Tool firstTool,
            @Name("default") @Default("a b") String text) {}

    record Toolbox(List<Tool> tool) {}

    record Positive(double value) {
        Positive {
            if (value <= 0) {
                throw new IllegalArgumentException("value must be above 0, but is " + value);
            }
        }
    }

    record Pair(Positive first, Positive second) {}

    private final AuvsmlMapper mapper =
            AuvsmlMapper.builder(AuvsmlMapperTest.class.getClassLoader())
                    .register(Tool.class, Lamp.class)
                    .register(Tool.class, GPSFix.class)
                    .build();

    @Test
    void whatIsLeftOutHasItsDefaultOrIsEmpty() throws Exception {
        assertThat(read(Robot.class, "<robot id='1' leg-count='2' is-on='true' mass='3'/>"))
                .isEqualTo(
                        new Robot(
                                1,
                                2,
                                true,
                                3,
                                Optional.empty(),
                                Optional.empty(),
                                OptionalDouble.empty(),
                                OptionalLong.empty(),
                                new Vec3(1, 2, 3),
                                Optional.empty(),
                                List.of(),
                                new Lamp(Light.GREEN, 60.5),
                                "a b"));
    }

    @Test
    void allKindsOfComponentsAreWrittenInTheirOrder() {
        Robot robot =
                new Robot(
                        1,
                        2,
                        false,
                        -0.0,
                        Optional.of("R&D"),
                        Optional.of(Light.RED),
                        OptionalDouble.of(1e-7),
                        OptionalLong.of(Long.MIN_VALUE),
                        Vec3.ZERO,
                        Optional.of(new Vec3(0, 0, 1)),
                        List.of(
                                new Leg(OptionalInt.of(3), List.of()),
                                new Leg(
                                        OptionalInt.empty(),
                                        List.of(new Leg(OptionalInt.of(1), List.of())))),
                        new GPSFix("\n"),
                        "");

        assertThat(mapper.encode(robot))
                .isEqualTo(
                        """
                        <robot id="1" leg-count="2" is-on="0" mass="-0.0" owner="R&amp;D" light="RED"\
                         depth="1.0E-7" parent="-9223372036854775808" default="">
                          <position x="0.0" y="0.0" z="0.0"/>
                          <target x="0.0" y="0.0" z="1.0"/>
                          <leg joints="3"/>
                          <leg>
                            <leg joints="1"/>
                          </leg>
                          <gps-fix name="&#10;"/>
                        </robot>
                        """);
    }

    @Test
    void aListOfAnInterfaceKeepsItsOrder() throws Exception {
        assertThat(
                        read(
                                Toolbox.class,
                                "<toolbox><gps-fix name='a'/><lamp light='RED'/><gps-fix name='b'/>"
                                        + "</toolbox>"))
                .isEqualTo(
                        new Toolbox(
                                List.of(
                                        new GPSFix("a"),
                                        new Lamp(Light.RED, 60.5),
                                        new GPSFix("b"))));
    }

    @ParameterizedTest
    @CsvSource({"1,1", "-1.5e3,-1500", "+.5,0.5", "5.,5", "0.1E-2,0.001", "4.9e-324,4.9E-324"})
    void numbersAreReadAsXmlWritesThem(String text, double value) throws Exception {
        assertThat(read(Vec3.class, "<vec3 x='" + text + "' y='0' z='0'/>").x()).isEqualTo(value);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"NaN", "Infinity", "-INF", "1e309", "0x1p3", "1d", "1f", "", "1,5", "--1"})
    void whatIsNoFiniteNumberIsRefused(String text) {
        assertThat(fault(Vec3.class, "<vec3 x='0' y='0' z='" + text + "'/>"))
                .isEqualTo(
                        "line 1, column 19: expected a finite number, but found '%s' at vec3@z"
                                .formatted(text));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    <lamp light='BLUE'/>            | line 1, column 7: expected one of RED, GREEN, but found 'BLUE' at lamp@light
                    <lamp/>                         | line 1, column 1: <lamp> needs an attribute 'light', one of RED, GREEN at lamp
                    <lamp light='RED' lihgt='RED'/> | line 1, column 19: <lamp> has no attribute 'lihgt'; the nearest known name is 'light' at lamp@lihgt
                    <lamp light='RED'>on</lamp>     | line 1, column 1: expected no text in <lamp>, but found 'on' at lamp
                    <lamp light='RED'><a/></lamp>   | line 1, column 19: unknown element 'a'; none is known here at lamp/a
                    <lmap light='RED'/>             | line 1, column 1: expected the root element <lamp>, but found <lmap> at lmap
                    """)
    void aFaultSaysWhatWasExpectedAndWhere(String text, String sentence) {
        assertThat(fault(Lamp.class, text)).isEqualTo(sentence);
    }

    @Test
    void whatAConstructorRefusesHasTheElementsPlace() {
        assertThatThrownBy(
                        () ->
                                read(
                                        Pair.class,
                                        "<pair> <first value='1'/>\n <second value='-1'/></pair>"))
                .hasMessage("line 2, column 2: value must be above 0, but is -1.0 at pair/second");
    }

    @Test
    void anElementThatStandsTwiceIsRefused() {
        assertThatThrownBy(
                        () ->
                                read(
                                        Pair.class,
                                        "<pair><first value='1'/><first value='2'/><second"
                                                + " value='1'/></pair>"))
                .isInstanceOfSatisfying(
                        AuvsmlException.class,
                        e -> assertThat(e.fault().code()).isEqualTo(ErrorCode.DUPLICATE_ELEMENT));
    }

    @Test
    void whatXmlCannotHoldIsNotWritten() {
        assertThatThrownBy(() -> mapper.encode(new Vec3(0, Double.NaN, 0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "<vec3> cannot be written: its y is wrong: expected a finite number, but it"
                                + " is NaN");
        assertThatThrownBy(() -> mapper.encode(new GPSFix("a\u0000")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("XML cannot hold the character U+0000");
        assertThatThrownBy(() -> mapper.encode(new GPSFix("\uD83D")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("XML cannot hold the character U+D83D");
    }

    record OfMap(Map<String, String> map) {}

    record OfScalars(List<String> name) {}

    record OfWrongDefault(@Default("1 2") Vec3 position) {}

    record OfTwins(List<Tool> tool, Lamp lamp) {}

    @Test
    void aRecordThatCannotBeWrittenIsRefusedWithItsReason() {
        Map<Class<?>, String> reasons =
                Map.of(
                        OfMap.class, "component map of record",
                        OfScalars.class, "a list of scalars; make it a list of records",
                        OfWrongDefault.class, "the default '1 2', which has fewer values",
                        OfTwins.class, "would both be elements <lamp>",
                        String.class, "java.lang.String is not a record");

        reasons.forEach(
                (type, reason) ->
                        assertThatThrownBy(() -> mapper.codec(type))
                                .isInstanceOf(IllegalArgumentException.class)
                                .hasMessageContaining(reason));
    }

    /** Holds another record of the name {@link AuvsmlMapperTest.Lamp}. */
    static final class Elsewhere {
        record Lamp() implements Tool {}
    }

    @Test
    void twoRecordsOfOneElementNameAreRefused() {
        AuvsmlMapper.Builder builder =
                AuvsmlMapper.builder(getClass().getClassLoader()).register(Tool.class, Lamp.class);

        assertThatThrownBy(() -> builder.register(Tool.class, Elsewhere.Lamp.class))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("are both registered as")
                .hasMessageContaining("<lamp>; rename one of the records");
    }

    @ParameterizedTest
    @CsvSource({
        "isProjectedState,is-projected-state",
        "GPSFix,gps-fix",
        "Vec3,vec3",
        "xy,xy",
        "AUV1701Beacon,auv1701-beacon",
    })
    void namesAreInKebabCase(String java, String xml) {
        assertThat(ElementName.of(java)).isEqualTo(xml);
    }

    @Test
    void aLongNameIsNotRepeatedInFull() {
        assertThat(fault(Lamp.class, "<lamp light='" + "x".repeat(4000) + "'/>").length())
                .isLessThan(200);
    }

    @Test
    void theNearestNameIsTheOneMeant() {
        List<String> known = Stream.of("position", "orientation", "mass", "name").toList();
        assertThat(Names.nearest("postion", known))
                .isEqualTo("the nearest known name is 'position'");
        assertThat(Names.nearest("naem", known)).isEqualTo("the nearest known name is 'name'");
        assertThat(Names.nearest("orient", known))
                .isEqualTo("the nearest known name is 'orientation'");
    }

    private <R> R read(Class<R> type, String text) throws AuvsmlException {
        return mapper.decode(type, new XmlTreeReader(Limits.MESSAGE).read(text.getBytes(UTF_8)));
    }

    private String fault(Class<?> type, String text) {
        try {
            return "no fault in " + read(type, text);
        } catch (AuvsmlException e) {
            assertThat(e.faults()).hasSize(1);
            return e.fault().toString();
        }
    }
}
