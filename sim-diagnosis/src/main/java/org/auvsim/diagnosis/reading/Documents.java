package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTreeReader;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;

/** Reads records that are documents of their own: a run's, a mapping of columns. */
final class Documents {
    private final AuvsmlMapper mapper;
    private final XmlTreeReader trees = new XmlTreeReader(Limits.SCENARIO);

    Documents(AuvsmlMapper mapper) {
        this.mapper = mapper;
    }

    /**
     * The record in a file.
     *
     * @throws DocumentException with a sentence for each fault and its place
     */
    <R> R read(Class<R> type, Path file) throws DocumentException {
        try (InputStream in = Files.newInputStream(file)) {
            byte[] text = in.readNBytes(Limits.SCENARIO.bytes() + 1);
            return mapper.decode(type, trees.read(text));
        } catch (AuvsmlException e) {
            throw new DocumentException(
                    e.faults().stream()
                            .map(fault -> fault.in(file))
                            .collect(Collectors.joining("\n")),
                    e);
        } catch (IOException e) {
            throw CsvTable.unreadable(file, e);
        }
    }
}
