package org.auvsim.auvsml.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.feedback.Covariance;
import org.auvsim.auvsml.message.feedback.DifferentStateFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.feedback.Measurement;
import org.auvsim.auvsml.message.feedback.MeasurementFrame;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** What a robot may say that it measured, and what is refused as it is read. */
class MeasurementTest {
    private static final String HEAD =
            "<auvsml><different-state-feedback-message world-object-id=\"1\" timestamp=\"0.5\""
                    + " handler-name=\"K\"";
    private static final String TAIL = "</different-state-feedback-message></auvsml>";
    private static final String POSITION = "<position x=\"1\" y=\"2\" z=\"3\"/>";

    private static Incoming read(String inner) throws IOException {
        byte[] text = (HEAD + inner + TAIL).getBytes(StandardCharsets.UTF_8);
        MessageCatalogue catalogue = MessageCatalogue.load(MeasurementTest.class.getClassLoader());
        return new AuvsmlReader(
                        new ByteArrayInputStream(text),
                        RootDecoder.strict(catalogue, Limits.MESSAGE),
                        Limits.MESSAGE)
                .next();
    }

    private static FeedbackMessage message(String inner) throws IOException {
        Incoming.Request request = (Incoming.Request) read(inner);
        return (FeedbackMessage) request.messages().getFirst();
    }

    private static String fault(String inner) throws IOException {
        Fault why = ((Incoming.Rejected) read(inner)).fault();
        assertThat(why.path()).startsWith("auvsml/different-state-feedback-message");
        return why.problem();
    }

    private static String covariance(String... rows) {
        return "<covariance><row values=\""
                + String.join("\"/><row values=\"", rows)
                + "\"/></covariance>";
    }

    @Test
    void anyPartOfTheMotionIsTaken() throws IOException {
        Measurement measured =
                message(
                                " frame=\"NED\">"
                                        + POSITION
                                        + "<angular-velocity x=\"0\" y=\"0\" z=\"1\"/>")
                        .measurement();
        assertThat(measured.frame()).isEqualTo(MeasurementFrame.NED);
        assertThat(measured.position()).contains(new Vec3(1, 2, 3));
        assertThat(measured.orientation()).isEmpty();
        assertThat(measured.velocity()).isEmpty();
        assertThat(measured.angularVelocity()).contains(new Vec3(0, 0, 1));
        assertThat(measured.size()).isEqualTo(6);
    }

    @Test
    void nothingIsTooLittle() throws IOException {
        assertThat(fault(">")).contains("must state a position").contains("states none");
    }

    @Test
    void anOrientationThatWasRoundedIsScaledToLengthOne() throws IOException {
        Quat read =
                message("><orientation w=\"0.7071\" x=\"0\" y=\"0\" z=\"0.7071\"/>")
                        .measurement()
                        .orientation()
                        .orElseThrow();
        assertThat(Math.abs(read.norm() - 1)).isLessThan(1e-15);
    }

    @Test
    void anotherQuaternionIsNoOrientation() throws IOException {
        assertThat(fault("><orientation w=\"1\" x=\"1\" y=\"0\" z=\"0\"/>"))
                .contains("a quaternion of length 1 (within 0.001)")
                .contains("has the length 1.4142135623730951");
    }

    @Test
    void aCovarianceHasThreeRowsForEachPart() throws IOException {
        String three = covariance("1 0 0", "0 1 0", "0 0 1");
        assertThat(message(">" + POSITION + three).measurement().covariance())
                .contains(Covariance.diagonal(1, 1, 1));
        assertThat(fault(">" + POSITION + "<velocity x=\"0\" y=\"0\" z=\"0\"/>" + three))
                .contains(
                        "the covariance of 6 measured numbers must have 6 rows of 6 numbers, but"
                                + " has 3");
    }

    @Test
    void aCovarianceIsSquareSymmetricAndPositiveDefinite() throws IOException {
        assertThat(fault(">" + POSITION + covariance("1 0 0", "0 1", "0 0 1")))
                .contains("rows must have 3 numbers, but row 2 has 2");
        assertThat(fault(">" + POSITION + covariance("1 0 0", "0 1 0")))
                .contains("must have 3 rows of 3 numbers, but has 2");
        assertThat(fault(">" + POSITION + covariance("1 0 0", "0.5 1 0", "0 0 1")))
                .contains("symmetric, but row 2 has 0.5 in column 1 and row 1 has 0.0 in column 2");
        assertThat(fault(">" + POSITION + covariance("1 2 0", "2 1 0", "0 0 1")))
                .contains("positive definite")
                .contains("but row 2 has 1.0 on the diagonal, where more than 4.0 is needed");
        assertThat(fault(">" + POSITION + covariance("1 1 0", "1 1 0", "0 0 1")))
                .contains("row 2 has 1.0 on the diagonal, where more than 1.0 is needed");
    }

    @Test
    void numbersAreFinite() throws IOException {
        assertThat(fault("><position x=\"NaN\" y=\"0\" z=\"0\"/>"))
                .contains("expected a finite number, but found 'NaN'");
        assertThat(fault(">" + POSITION + covariance("1 0 0", "0 NaN 0", "0 0 1"))).contains("NaN");
        assertThatThrownBy(
                        () ->
                                new DifferentStateFeedbackMessage(
                                        1,
                                        0,
                                        "K",
                                        Optional.empty(),
                                        Optional.of(new Vec3(0, Double.NaN, 0)),
                                        Optional.empty(),
                                        Optional.empty(),
                                        Optional.empty(),
                                        Optional.empty()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("the position of a measurement must be finite");
    }
}
