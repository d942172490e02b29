package org.auvsim.cli;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.mapping.MessageCatalogue;

import picocli.CommandLine.Parameters;

/** The parameter {@code HOST:PORT}, after all others: the simulator to talk to. */
final class Connection {
    @Parameters(
            index = "0+",
            arity = "0..1",
            paramLabel = "HOST:PORT",
            defaultValue = Address.STANDARD,
            converter = Address.Converter.class,
            description = "Where the simulator listens; by default ${DEFAULT-VALUE}.")
    private Address address;

    /** Connects with AUVSML's own messages. */
    AuvsmlClient open() throws ConnectionException {
        return AuvsmlClient.connect(address.host(), address.port());
    }

    /** Connects with the messages of a catalogue. */
    AuvsmlClient open(MessageCatalogue catalogue) throws ConnectionException {
        return AuvsmlClient.connect(address.host(), address.port(), catalogue);
    }
}
