package org.auvsim.cli;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.diagnosis.reading.RunReader;

import picocli.CommandLine.Option;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Options that say how the columns of measured runs are to be read. */
final class RunFormat {
    @Option(
            names = "--mapping",
            paramLabel = "FILE",
            description = "A column-mapping document: names, units and axes of the columns.")
    private Optional<Path> mapping = Optional.empty();

    @Option(
            names = "--ned",
            description =
                    "Positions are north, east, down; body axes forward, right, down. By default"
                            + " east, north, up and forward, left, up.")
    private boolean ned;

    @Option(names = "--degrees", description = "Angles and their rates are in degrees.")
    private boolean degrees;

    @Option(
            names = "--rename",
            split = ",",
            paramLabel = "NAME=USUAL",
            description = "A column's name and the usual one for what it has, as time_s=t.")
    private Map<String, String> renamed = new LinkedHashMap<>();

    @Option(
            names = "--ignore",
            split = ",",
            paramLabel = "NAME",
            description = "Columns to leave out.")
    private List<String> ignored = new ArrayList<>();

    @Option(names = "--ignore-others", description = "Leaves out all columns of unknown names.")
    private boolean ignoreOthers;

    /**
     * The mapping, and what the options say beside it.
     *
     * @throws DocumentException if the mapping's file cannot be used
     */
    ColumnMapping mapping(AuvsmlMapper mapper) throws DocumentException {
        ColumnMapping stated =
                mapping.isPresent()
                        ? RunReader.mapping(mapping.get(), mapper)
                        : ColumnMapping.USUAL;
        stated = ned ? stated.in(MeasuredAxes.NED) : stated;
        stated = degrees ? stated.inDegrees() : stated;
        stated = ignoreOthers ? stated.ignoringOthers() : stated;
        List<MappedColumn> columns = new ArrayList<>();
        renamed.forEach((name, usual) -> columns.add(MappedColumn.renamed(name, usual)));
        ignored.forEach(name -> columns.add(MappedColumn.ignored(name)));
        return stated.with(columns);
    }
}
