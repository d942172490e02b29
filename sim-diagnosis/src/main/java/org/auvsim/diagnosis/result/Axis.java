package org.auvsim.diagnosis.result;

import org.auvsim.core.entity.Frame;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;

/**
 * Along or about which axis something was measured.
 *
 * @param frame whose axis it is
 * @param letter x, y or z
 */
public record Axis(Frame frame, char letter) {
    private static final String LETTERS = "xyz";
    private static final List<String> WAYS = List.of("ahead", "left", "up");

    /** The axis (0 to 2) of what a run has of a channel. */
    public static Axis of(MeasuredRun run, Channel channel, int axis) {
        Frame frame = channel == Channel.POSITION ? Frame.WORLD : run.frame(channel);
        return new Axis(frame, LETTERS.charAt(axis));
    }

    /** For a sentence: {@code velocity along x}, {@code velocity along the body's x (ahead)}. */
    public String within(Channel channel) {
        return "%s %s %s"
                .formatted(channel.words(), isTurning(channel) ? "about" : "along", words());
    }

    /** For lists, shorter where it is the world's: {@code velocity x}. */
    public String brief(Channel channel) {
        return frame == Frame.WORLD ? channel.words() + " " + letter : within(channel);
    }

    private String words() {
        return frame == Frame.WORLD
                ? String.valueOf(letter)
                : "the body's %s (%s)".formatted(letter, WAYS.get(LETTERS.indexOf(letter)));
    }

    private static boolean isTurning(Channel channel) {
        return channel == Channel.ORIENTATION || channel == Channel.ANGULAR_VELOCITY;
    }
}
