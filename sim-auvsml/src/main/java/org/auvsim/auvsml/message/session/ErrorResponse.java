package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.RefusedException;

import java.util.OptionalInt;

/**
 * Something that the client sent cannot be read or done; nothing of it was applied.
 *
 * @param text one sentence: what was expected, what was found, what to do
 * @param line of the place in all that the client sent, from 1, if there is one
 * @param column of that place, from 1
 */
public record ErrorResponse(ErrorCode code, String text, OptionalInt line, OptionalInt column)
        implements Message {
    /** The response to a text that cannot be read. */
    public static ErrorResponse of(Fault fault) {
        return new ErrorResponse(
                fault.code(),
                fault.sentence(),
                OptionalInt.of(fault.line()),
                OptionalInt.of(fault.column()));
    }

    /** The response to a command that cannot be done. */
    public static ErrorResponse of(RefusedException refusal) {
        return new ErrorResponse(
                refusal.code(),
                String.valueOf(refusal.getMessage()),
                OptionalInt.empty(),
                OptionalInt.empty());
    }
}
