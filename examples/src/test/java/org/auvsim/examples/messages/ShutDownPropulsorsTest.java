package org.auvsim.examples.messages;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.auvsml.message.entity.ListedPropulsor;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;

/** Listing 7.2 of the thesis, as it is printed, and what it does. */
class ShutDownPropulsorsTest {
    private static final MessageCatalogue CATALOGUE =
            MessageCatalogue.load(ShutDownPropulsorsTest.class.getClassLoader());

    private static final ShutDownPropulsors LISTING =
            new ShutDownPropulsors(
                    4,
                    List.of(
                            new ListedPropulsor("Aft Thruster"),
                            new ListedPropulsor("Forward Thruster")));

    private static byte[] listing() throws Exception {
        try (InputStream in =
                ShutDownPropulsorsTest.class.getResourceAsStream("shut-down-propulsors.xml")) {
            return Optional.ofNullable(in).orElseThrow().readAllBytes();
        }
    }

    @Test
    void theListingIsRead() throws Exception {
        AuvsmlReader reader =
                new AuvsmlReader(
                        new ByteArrayInputStream(listing()),
                        RootDecoder.strict(CATALOGUE, Limits.MESSAGE),
                        Limits.MESSAGE);

        assertThat(reader.next())
                .isEqualTo(new Incoming.Request(Optional.empty(), List.of(LISTING)));
    }

    @Test
    void theListingIsWritten() throws Exception {
        String written =
                new String(new AuvsmlWriter(CATALOGUE).write(LISTING), StandardCharsets.UTF_8);

        String printed = new String(listing(), StandardCharsets.UTF_8);
        assertThat(withoutBlanks(written)).isEqualTo(withoutBlanks(printed));
    }

    private static String withoutBlanks(String xml) {
        return xml.replaceAll(">\\s+<", "><").replace(" />", "/>").strip();
    }

    /** A port to an object that can do nothing but set propulsors. */
    private static WorldObjectControl port(WorldObject object) {
        return (WorldObjectControl)
                Proxy.newProxyInstance(
                        WorldObjectControl.class.getClassLoader(),
                        new Class<?>[] {WorldObjectControl.class},
                        (_, method, arguments) -> {
                            assertThat(method.getName()).isEqualTo("setPropulsorLevel");
                            object.command(
                                    Propulsor.class, (String) arguments[0], (double) arguments[1]);
                            return null;
                        });
    }

    @Test
    void thePropulsorsThatItNamesAreShutDown() {
        World world =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("myAgent")
                                        .id(4)
                                        .volume(new Sphere(1))
                                        .mass(1)
                                        .component(running("Aft Thruster"))
                                        .component(running("Forward Thruster"))
                                        .component(running("Ventral Thruster"))
                                        .build())
                        .build();

        Optional<?> response = LISTING.execute(port(world.object(LISTING.worldObjectId())));

        assertThat(response).isEmpty();
        assertThat(world.object(4).components(Propulsor.class))
                .extracting(Propulsor::level)
                .containsExactly(0.0, 0.0, 0.8);
    }

    private static Propulsor running(String name) {
        return new Propulsor(name, 10, 0.8, Vec3.ZERO, new Vec3(1, 0, 0));
    }
}
