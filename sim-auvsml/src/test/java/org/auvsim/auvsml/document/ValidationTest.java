package org.auvsim.auvsml.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.xml.sax.SAXException;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.Validator;

class ValidationTest {
    private static final MessageCatalogue CATALOGUE =
            MessageCatalogue.load(ValidationTest.class.getClassLoader());

    private final Validation validation = new Validation(CATALOGUE);

    @Test
    void whatIsRightHasNoFaults() throws IOException {
        assertThat(faults("<scenario/>")).isEmpty();
        assertThat(
                        faults(
                                """
                                <?xml version="1.0"?>
                                <scenario xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"
                                          xsi:noNamespaceSchemaLocation="../docs/auvsml.xsd">
                                  <world-object name="a" mass="1.5e1"><position z="0" y="0" x="0"/>
                                    <sphere radius=".5"/></world-object>
                                </scenario>
                                """))
                .isEmpty();
        assertThat(
                        faults(
                                """
                                <auvsml><pause-simulator-command/></auvsml>
                                <auvxml request-id="x"><get-propulsor-list-request agent-id="4"/>
                                <remove-force-command force-name="a" world-object-id="1"/></auvxml>
                                """))
                .isEmpty();
    }

    @Test
    void allFaultsOfAScenarioAreToldOnceEachInOrder() throws IOException {
        assertThat(
                        faults(
                                """
                                <scenario>
                                  <time-step delta="NaN"/>
                                  <uniform-current id="a" name="tide"/>
                                  <world-object nam="b" mass="-1"><sphere radius="0"/>
                                    <position x="1" y="2"/></world-object>
                                  <world-objekt/>
                                </scenario>
                                """))
                .containsExactly(
                        "line 2, column 14: expected a finite number, but found 'NaN' at"
                                + " scenario/time-step@delta",
                        "line 3, column 20: expected a whole number, but found 'a' at"
                                + " scenario/uniform-current@id",
                        "line 4, column 17: <world-object> has no attribute 'nam'; the nearest"
                                + " known name is 'name' at"
                                + " scenario/world-object@nam",
                        "line 4, column 35: a sphere's radius must be above 0 m and finite, but"
                                + " is 0.0 m at scenario/world-object/sphere",
                        "line 6, column 3: unknown element 'world-objekt'; the nearest known name"
                                + " is 'world-object' at scenario/world-objekt",
                        "line 3, column 3: <uniform-current> needs an element <velocity> at"
                                + " scenario/uniform-current",
                        "line 4, column 3: <world-object> needs an attribute 'name', a text at"
                                + " scenario/world-object",
                        "line 5, column 5: <position> needs an attribute 'z', a finite number at"
                                + " scenario/world-object/position");
    }

    /** Overlaps among what is right, beside what is wrong and an id that is there twice. */
    @Test
    void noFaultHidesAnOverlap() throws IOException {
        assertThat(
                        faults(
                                """
                                <scenario>
                                  <time-step delta="0"/>
                                  <world-object name="a" mass="1"><sphere radius="1"/></world-object>
                                  <world-object name="b" mass="1"><sphere radius="-1"/></world-object>
                                  <world-object name="c" mass="1" id="7"><sphere radius="1"/>
                                    <position x="9" y="0" z="0"/></world-object>
                                  <world-object name="d" mass="1"><sphere radius="1"/>
                                    <position x="0" y="1.5" z="0"/></world-object>
                                  <world-object name="e" mass="1" id="7"><sphere radius="1"/></world-object>
                                </scenario>
                                """))
                .containsExactly(
                        "line 2, column 3: the time step must be 1.0E-9 s or more, but is 0.0 s at"
                                + " scenario/time-step",
                        "line 4, column 35: a sphere's radius must be above 0 m and finite, but is"
                                + " -1.0 m at scenario/world-object/sphere",
                        "line 7, column 3: 'd' overlaps 'a' of line 3 by 0.500 m; move them apart"
                                + " or set allow-overlaps",
                        "line 9, column 35: the id '7' is that of the <world-object> in line 5;"
                                + " expected another one at scenario/world-object@id");
    }

    @Test
    void eachOverlapIsToldAtTheSecondOfThePair() throws IOException {
        StringBuilder text = new StringBuilder("<scenario>");
        for (int i = 1; i <= 13; i++) {
            text.append(
                    """

                    <world-object name="%d" id="%d" mass="1"><sphere radius="1"/>
                    <position x="%d.5" y="0" z="0"/></world-object>\
                    """
                            .formatted(i, 100 - i, i));
        }
        List<String> faults = faults(text + "</scenario>");

        assertThat(faults)
                .hasSize(11)
                .contains(
                        "line 1, column 1: 2 pairs more overlap at the start",
                        "line 26, column 1: '13' overlaps '12' of line 24 by 1.00 m; move them"
                                + " apart or set allow-overlaps");
    }

    /** A compound that lacks a coordinate, a volume, or all of its parts. */
    @Test
    void aCompoundThatIsNotWholeIsToldWhereItLacksWhat() throws IOException {
        assertThat(
                        faults(
                                """
                                <scenario>
                                  <world-object name="a" mass="1"><compound>
                                    <part><sphere radius="1"/><position x="1" z="0"/></part>
                                    <part><position x="1" y="0" z="0"/></part>
                                    <part><box><size x="1" y="" z="1"/></box></part>
                                    <part><half-space/></part>
                                  </compound></world-object>
                                  <world-object name="b" mass="1"><compound/></world-object>
                                </scenario>
                                """))
                .containsExactlyInAnyOrder(
                        "line 3, column 31: <position> needs an attribute 'y', a finite number at"
                                + " scenario/world-object/compound/part/position",
                        "line 4, column 5: <part> needs a volume: one of the elements box,"
                                + " capsule, compound, half-space, height-map, sphere at"
                                + " scenario/world-object/compound/part",
                        "line 5, column 28: expected a finite number, but found '' at"
                                + " scenario/world-object/compound/part/box/size@y",
                        "line 6, column 5: a part of a compound must be a sphere, a capsule or a"
                                + " box, but is a half-space at"
                                + " scenario/world-object/compound/part",
                        "line 8, column 35: a compound needs at least one part, but has none; add"
                                + " a <part> at scenario/world-object/compound");
    }

    /** Rows that differ in length, numbers that are none: each where it stands. */
    @Test
    void aHeightMapWithMissingCellsIsToldWhereTheyAre() throws IOException {
        assertThat(
                        faults(
                                """
                                <scenario>
                                  <world-object name="a" fixed="1"><height-map spacing="2">
                                    <row heights="1 2 3"/><row heights="1 2"/>
                                  </height-map></world-object>
                                  <world-object name="b" fixed="1"><height-map spacing="2">
                                    <row heights="1 2 3"/><row heights="1 - 3"/>
                                  </height-map></world-object>
                                  <world-object name="c" fixed="1"><height-map spacing="0">
                                    <row heights="1 2 3"/><row heights="1 2 3"/>
                                  </height-map></world-object>
                                </scenario>
                                """))
                .containsExactlyInAnyOrder(
                        "line 2, column 36: row 2 of a height map has 2 heights, but row 1 has 3;"
                                + " give every row the same number at"
                                + " scenario/world-object/height-map",
                        "line 6, column 32: expected finite numbers with blanks between them, but"
                                + " found '1 - 3' at scenario/world-object/height-map/row@heights",
                        "line 8, column 36: a height map's spacing must be above 0 m and finite,"
                                + " but is 0.0 m at scenario/world-object/height-map");
    }

    @Test
    void aMisspeltNameIsToldBeforeWhatIsMissingForIt() throws IOException {
        assertThat(faults("<auvsml><get-propulsor-list-request agentid='1'/></auvsml>"))
                .containsExactly(
                        "line 1, column 37: <get-propulsor-list-request> has no attribute"
                                + " 'agentid'; the nearest known name is 'agent-id' at"
                                + " auvsml/get-propulsor-list-request@agentid",
                        "line 1, column 9: <get-propulsor-list-request> needs an attribute"
                                + " 'agent-id', a whole number at"
                                + " auvsml/get-propulsor-list-request");
        assertThat(
                        faults(
                                "<scenario><world-object name='a' mass='1'><spere radius='1'/>"
                                        + "</world-object></scenario>"))
                .first()
                .isEqualTo(
                        "line 1, column 43: unknown element 'spere'; the nearest known name is"
                                + " 'sphere' at scenario/world-object/spere");
    }

    @Test
    void allFaultsOfAllMessagesAreTold() throws IOException {
        assertThat(
                        faults(
                                """
                                <auvsml><pause-simulator/></auvsml>
                                <auvsml><pause-simulator-command></auvsml>
                                <auvsml>
                                  <get-propulsor-list-request/>
                                  <set-propulsor-command world-object-id="1" name="a" level="2"/>
                                </auvsml> hello
                                <auvsml><get-world-object-list-command/></auvsml>
                                """))
                .extracting(fault -> fault.replaceAll(":.*", ""))
                .containsExactly(
                        "line 1, column 9",
                        "line 2, column 41",
                        "line 5, column 3",
                        "line 4, column 3",
                        "line 6, column 11");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "hello",
                "<scenario>",
                "<scenario/><scenario/>",
                "<!DOCTYPE a><a/>",
                "<a/>"
            })
    void whatIsNeitherHasOneFault(String text) throws IOException {
        assertThat(faults(text)).hasSize(1);
    }

    @Test
    void aFileThatIsMissingIsNamed(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("conversation.xml");
        assertThatThrownBy(() -> validation.faults(file))
                .isInstanceOf(DocumentException.class)
                .hasMessage(file + ": there is no such file");

        Files.writeString(
                file, "<auvsml><pause-simulator-command/></auvsml>\n".repeat(50_000) + "<auvsml");
        assertThat(validation.faults(file)).hasSize(1);
    }

    @Test
    void theSchemaAloneFindsWhatItCan() throws Exception {
        Validator schema =
                SchemaFactory.newDefaultInstance()
                        .newSchema(new StreamSource(new StringReader(Schema.of(CATALOGUE))))
                        .newValidator();
        schema.validate(new StreamSource(new StringReader("<auvsml><step-command/></auvsml>")));

        for (String wrong :
                List.of(
                        "<auvsml/>",
                        "<auvsml><step/></auvsml>",
                        "<auvsml><step-command count='x'/></auvsml>",
                        "<auvsml><step-command speed='1'/></auvsml>",
                        "<auvsml><entity-added-message timestamp='NaN' entity-id='1'/></auvsml>",
                        "<auvsml><timestep-advanced-notification timestamp='1'/></auvsml>",
                        "<scenario><time-step/></scenario>",
                        "<scenario><uniform-current id='1' name='a'/></scenario>")) {
            assertThatThrownBy(() -> schema.validate(new StreamSource(new StringReader(wrong))))
                    .as(wrong)
                    .isInstanceOf(SAXException.class);
        }
    }

    private List<String> faults(String text) throws IOException {
        return validation.faults(new ByteArrayInputStream(text.getBytes(UTF_8))).stream()
                .map(Fault::toString)
                .toList();
    }
}
