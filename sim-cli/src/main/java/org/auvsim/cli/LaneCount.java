package org.auvsim.cli;

import org.auvsim.cli.report.UserError;
import org.auvsim.server.lanes.ThreadLanes;

import picocli.CommandLine.Option;

/** The option {@code --lanes}. */
final class LaneCount {
    @Option(
            names = "--lanes",
            paramLabel = "COUNT",
            defaultValue = "1",
            description =
                    "Threads that share a step's work; the result is the same to the bit, and with"
                            + " thousands of objects faster. By default ${DEFAULT-VALUE}.")
    private int count;

    /**
     * So many lanes, to be closed.
     *
     * @throws UserError if there cannot be so many
     */
    ThreadLanes open() {
        if (count < 1 || count > ThreadLanes.MOST) {
            throw new UserError(
                    "--lanes must be 1 to %d, but is %d.".formatted(ThreadLanes.MOST, count));
        }
        return new ThreadLanes(count);
    }
}
