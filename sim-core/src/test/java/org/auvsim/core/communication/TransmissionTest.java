package org.auvsim.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldException;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

class TransmissionTest {
    private static final double LIGHT = 299_792_458;
    private static final Volume BALL = new Sphere(0.5);

    private static AcousticModem modem(String channel, double range, double loss) {
        return new AcousticModem("modem", Vec3.ZERO, channel, range, 1500, loss, 7);
    }

    private static Radio radio(double range) {
        return new Radio("radio", new Vec3(0, 0, 0.4), "1", range, 0, 0, 0, 0);
    }

    private static WorldObjectDefinition.Builder vehicle(
            String name, Volume volume, double x, double z, Component... components) {
        WorldObjectDefinition.Builder vehicle =
                WorldObjectDefinition.named(name).mass(5).volume(volume).position(x, 0, z);
        for (Component component : components) {
            vehicle.component(component);
        }
        return vehicle;
    }

    private static WorldBuilder sea(WorldObjectDefinition.Builder... vehicles) {
        WorldBuilder world = World.builder();
        for (WorldObjectDefinition.Builder vehicle : vehicles) {
            world.add(vehicle.build());
        }
        return world;
    }

    private static List<WorldEvent.SignalReceived> heard(World world, int steps) {
        List<WorldEvent.SignalReceived> heard = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.SignalReceived received) {
                        heard.add(received);
                    }
                });
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
        return heard;
    }

    private static void send(World world, Class<? extends Transceiver> kind, String text) {
        world.transmit(world.object("A").id(), kind, kind == Radio.class ? "radio" : "modem", text);
    }

    @Test
    void aMessageArrivesAfterItsTravelTime() {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 2000, 0)),
                                vehicle("B", BALL, 750.5, 0, modem("1", 2000, 0)),
                                vehicle(
                                        "C",
                                        new Box(new Vec3(1, 1, 1)),
                                        -1200.5,
                                        0,
                                        modem("1", 1, 0)))
                        .build();
        world.advanceTimestep();
        send(world, AcousticModem.class, "surface!");

        List<WorldEvent.SignalReceived> heard = heard(world, 40);

        assertThat(heard).hasSize(2);
        TextMessage expected = new TextMessage(1, "modem", "1", 0.05, "surface!");
        assertThat(heard).extracting(WorldEvent.SignalReceived::signal).containsOnly(expected);
        assertThat(heard).extracting(WorldEvent.SignalReceived::objectId).containsExactly(2L, 3L);
        assertThat(heard.get(0).time()).isCloseTo(0.05 + 750 / 1500.0, within(1e-8));
        assertThat(heard.get(1).time()).isCloseTo(0.05 + 1200 / 1500.0, within(1e-8));
    }

    @Test
    void whoMovesTowardItHearsItEarlier() {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 2000, 0)),
                                vehicle("B", BALL, 150.5, 0, modem("1", 2000, 0))
                                        .velocity(-10, 0, 0))
                        .build();
        send(world, AcousticModem.class, "?");

        assertThat(heard(world, 3).getFirst().time()).isCloseTo(150 / 1510.0, within(1e-8));
    }

    @Test
    void itReachesNobodyOutOfRangeOfAnotherChannelOrWithoutAModem() {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 100, 0)),
                                vehicle("far", BALL, 101, 0, modem("1", 1000, 0)),
                                vehicle("other", BALL, 20, 0, modem("2", 1000, 0)),
                                vehicle("rock", BALL, 10, 0),
                                vehicle("gull", BALL, 30, 0, radio(1000)))
                        .build();
        send(world, AcousticModem.class, "hello");

        assertThat(world.entities()).hasSize(6);
        assertThat(heard(world, 10)).isEmpty();
        assertThat(world.entities()).hasSize(5);
    }

    @Test
    void eachObjectHearsItOnceAndTheSenderDoesNot() {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 3000, 0)),
                                vehicle("B", new Capsule(0.5, 40), 60, 0, modem("1", 1, 0)))
                        .build();
        send(world, AcousticModem.class, "one");
        send(world, AcousticModem.class, "two");

        assertThat(heard(world, 50))
                .extracting(read -> ((TextMessage) read.signal()).text())
                .containsExactly("one", "two");
    }

    @Test
    void fixedBuoysHearToo() {
        World world =
                sea(
                                vehicle("A", BALL, 0, -5, modem("1", 3000, 0)),
                                WorldObjectDefinition.named("Buoy")
                                        .fixed()
                                        .volume(BALL)
                                        .position(300.5, 0, -5)
                                        .component(modem("1", 1, 0)),
                                WorldObjectDefinition.named("Bottom")
                                        .fixed()
                                        .volume(new HalfSpace())
                                        .position(0, 0, -20))
                        .build();
        send(world, AcousticModem.class, "hello");

        List<WorldEvent.SignalReceived> heard = heard(world, 6);
        assertThat(heard).hasSize(1);
        assertThat(heard.getFirst().time()).isCloseTo(0.2, within(1e-8));
    }

    @Test
    void radioTravelsAtTheSpeedOfLightThroughAir() {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, radio(5000)),
                                vehicle("B", BALL, 3000.5, 0, radio(1)),
                                vehicle("boat", new Box(new Vec3(1, 1, 1)), -4000.5, 0, radio(1)),
                                vehicle("beyond", new Box(new Vec3(1, 1, 1)), 5200, 0, radio(1)),
                                vehicle("diver", BALL, 50, -2, radio(1)))
                        .build();
        send(world, Radio.class, "ahoy");

        List<WorldEvent.SignalReceived> heard = heard(world, 1);

        assertThat(heard).extracting(WorldEvent.SignalReceived::objectId).containsExactly(2L, 3L);
        // hulls are a little nearer than antennas' heights: 0.4 m up on 3 km
        assertThat(heard.get(0).time() * LIGHT).isCloseTo(3000, within(0.01));
        assertThat(heard.get(1).time() * LIGHT).isCloseTo(4000, within(0.01));
        assertThat(world.entities()).hasSize(5);
    }

    @Test
    void underWaterARadioIsDumb() {
        World world =
                sea(vehicle("A", BALL, 0, -1, radio(5000)), vehicle("B", BALL, 30, 0, radio(1)))
                        .build();
        send(world, Radio.class, "ahoy");

        assertThat(world.entities()).hasSize(2);
        assertThat(heard(world, 1)).isEmpty();
    }

    @Test
    void anyAntennaThatIsDryHears() {
        Radio low = new Radio("low", new Vec3(0, 0, -0.4), "1", 1, 0, 0, 0, 0);
        Radio mast = new Radio("mast", new Vec3(0, 0, 0.4), "1", 1, 0, 0, 0, 0);
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, radio(5000)),
                                vehicle("B", BALL, 30, 0, low, mast),
                                vehicle("C", BALL, 60, 0, mast, low),
                                vehicle("diver", BALL, 90, -3, low, mast))
                        .build();
        send(world, Radio.class, "ahoy");

        assertThat(heard(world, 1))
                .extracting(WorldEvent.SignalReceived::objectId)
                .containsExactly(2L, 3L);
    }

    @Test
    void whatOneTransceiverLosesAnotherMayHear() {
        AcousticModem deaf = new AcousticModem("deaf", Vec3.ZERO, "1", 9, 1500, 1, 7);
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 100, 0)),
                                vehicle("B", BALL, 10, 0, deaf, modem("1", 9, 0)),
                                vehicle("C", BALL, 20, 0, deaf))
                        .build();
        send(world, AcousticModem.class, "hello");

        assertThat(heard(world, 1))
                .extracting(WorldEvent.SignalReceived::objectId)
                .containsExactly(2L);
    }

    @Test
    void theShareOfLossesIsLostAndTheSameOnesEachTime() {
        int messages = 400;
        List<String> heard = texts(messages);

        assertThat(heard).isEqualTo(texts(messages));
        assertThat(1 - heard.size() / (double) messages)
                .isCloseTo(0.3, within(5 * Math.sqrt(0.3 * 0.7 / messages)));
    }

    private static List<String> texts(int messages) {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 30, 0)),
                                vehicle("B", BALL, 20, 0, modem("1", 30, 0.3)))
                        .build();
        for (int i = 0; i < messages; i++) {
            send(world, AcousticModem.class, "message " + i);
        }
        return heard(world, 1).stream().map(r -> ((TextMessage) r.signal()).text()).toList();
    }

    @Test
    void aCopyHearsWhatTheOriginalHears() {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 2000, 0)),
                                vehicle("B", BALL, 750.5, 0, modem("1", 2000, 0)))
                        .build();
        send(world, AcousticModem.class, "hello");
        world.advanceTimestep();
        World copy = world.copy();

        assertThat(heard(copy, 20)).hasSize(1).isEqualTo(heard(world, 20));
    }

    @Test
    void theSnapshotStepperCarriesMessagesToo() {
        World world =
                sea(
                                vehicle("A", BALL, 0, 0, modem("1", 2000, 0)),
                                vehicle("B", BALL, 75.5, 0, modem("1", 2000, 0)))
                        .stepper(SnapshotStepper.standard())
                        .build();
        send(world, AcousticModem.class, "hello");

        List<WorldEvent.SignalReceived> heard = heard(world, 20);
        assertThat(heard).hasSize(1);
        assertThat(heard.getFirst().time()).isCloseTo(0.05, within(1e-6));
    }

    @Test
    void unknownObjectsAndTransceiversAreRefused() {
        World world = sea(vehicle("A", BALL, 0, 0, modem("1", 100, 0), radio(9))).build();

        assertThatThrownBy(() -> world.transmit(9, Radio.class, "radio", "hello"))
                .isInstanceOf(WorldException.class)
                .hasMessageContaining("no world object has the id 9");
        assertThatThrownBy(() -> world.transmit(1, Radio.class, "modem", "hello"))
                .hasMessage("'A' has no Radio 'modem'; it has [radio]");
    }

    @Test
    void whatMakesNoSenseIsRefused() {
        assertThatThrownBy(() -> modem("1", 0, 0))
                .hasMessage(
                        "the range of acoustic-modem 'modem' must be above 0 m and finite, but is"
                                + " 0.0 m");
        assertThatThrownBy(() -> modem("1", 1, 2))
                .hasMessage("the loss of acoustic-modem 'modem' must be 0.0 to 1.0, but is 2.0");
    }
}
