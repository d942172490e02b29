package org.auvsim.cli;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.cli.report.UserError;

import java.util.List;
import java.util.Optional;

/** A message to a simulator whose answer is awaited. */
final class Question {
    private Question() {}

    /**
     * What a simulator answers to one message; what else comes meanwhile is passed over.
     *
     * @throws UserError if it refuses
     */
    static List<Message> ask(AuvsmlClient client, Message question) throws ConnectionException {
        String requestId = question.getClass().getSimpleName();
        client.request(requestId, question);
        while (true) {
            Received received =
                    client.next()
                            .orElseThrow(
                                    () -> new UserError("The simulator ended the connection."));
            if (received.requestId().equals(Optional.of(requestId))) {
                for (Message message : received.messages()) {
                    if (message instanceof ErrorResponse error) {
                        throw new UserError("The simulator refuses: %s".formatted(error.text()));
                    }
                }
                return received.messages();
            }
        }
    }
}
