package org.auvsim.diagnosis.result;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;

import java.util.OptionalDouble;

/**
 * What is known of a misfit that no cause explains.
 *
 * @param channel where it shows most
 * @param axis along or about which it shows most
 * @param run in which it is largest
 * @param time at which it is largest (s)
 * @param place where the best set of causes has the body then: world axes (m)
 * @param frequency that stands out in it (Hz)
 * @param share of the squared misfit that the best set of causes takes away, 0 to 1
 */
public record Discrepancy(
        Channel channel,
        Axis axis,
        String run,
        double time,
        Vec3 place,
        OptionalDouble frequency,
        double share) {}
