package org.auvsim.cli;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.cli.admin.Administration;
import org.jline.terminal.Terminal;
import org.jline.terminal.TerminalBuilder;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Path;
import java.util.concurrent.Callable;

/** {@code auvsim admin}. */
@Command(
        name = "admin",
        description = "Commands a simulator in plain words, from a terminal or from a pipe.",
        footer = {
            "",
            "At a terminal 'help' lists the commands, Tab completes them, and what was typed is"
                    + " remembered in ~/.auvsim/admin-history. From a pipe the first command that"
                    + " fails ends it with exit code 2.",
            "",
            "Example: echo 'set rate 2' | auvsim admin"
        })
final class Admin implements Callable<Integer> {
    private static final Path HISTORY =
            Path.of(System.getProperty("user.home"), ".auvsim", "admin-history");

    @Spec private CommandSpec spec;

    @Mixin private final Connection connection = new Connection();

    @Override
    public Integer call() throws ConnectionException, IOException, InterruptedException {
        MessageCatalogue catalogue = MessageCatalogue.load(ContextClasses.loader());
        try (AuvsmlClient client = connection.open(catalogue)) {
            Administration administration = new Administration(client, catalogue);
            if (StandardTerminal.isThere()) {
                try (Terminal terminal = TerminalBuilder.terminal()) {
                    administration.converse(terminal, HISTORY);
                }
            } else {
                administration.perform(
                        new BufferedReader(new InputStreamReader(System.in, UTF_8)),
                        spec.commandLine().getOut());
            }
        }
        return 0;
    }
}
