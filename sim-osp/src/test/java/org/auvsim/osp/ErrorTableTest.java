// SPDX-License-Identifier: GPL-2.0-or-later
package org.auvsim.osp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;

/** What each solver is off on a spring, and what it costs; the table of docs/osp.md. */
class ErrorTableTest {
    private static final double OMEGA = 2;
    private static final double END = 8;

    /** Pulls with omega^2 m x, and counts how often it is asked. */
    private record CountedSpring(AtomicLong evaluations) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            evaluations.incrementAndGet();
            block.addForce(i, block.position(i).times(-OMEGA * OMEGA));
        }
    }

    /** The largest error (m), and what a step costs. */
    private record Row(double error, double evaluations, double microseconds) {}

    /** From rest at 1 m, in steps of a length (s): x = cos(omega t). */
    private static Row row(Integrator integrator, double step) {
        AtomicLong evaluations = new AtomicLong();
        World world =
                World.builder()
                        .timeStep(step)
                        .integrator(integrator)
                        .add(
                                WorldObjectDefinition.named("ball")
                                        .mass(1)
                                        .volume(new Sphere(0.1))
                                        .position(1, 0, 0)
                                        .effect(new CountedSpring(evaluations))
                                        .build())
                        .build();
        int steps = (int) Math.round(END / step);
        double error = 0;
        long begin = System.nanoTime();
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
            double truth = StrictMath.cos(OMEGA * world.time());
            error = Math.max(error, Math.abs(world.object(1).position().x() - truth));
        }
        double microseconds = (System.nanoTime() - begin) / 1e3 / steps;
        return new Row(error, (double) evaluations.get() / steps, microseconds);
    }

    private static Map<Integrator, Integer> fixed() {
        Map<Integrator, Integer> orders = new LinkedHashMap<>();
        orders.put(new Rk4(), 4);
        orders.put(new OspRk4(), 4);
        orders.put(new OspButcher5(), 5);
        orders.put(new OspFehlberg8(), 8);
        return orders;
    }

    @Test
    void errorsFallWithTheOrders() {
        fixed().forEach(
                        (integrator, order) -> {
                            double ratio =
                                    row(integrator, 0.1).error() / row(integrator, 0.05).error();
                            assertThat(StrictMath.log(ratio) / StrictMath.log(2))
                                    .as(integrator.toString())
                                    .isCloseTo(order, within(0.1));
                        });
    }

    @Test
    void theirRk4IsOurs() {
        assertThat(row(new OspRk4(), 0.1).error())
                .isCloseTo(row(new Rk4(), 0.1).error(), within(1e-13));
    }

    @Test
    void adaptiveSolversKeepTheirToleranceAtAnyStep() {
        for (double step : List.of(1.0, 0.2, 0.05)) {
            assertThat(row(new OspRk45MultiStep(1e-9), step).error()).isLessThan(1e-6);
            assertThat(row(new OspCashKarp45(1e-9), step).error()).isLessThan(1e-6);
        }
    }

    @Test
    void theTable() {
        List<Integrator> all =
                List.of(
                        new Rk4(),
                        new OspRk4(),
                        new OspButcher5(),
                        new OspFehlberg8(),
                        new OspRk45MultiStep(1e-9),
                        new OspCashKarp45(1e-9));
        StringBuilder table = new StringBuilder();
        all.forEach(integrator -> row(integrator, 0.0002));
        for (Integrator integrator : all) {
            Row coarse = row(integrator, 0.2);
            Row fine = row(integrator, 0.1);
            Row timed = row(integrator, 0.0005);
            table.append(
                    String.format(
                            Locale.ROOT,
                            "| `%s` | %.1e | %.1e | %.1f | %.1f |%n",
                            integrator,
                            coarse.error(),
                            fine.error(),
                            fine.evaluations(),
                            timed.microseconds()));
            assertThat(fine.error()).isLessThan(2e-4);
        }
        System.out.print(table);
    }
}
