package org.auvsim.auvsml.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_16;
import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;

class XmlTreeReaderTest {
    private final XmlTreeReader reader = new XmlTreeReader(new Limits(20_000, 32, 64));

    @Test
    void elementsAndAttributesKnowTheirPlaces() throws Exception {
        XmlTree tree =
                reader.read(
                        "\uFEFF<a>\r\n  <!-- \u20ac -->\n  <b one='\u00e9 two=\"' \n\ttwo  = '2>'/></a>"
                                .getBytes(UTF_8));
        PlacedElement b = (PlacedElement) tree.root().getChild("b");

        assertThat(b.place()).isEqualTo(new Place(3, 3));
        assertThat(b.path()).isEqualTo("a/b");
        assertThat(tree.placeOf(b, "one")).isEqualTo(new Place(3, 6));
        assertThat(tree.placeOf(b, "two")).isEqualTo(new Place(4, 2));
        assertThat(tree.placeOf(b, "three")).isEqualTo(b.place());
    }

    @Test
    void neitherDoctypeNorEntitiesAreRead(@TempDir Path folder) throws Exception {
        Path secret = Files.writeString(folder.resolve("secret"), "secret");
        String external = "<!ENTITY e SYSTEM '" + secret.toUri() + "'>";

        assertRefused("<!DOCTYPE a [" + external + "]><a>&e;</a>", ErrorCode.FORBIDDEN_XML);
        assertRefused(
                "<!DOCTYPE a [<!ENTITY e 'ha'><!ENTITY f '&e;&e;'>]><a>&f;</a>",
                ErrorCode.FORBIDDEN_XML);
        assertRefused("<!DOCTYPE a SYSTEM '" + secret.toUri() + "'><a/>", ErrorCode.FORBIDDEN_XML);
        assertRefused("<!DOCTYPE a><a/>", ErrorCode.FORBIDDEN_XML);
        assertRefused("<a>&e;</a>", ErrorCode.FORBIDDEN_XML);
        assertRefused("<a b='&e;'/>", ErrorCode.FORBIDDEN_XML);
    }

    @Test
    void onlyUtf8IsRead() {
        assertRefused("<?xml version='1.0' encoding='UTF-16'?><a/>", ErrorCode.FORBIDDEN_XML);
        assertRefused("<?xml version='1.0' encoding='ISO-8859-1'?><a/>", ErrorCode.FORBIDDEN_XML);
        assertThatThrownBy(() -> reader.read("<a/>".getBytes(UTF_16)))
                .isInstanceOf(AuvsmlException.class);
        assertThatThrownBy(
                        () ->
                                reader.read(
                                        new byte[] {'<', 'a', (byte) 0xC1, (byte) 0xBF, '/', '>'}))
                .isInstanceOf(AuvsmlException.class);
    }

    @Test
    void sizeDepthAndAttributesAreLimited() {
        assertRefused("<a>" + " ".repeat(20_000) + "</a>", ErrorCode.LIMIT_EXCEEDED);
        assertRefused("<a>".repeat(33) + "</a>".repeat(33), ErrorCode.LIMIT_EXCEEDED);
        assertRefused("<a b='" + "x".repeat(5000) + "'/>", ErrorCode.LIMIT_EXCEEDED);
        StringBuilder attributes = new StringBuilder();
        for (int i = 0; i < 65; i++) {
            attributes.append(" a").append(i).append("=''");
        }
        assertRefused("<a" + attributes + "/>", ErrorCode.LIMIT_EXCEEDED);
    }

    @Test
    void whatIsNotWellFormedIsRefused() {
        for (String text :
                new String[] {
                    "",
                    " ",
                    "a",
                    "<a>",
                    "</a>",
                    "<a></b>",
                    "<a/><a/>",
                    "<a b=1/>",
                    "<a b='1' b='2'/>",
                    "<a b='<'/>",
                    "<a>&#0;</a>",
                    "<a>]]></a>",
                    "<a><!-- -- --></a>",
                    "<a:b/>"
                }) {
            assertRefused(text, ErrorCode.MALFORMED_XML);
        }
    }

    @Test
    void anotherKindOfFileIsToldAsThat() {
        assertThatThrownBy(() -> reader.read("t,x,y\n0,1,2\n".getBytes(UTF_8)))
                .isInstanceOf(AuvsmlException.class)
                .hasMessageEndingWith("expected XML, which begins with '<', but there is 't'");
    }

    @Test
    void whatEndsTooSoonIsToldAsThat() {
        assertThatThrownBy(() -> reader.read(new byte[0]))
                .hasMessageEndingWith("expected XML, but there is nothing");
        assertThatThrownBy(() -> reader.read("<a><b/>".getBytes(UTF_8)))
                .hasMessageEndingWith("expected </a>, but the text ends: was it cut off?");
    }

    private void assertRefused(String text, ErrorCode code) {
        assertThatThrownBy(() -> reader.read(text.getBytes(UTF_8)))
                .as(text)
                .isInstanceOfSatisfying(
                        AuvsmlException.class,
                        e -> assertThat(e.fault().code()).as(e.getMessage()).isEqualTo(code));
    }
}
