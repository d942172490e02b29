package org.auvsim.auvsml.document;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.xml.PlacedElement;
import org.auvsim.auvsml.xml.XmlTree;
import org.jdom2.Attribute;
import org.jdom2.Text;
import org.xml.sax.ErrorHandler;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.AttributesImpl;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

import javax.xml.XMLConstants;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.SchemaFactory;
import javax.xml.validation.ValidatorHandler;

/**
 * Holds trees against an XML schema. The JDK's validator is told the tree's elements: it never sees
 * the text, which was read safely before.
 */
final class SchemaValidator {
    private final javax.xml.validation.Schema schema;

    SchemaValidator(String xsd) {
        try {
            SchemaFactory factory = SchemaFactory.newDefaultInstance();
            factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
            factory.setProperty(XMLConstants.ACCESS_EXTERNAL_SCHEMA, "");
            schema = factory.newSchema(new StreamSource(new StringReader(xsd)));
        } catch (SAXException e) {
            throw new IllegalStateException("AUVSML's schema is not sound: " + e.getMessage(), e);
        }
    }

    /** What the schema does not allow: one fault an element, at the element's place. */
    List<Fault> faults(XmlTree tree) {
        Walk walk = new Walk(schema.newValidatorHandler());
        try {
            walk.validator.startDocument();
            walk.visit(tree.root());
            walk.validator.endDocument();
        } catch (SAXException e) {
            throw new IllegalStateException("the schema's validator gave up", e);
        }
        return walk.faults;
    }

    /** Tells the validator one tree, element by element. */
    private static final class Walk implements ErrorHandler {
        private final ValidatorHandler validator;
        private final List<Fault> faults = new ArrayList<>();
        private Optional<String> complaint = Optional.empty();

        Walk(ValidatorHandler validator) {
            this.validator = validator;
            validator.setErrorHandler(this);
        }

        void visit(PlacedElement element) throws SAXException {
            String name = element.getName();
            validator.startElement("", name, name, attributes(element));
            Optional<String> atStart = complaint;
            complaint = Optional.empty();
            for (int i = 0; i < element.getContentSize(); i++) {
                if (element.getContent(i) instanceof PlacedElement inner) {
                    visit(inner);
                } else if (element.getContent(i) instanceof Text text) {
                    char[] characters = text.getText().toCharArray();
                    validator.characters(characters, 0, characters.length);
                }
            }
            validator.endElement("", name, name);
            atStart.or(() -> complaint).ifPresent(problem -> report(problem, element));
            complaint = Optional.empty();
        }

        private static AttributesImpl attributes(PlacedElement element) {
            AttributesImpl attributes = new AttributesImpl();
            for (Attribute attribute : element.getAttributes()) {
                String name = attribute.getName();
                attributes.addAttribute("", name, name, "CDATA", attribute.getValue());
            }
            return attributes;
        }

        private void report(String problem, PlacedElement element) {
            faults.add(
                    new Fault(
                            ErrorCode.INVALID_VALUE,
                            problem.replaceFirst("^cvc-[^:]*: ", ""),
                            element.path(),
                            element.place().line(),
                            element.place().column()));
        }

        @Override
        public void warning(SAXParseException e) {
            error(e);
        }

        @Override
        public void error(SAXParseException e) {
            complaint = complaint.or(() -> Optional.of(String.valueOf(e.getMessage())));
        }

        @Override
        public void fatalError(SAXParseException e) {
            error(e);
        }
    }
}
