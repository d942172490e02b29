package org.auvsim.diagnosis.report;

import org.auvsim.core.entity.Frame;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;

import java.util.Locale;

/** How machines are told of what the program has as constants. */
final class Names {
    private Names() {}

    static String of(Channel channel) {
        return channel.name().toLowerCase(Locale.ROOT);
    }

    static String of(Frame frame) {
        return frame.name().toLowerCase(Locale.ROOT);
    }

    static String of(Verdict verdict) {
        return verdict.name().toLowerCase(Locale.ROOT);
    }
}
