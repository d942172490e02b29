package org.auvsim.auvsml.document;

import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.mapping.SchemaWriter;
import org.auvsim.auvsml.recording.EntryTypes;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.Run;

import java.util.ArrayList;
import java.util.List;

/** The XML schema of AUVSML: its messages and its documents. */
public final class Schema {
    private Schema() {}

    /** As XSD 1.0, with a user's own messages and components if the catalogue has them. */
    public static String of(MessageCatalogue catalogue) {
        List<Class<?>> documents = new ArrayList<>();
        documents.add(Scenario.class);
        documents.add(Recording.class);
        documents.addAll(EntryTypes.all());
        documents.add(Run.class);
        documents.add(ColumnMapping.class);
        return SchemaWriter.write(catalogue, documents);
    }
}
