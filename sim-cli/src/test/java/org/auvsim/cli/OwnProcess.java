package org.auvsim.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A virtual machine of its own, for what cannot be asked of the one that runs the tests. */
final class OwnProcess {
    private OwnProcess() {}

    /**
     * How one is started, up to the name of the program. It ends before the optimizing compiler
     * would pay.
     */
    static List<String> java(String... options) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.add("-XX:TieredStopAtLevel=1");
        command.addAll(List.of(options));
        command.addAll(List.of("-cp", System.getProperty("java.class.path")));
        return command;
    }
}
