package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * That each run of a diagnosis knows what the body was told, if one of them does: else a command
 * that is missing would be taken for a thruster that fails, or be made up for by another cause.
 */
final class ToldAlike {
    private static final List<String> AXES = List.of(".x", ".y", ".z");

    private ToldAlike() {}

    /**
     * Refuses a file that lacks a command.
     *
     * @throws DocumentException naming the column, which file has it, and what to do
     */
    static void require(List<RunFile> files) throws DocumentException {
        Map<String, Source> having = new LinkedHashMap<>();
        for (RunFile file : files) {
            commands(file).forEach(name -> having.putIfAbsent(name, file.sources().getFirst()));
        }
        for (RunFile file : files) {
            Set<String> told = told(file);
            for (Map.Entry<String, Source> each : having.entrySet()) {
                if (file.sources().getFirst().isTable() && !told.contains(each.getKey())) {
                    throw lacking(file, each.getKey(), each.getValue());
                }
            }
        }
    }

    private static List<String> commands(RunFile file) {
        return file.runs().getFirst().commands().stream().map(Command::name).toList();
    }

    /** By columns, or by the document beside them, which says when a force acted. */
    private static Set<String> told(RunFile file) {
        Set<String> told = new HashSet<>(commands(file));
        for (MeasuredRun run : file.runs()) {
            run.forces().forEach(f -> AXES.forEach(axis -> told.add(f.force().name() + axis)));
        }
        return told;
    }

    private static DocumentException lacking(RunFile file, String command, Source other) {
        String column = other.command(command).isEmpty() ? command : other.command(command);
        String has =
                other.isTable()
                        ? "%s has it".formatted(other.file())
                        : "%s tells it".formatted(other.file());
        return new DocumentException(
                "%s:1: column '%s': expected what '%s' was told, for %s, but the header has no such column; add it, rename the one that has it %s, or leave it out of all runs %s"
                        .formatted(
                                file.file(),
                                column,
                                command,
                                has,
                                Remedy.renaming(Remedy.COLUMN, column),
                                Remedy.ignoring(List.of(column))));
    }
}
