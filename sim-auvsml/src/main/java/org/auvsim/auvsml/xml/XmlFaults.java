package org.auvsim.auvsml.xml;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.jspecify.annotations.Nullable;

import java.util.Locale;
import java.util.regex.Pattern;

import javax.xml.stream.Location;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/** The sentences about texts that are not the XML that is wanted. */
final class XmlFaults {
    /** Of what is another kind of text from its first character on. */
    private static final Pattern NO_XML =
            Pattern.compile("unexpected character ('.+')(?: \\(.+\\))? in prolog; expected '<'");

    private static final Pattern NOTHING = Pattern.compile("unexpected EOF in prolog");

    private static final Pattern CUT_OFF =
            Pattern.compile("unexpected EOF; was expecting a close tag for element <(.+)>");

    private XmlFaults() {}

    static Fault tooLarge(Limits limits) {
        return new Fault(
                ErrorCode.LIMIT_EXCEEDED,
                "expected at most " + limits.bytes() + " bytes, but there are more",
                "",
                1,
                1);
    }

    static Fault forbidden(Location location) {
        return at(
                location,
                ErrorCode.FORBIDDEN_XML,
                "AUVSML has no DOCTYPE and no entities: take them out");
    }

    static Fault noRoot(Location location) {
        return at(location, ErrorCode.MALFORMED_XML, "expected an element, but there is none");
    }

    /** What the parser found, most often in its words but on one line. */
    static Fault of(XMLStreamException e) {
        String text = plain(sentence(e));
        ErrorCode code = ErrorCode.MALFORMED_XML;
        if (text.startsWith("maximum ") || text.contains("limit (")) {
            code = ErrorCode.LIMIT_EXCEEDED;
        } else if (text.startsWith("undeclared general entity")) {
            code = ErrorCode.FORBIDDEN_XML;
        }
        return at(e.getLocation(), code, text);
    }

    /** What happens most often, as people would say it. */
    private static String plain(String text) {
        String noXml =
                NO_XML.matcher(text)
                        .replaceFirst("expected XML, which begins with '<', but there is $1");
        String nothing = NOTHING.matcher(noXml).replaceFirst("expected XML, but there is nothing");
        return CUT_OFF.matcher(nothing)
                .replaceFirst("expected </$1>, but the text ends: was it cut off?");
    }

    static String sentence(Exception e) {
        String message = String.valueOf(e.getMessage());
        String first = message.lines().findFirst().orElse("not well-formed").strip();
        int end = first.endsWith(".") ? first.length() - 1 : first.length();
        String text = first.substring(0, end);
        return text.substring(0, 1).toLowerCase(Locale.ROOT) + text.substring(1);
    }

    static void refuseOtherEncoding(XMLStreamReader reader) throws AuvsmlException {
        String declared = reader.getCharacterEncodingScheme();
        if (declared != null && !isUtf8(declared)) {
            throw new AuvsmlException(
                    at(
                            reader.getLocation(),
                            ErrorCode.FORBIDDEN_XML,
                            "expected the encoding UTF-8, but the text declares " + declared));
        }
    }

    private static boolean isUtf8(String encoding) {
        return encoding.equalsIgnoreCase("UTF-8") || encoding.equalsIgnoreCase("US-ASCII");
    }

    private static Fault at(@Nullable Location location, ErrorCode code, String problem) {
        return location == null
                ? new Fault(code, problem, "", 1, 1)
                : new Fault(
                        code,
                        problem,
                        "",
                        Math.max(1, location.getLineNumber()),
                        Math.max(1, location.getColumnNumber()));
    }
}
