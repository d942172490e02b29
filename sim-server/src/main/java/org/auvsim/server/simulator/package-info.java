/**
 * The simulator: a world, its clients, and the one loop in which time goes on.
 *
 * <p>To run a world as a server:
 *
 * <pre>{@code
 * TcpTransport tcp = TcpTransport.onLoopback(40001);
 * try (Simulator simulator = Simulator.of(world).transport(tcp).start()) {
 *     System.out.println("listening at port " + tcp.port());
 *     simulator.await();
 * }
 * }</pre>
 *
 * <p>{@code start()} throws {@link org.auvsim.server.net.TransportException} with one clear
 * sentence if the port cannot be had. Corrective feedback is asked for with {@code
 * timestepper(SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(20)))}; by default
 * feedback is ignored; {@code Simulator.of(scenario)} does what a scenario asks for. Other threads
 * reach the world through {@link org.auvsim.server.simulator.Simulator#ask}.
 */
@NullMarked
package org.auvsim.server.simulator;

import org.jspecify.annotations.NullMarked;
