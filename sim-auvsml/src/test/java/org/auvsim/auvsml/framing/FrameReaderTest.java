package org.auvsim.auvsml.framing;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.Limits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

class FrameReaderTest {
    private static final Limits LIMITS = new Limits(200, 4, 3);

    @Test
    void findsRootsWhateverStandsBetweenThem() {
        assertThat(
                        frames(
                                """
                                \uFEFF<?xml version="1.0" encoding="UTF-8"?>
                                <auvsml><a/></auvsml><auvxml request-id='>'/>
                                <!-- <auvsml> --><?pi <x> ?> <auvsml><b c="&lt;/auvsml>"/></auvsml>
                                """))
                .containsExactly(
                        "2:1 <auvsml><a/></auvsml>",
                        "2:22 <auvxml request-id='>'/>",
                        "3:30 <auvsml><b c=\"&lt;/auvsml>\"/></auvsml>");
    }

    @Test
    void aRootEndsOnlyWithItsOwnEndTag() {
        assertThat(frames("<auvsml><!-- </auvsml> --><![CDATA[</auvsml>]]></a></auvsml>"))
                .containsExactly(
                        "1:1 <auvsml><!-- </auvsml> --><![CDATA[</auvsml>]]></a></auvsml>");
    }

    @Test
    void aTruncatedRootIsReportedAndTheNextOneRead() {
        assertThat(frames("<auvsml><a>\n<auvsml><b/></auvsml>"))
                .containsExactly("1:1 MALFORMED_XML", "2:1 <auvsml><b/></auvsml>");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"<auvsml><a b=\"", "<auvsml><a b", "<auvsml", "<auvsml></a", "<auvsml><"})
    void aRootThatBreaksOffInATagIsReportedWhereTheNextOneBegins(String broken) {
        assertThat(frames(broken + "<auvsml/>"))
                .containsExactly(
                        "1:%d MALFORMED_XML".formatted(broken.length() + 1),
                        "1:%d <auvsml/>".formatted(broken.length() + 1));
    }

    @Test
    void theStreamsEndInARootIsAFault() {
        assertThat(frames("\n <auvsml><a/>")).containsExactly("2:2 MALFORMED_XML");
        assertThat(frames("<auvsml/> ")).containsExactly("1:1 <auvsml/>");
    }

    @Test
    void otherRootsAndTextAreReportedOnceAndSkipped() {
        assertThat(frames("<html><body>hello</body></html>\nmore\n<auvsml/>"))
                .containsExactly("1:1 UNKNOWN_ROOT", "3:1 <auvsml/>");
        assertThat(frames("GET / HTTP/1.1\r\n\r\n<auvsml/>"))
                .containsExactly("1:1 MALFORMED_XML", "3:1 <auvsml/>");
        assertThat(frames("</auvsml><auvsml/>"))
                .containsExactly("1:1 MALFORMED_XML", "1:10 <auvsml/>");
        assertThat(frames("<auvsmlx/><auvsml/>"))
                .containsExactly("1:1 UNKNOWN_ROOT", "1:11 <auvsml/>");
    }

    @Test
    void aDoctypeIsForbiddenBetweenAndInRoots() {
        assertThat(frames("<!DOCTYPE auvsml [<!ENTITY a 'b'>]><auvsml/>"))
                .containsExactly("1:1 FORBIDDEN_XML", "1:36 <auvsml/>");
        assertThat(frames("<auvsml><!DOCTYPE a></auvsml><auvsml/>"))
                .containsExactly("1:9 FORBIDDEN_XML", "1:30 <auvsml/>");
    }

    @Test
    void anotherEncodingIsForbidden() {
        assertThat(frames("<?xml version='1.0' encoding='ISO-8859-1'?><auvsml/>"))
                .containsExactly("1:1 FORBIDDEN_XML", "1:44 <auvsml/>");
        assertThat(frames("<?xml version='1.0' encoding='utf-8'?><auvsml/>"))
                .containsExactly("1:39 <auvsml/>");
    }

    @Test
    void aRootOfTheLargestSizeIsReadAndALargerOneSkipped() {
        String largest = "<auvsml>" + " ".repeat(200 - 17) + "</auvsml>";
        String tooLarge = "<auvsml>" + " ".repeat(200 - 16) + "</auvsml>";

        assertThat(frames(largest)).containsExactly("1:1 " + largest);
        assertThat(frames(tooLarge + "<auvsml/>"))
                .containsExactly("1:1 LIMIT_EXCEEDED", "1:202 <auvsml/>");
    }

    @Test
    void aCommentOrInstructionThatDoesNotEndIsGivenUp() {
        assertThat(frames("<?" + "x".repeat(200) + "<auvsml/>"))
                .containsExactly("1:1 LIMIT_EXCEEDED", "1:203 <auvsml/>");
        assertThat(frames("<!--" + "x".repeat(198) + "<auvsml/>"))
                .containsExactly("1:1 LIMIT_EXCEEDED", "1:203 <auvsml/>");
        assertThat(frames("<auvsml/> <!-- "))
                .containsExactly("1:1 <auvsml/>", "1:11 MALFORMED_XML");
    }

    @Test
    void depthAndAttributesAreLimited() {
        assertThat(frames("<auvsml><a><b><c/></b></a></auvsml>")).hasSize(1);
        assertThat(frames("<auvsml><a><b><c><d/></c></b></a></auvsml><auvsml/>"))
                .containsExactly("1:18 LIMIT_EXCEEDED", "1:43 <auvsml/>");
        assertThat(frames("<auvsml><a a='' b='' c=''/><b a=''/></auvsml>")).hasSize(1);
        assertThat(frames("<auvsml><a a='' b='' c='' d=''/></auvsml><auvsml/>"))
                .containsExactly("1:9 LIMIT_EXCEEDED", "1:42 <auvsml/>");
    }

    @Test
    void siblingsAreNotNested() {
        assertThat(frames("<auvsml>" + "<a/><b></b>".repeat(10) + "</auvsml>")).hasSize(1);
    }

    @Test
    void columnsCountUtf16Units() {
        assertThat(frames("<!-- \u00e9\u20ac\uD83D\uDEA2 --><auvsml/>"))
                .containsExactly("1:14 <auvsml/>");
    }

    private static List<String> frames(String text) {
        byte[] bytes = text.getBytes(UTF_8);
        FrameReader reader = new FrameReader(LIMITS);
        reader.feed(bytes, 0, bytes.length);
        reader.end();
        List<String> frames = new ArrayList<>();
        for (Optional<Frame> next = reader.next(); next.isPresent(); next = reader.next()) {
            frames.add(describe(next.get()));
        }
        return frames;
    }

    private static String describe(Frame frame) {
        return switch (frame) {
            case Frame.Root root ->
                    root.line() + ":" + root.column() + " " + new String(root.bytes(), UTF_8);
            case Frame.Broken(Fault(ErrorCode code, _, _, int line, int column)) ->
                    line + ":" + column + " " + code;
        };
    }
}
