package org.auvsim.diagnosis.shaking;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;

/** How hard a body's propulsors are told to push, as the model has them. */
final class ToldThrust {
    /** After so many time constants a propulsor has reached what it is told. */
    private static final double SETTLED = 40;

    private final List<Propulsor> propulsors;

    ToldThrust(WorldObjectDefinition body) {
        this.propulsors =
                body.component().stream()
                        .filter(Propulsor.class::isInstance)
                        .map(Propulsor.class::cast)
                        .toList();
    }

    /** The sum (N) of the sizes of all thrusts, by sample. */
    double[] along(MeasuredRun run) {
        double[] sums = new double[run.size()];
        for (Propulsor propulsor : propulsors) {
            List<Command> told =
                    run.commands().stream()
                            .filter(command -> command.name().equals(propulsor.name()))
                            .toList();
            double thrust = 0;
            for (int k = 0; k < sums.length; k++) {
                if (told.isEmpty() ? k == 0 : told.getFirst().changesAt(k)) {
                    double level = told.isEmpty() ? propulsor.level() : told.getFirst().level(k);
                    thrust = Math.abs(settled(propulsor, level, run.time(k)));
                }
                sums[k] += thrust;
            }
        }
        return sums;
    }

    private static double settled(Propulsor propulsor, double level, double time) {
        return propulsor.commanded(level, time).thrustAt(time + SETTLED * propulsor.lag());
    }
}
