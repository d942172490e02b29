package org.auvsim.experiments.distributed;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.core.behavior.GoToPoint;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.experiments.live.Robot;

import java.util.List;

/** A client that drives an object by the law that {@link GoToPoint} states, from far away. */
final class Driver implements Robot {
    private final long objectId;
    private final Vec3 start;
    private final GoToPoint law;
    private boolean isPushing;

    Driver(long objectId, Vec3 start, GoToPoint law) {
        this.objectId = objectId;
        this.start = start;
        this.law = law;
    }

    @Override
    public List<Message> begin() {
        return steering(start);
    }

    @Override
    public List<Message> answer(double time, Vec3 simulated) {
        return steering(simulated);
    }

    private List<Message> steering(Vec3 position) {
        Vec3 way = law.target().minus(position);
        double distance = way.norm();
        if (distance > law.radius()) {
            isPushing = true;
            Vec3 push = way.times(law.force() / distance);
            return List.of(new ApplyDirectForceCommand(objectId, law.name(), Frame.WORLD, push));
        }
        boolean wasPushing = isPushing;
        isPushing = false;
        return wasPushing ? List.of(new RemoveForceCommand(objectId, law.name())) : List.of();
    }
}
