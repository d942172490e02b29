package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.MomentumRule;
import org.auvsim.auvsml.message.command.RefusedException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

class FeedbackProcessorsTest {
    /** A user's own. */
    public record Own() implements FeedbackProcessor {
        @Override
        public Phase phase() {
            return Phase.AFTER_STEP;
        }

        @Override
        public void process(Correction correction) {
            correction.object().setVelocity(correction.target().velocity().orElseThrow());
        }
    }

    @TempDir private Path folder = Path.of("");

    private FeedbackProcessors naming(String className) throws IOException {
        Path file = folder.resolve("META-INF/services/" + FeedbackProcessor.class.getName());
        Files.createDirectories(file.getParent());
        Files.writeString(file, className + "\n");
        URL[] urls = {folder.toUri().toURL()};
        try (URLClassLoader classes = new URLClassLoader(urls, getClass().getClassLoader())) {
            return FeedbackProcessors.standard(classes);
        }
    }

    @Test
    void aProviderFileAddsAProcessor() throws IOException {
        FeedbackProcessors processors = naming(Own.class.getName());
        assertThat(processors.named("Own")).isEqualTo(new Own());
        assertThat(processors.named("VectorAdjustmentFeedbackHandler"))
                .isEqualTo(new VectorAdjustmentFeedbackHandler());
    }

    @Test
    void aProcessorThatIsNotThereIsNamed() {
        assertThatThrownBy(() -> naming("org.example.Missing"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("org.example.Missing")
                .hasMessageContaining("a public class with a public constructor");
    }

    @Test
    void anotherOverrideTakesTheFirstOnesPlace() {
        FeedbackProcessors processors = FeedbackProcessors.standard();
        processors.override("IgnoreFeedbackHandler");
        processors.override("DirectPositionChangeFeedbackHandler");
        assertThat(processors.named("VectorAdjustmentFeedbackHandler"))
                .isEqualTo(new DirectPositionChangeFeedbackHandler());
        processors.overrideNone();
        assertThat(processors.named("IgnoreFeedbackHandler"))
                .isEqualTo(new IgnoreFeedbackHandler());
    }

    @Test
    void whatAScenarioStatesHoldsUntilTheNextOne() {
        FeedbackProcessors processors = FeedbackProcessors.standard();
        FeedbackProcessor stated = new VectorAdjustmentFeedbackHandler(MomentumRule.AS_THESIS);
        processors.configure(List.of(stated), Optional.of("VectorAdjustmentFeedbackHandler"));
        assertThat(processors.named("IgnoreFeedbackHandler")).isEqualTo(stated);
        assertThatThrownBy(() -> processors.configure(List.of(), Optional.of("Magic")))
                .isInstanceOf(RefusedException.class)
                .hasMessageStartingWith("no feedback processor has the name 'Magic'");
        assertThat(processors.named("IgnoreFeedbackHandler")).isEqualTo(stated);
        processors.configure(List.of(), Optional.empty());
        assertThat(processors.named("VectorAdjustmentFeedbackHandler"))
                .isEqualTo(new VectorAdjustmentFeedbackHandler());
    }
}
