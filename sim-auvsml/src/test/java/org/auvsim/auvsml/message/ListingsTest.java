package org.auvsim.auvsml.message;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.PauseSimulatorCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;
import org.auvsim.auvsml.message.entity.EntityAddedMessage;
import org.auvsim.auvsml.message.entity.GetPropulsorListRequest;
import org.auvsim.auvsml.message.entity.GetWorldObjectListCommand;
import org.auvsim.auvsml.message.entity.ListedPropulsor;
import org.auvsim.auvsml.message.entity.PropulsorListResponse;
import org.auvsim.auvsml.message.entity.WorldObjectAddedMessage;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamReader;

/** The listings of the thesis, chapter 7.1 and appendix, as they are printed. */
class ListingsTest {
    private static final MessageCatalogue CATALOGUE =
            MessageCatalogue.load(ListingsTest.class.getClassLoader());

    static Stream<Arguments> listings() {
        List<Listener> all = List.of(Listener.to(Listener.ALL));
        return Stream.of(
                listing("get-world-object-list-command", new GetWorldObjectListCommand()),
                listing("get-propulsor-list-request", new GetPropulsorListRequest(47)),
                listing(
                        "conversation-world-object-list-response",
                        new WorldObjectListResponse(
                                List.of(
                                        new ListedWorldObject(1, "WorldObject", "Bob"),
                                        new ListedWorldObject(2, "WorldObject", "Carl"),
                                        new ListedWorldObject(3, "WorldObject", "Tank"),
                                        new ListedWorldObject(4, "Agent", "myAgent")))),
                listing(
                        "conversation-propulsor-list-response",
                        propulsors(4, "Aft Thruster", "Forward Thruster", "Ventral Thruster")),
                listing(
                        "listener-registration-request-command",
                        new ListenerRegistrationRequestCommand(
                                true,
                                List.of(
                                        new ListenedObject("52", all),
                                        new ListenedObject("47", all)))),
                listing("pause-simulator-command", new PauseSimulatorCommand()),
                listing("resume-simulator-command", new ResumeSimulatorCommand()),
                listing("shutdown-simulator-command", new ShutdownSimulatorCommand()),
                listing(
                        "apply-direct-force-command",
                        new ApplyDirectForceCommand(
                                47, "Gravity", Frame.WORLD, new Vec3(0, 0, -9.8))),
                listing("remove-force-command", new RemoveForceCommand(47, "Engine Thrust")),
                listing("entity-added-message", new EntityAddedMessage(1.2, 47)),
                listing(
                        "world-object-added-message",
                        new WorldObjectAddedMessage(24.7, 47, new Vec3(14, -89, 22))),
                listing(
                        "movement-state-change-message",
                        new MovementStateChangeMessage(
                                7.8,
                                46,
                                false,
                                new Vec3(1, 2, 3),
                                Mat3.IDENTITY,
                                new Vec3(3, 4, 3),
                                Vec3.ZERO)),
                listing(
                        "timestep-advanced-notification",
                        new TimestepAdvancedNotification(54.6, StateType.ACTUAL)),
                listing(
                        "different-position-feedback-message",
                        new DifferentPositionFeedbackMessage(
                                47,
                                5.6,
                                "DirectPositionChangeFeedbackHandler",
                                new Vec3(1, 2, 3),
                                new Vec3(0.98, 2.1, 3.4),
                                new Vec3(1, 2, 2))),
                listing(
                        "world-object-list-response",
                        new WorldObjectListResponse(
                                List.of(
                                        new ListedWorldObject(47, "WorldObject", "Juggernaut"),
                                        new ListedWorldObject(88, "WorldObject", "Rock"),
                                        new ListedWorldObject(107, "WorldObject", "AUV-1701")))),
                listing(
                        "propulsor-list-response",
                        propulsors(
                                47, "Rudder", "Aft Thruster", "Port Engine", "Starboard Engine")));
    }

    private static Arguments listing(String name, Message message) {
        return Arguments.of(name, message);
    }

    private static PropulsorListResponse propulsors(long id, String... names) {
        return new PropulsorListResponse(id, Stream.of(names).map(ListedPropulsor::new).toList());
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("listings")
    void isRead(String name, Message message) throws Exception {
        AuvsmlReader reader =
                new AuvsmlReader(
                        new ByteArrayInputStream(text(name)),
                        RootDecoder.strict(CATALOGUE, Limits.MESSAGE),
                        Limits.MESSAGE);

        assertThat(reader.next())
                .isEqualTo(new Incoming.Request(Optional.empty(), List.of(message)));
        assertThat(reader.next()).isEqualTo(new Incoming.End());
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("listings")
    void isWritten(String name, Message message) throws Exception {
        byte[] written = new AuvsmlWriter(CATALOGUE).write(message);

        List<String> expected = events(text(name));
        expected.replaceAll(event -> event.replace("auvxml", "auvsml"));
        assertThat(events(written)).isEqualTo(expected);
    }

    private static byte[] text(String name) throws Exception {
        try (InputStream in = ListingsTest.class.getResourceAsStream("listings/" + name + ".xml")) {
            return Optional.ofNullable(in).orElseThrow().readAllBytes();
        }
    }

    /** Tags with their attributes in order, as the JDK's own parser sees them. */
    private static List<String> events(byte[] xml) throws Exception {
        XMLStreamReader reader =
                XMLInputFactory.newDefaultFactory()
                        .createXMLStreamReader(new ByteArrayInputStream(xml));
        List<String> events = new ArrayList<>();
        while (reader.hasNext()) {
            int event = reader.next();
            if (event == XMLStreamReader.START_ELEMENT) {
                StringBuilder tag = new StringBuilder("<" + reader.getLocalName());
                for (int i = 0; i < reader.getAttributeCount(); i++) {
                    tag.append(' ')
                            .append(reader.getAttributeLocalName(i))
                            .append('=')
                            .append(reader.getAttributeValue(i));
                }
                events.add(tag.toString());
            } else if (event == XMLStreamReader.END_ELEMENT) {
                events.add("</" + reader.getLocalName());
            }
        }
        return events;
    }
}
