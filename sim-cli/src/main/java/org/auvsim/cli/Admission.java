package org.auvsim.cli;

import org.auvsim.auvsml.Role;
import org.auvsim.cli.report.UserError;

import picocli.CommandLine.Option;

import java.net.InetSocketAddress;
import java.util.Optional;

/** The options {@code --port}, {@code --bind} and {@code --role}: who comes in, and to do what. */
final class Admission {
    @Option(
            names = "--port",
            paramLabel = "PORT",
            defaultValue = "" + Address.STANDARD_PORT,
            description = "Port to listen at, 0 for any free one; by default ${DEFAULT-VALUE}.")
    private int port;

    @Option(
            names = "--bind",
            paramLabel = "ADDRESS",
            defaultValue = "127.0.0.1",
            description =
                    "Address to listen at; by default ${DEFAULT-VALUE}, which only this machine"
                            + " reaches. Any other needs --role.")
    private String bind = "";

    @Option(
            names = "--role",
            paramLabel = "ROLE",
            description =
                    "What those who connect may do: viewer (listen and ask), controller (also"
                        + " control objects and send feedback) or admin (everything). By default"
                        + " admin, if only this machine reaches the server.")
    private Optional<Role> role = Optional.empty();

    /**
     * Where to listen.
     *
     * @throws UserError if there is no such address or port
     */
    InetSocketAddress address() {
        if (port < 0 || port > 65535) {
            throw new UserError("--port must be 0 to 65535, but is %d.".formatted(port));
        }
        InetSocketAddress address = new InetSocketAddress(bind, port);
        if (address.isUnresolved()) {
            throw new UserError("--bind: there is no address '%s' here.".formatted(bind));
        }
        return address;
    }

    /**
     * What those who connect may do.
     *
     * @throws UserError if it is not stated and others than this machine can connect
     */
    Role role() {
        if (role.isEmpty() && !address().getAddress().isLoopbackAddress()) {
            throw new UserError(
                    "--bind %s lets other machines in, and nobody there proves who he is: say with --role viewer, controller or admin what they may do."
                            .formatted(bind));
        }
        return role.orElse(Role.ADMIN);
    }
}
