package org.auvsim.auvsml.document;

import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.mapping.SchemaWriter;

import java.util.List;

/** The XML schema of AUVSML: its messages and its documents. */
public final class Schema {
    private Schema() {}

    /** As XSD 1.0, with a user's own messages and components if the catalogue has them. */
    public static String of(MessageCatalogue catalogue) {
        return SchemaWriter.write(catalogue, List.of(Scenario.class));
    }
}
