package org.auvsim.viz.source;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyDirectForceCommand;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.RemoveForceCommand;
import org.auvsim.auvsml.message.control.SetControlSurfaceCommand;
import org.auvsim.auvsml.message.control.SetPropulsorCommand;

/** Tells orders that end a push or a turn from all others. */
final class Stops {
    private Stops() {}

    static boolean is(Message order) {
        return switch (order) {
            case SetPropulsorCommand(_, _, double level) -> level == 0;
            case SetControlSurfaceCommand(_, _, double angle) -> angle == 0;
            case ApplyDirectForceCommand push -> push.forceVector().norm() == 0;
            case ApplyForceCommand push -> push.forceVector().norm() == 0;
            case RemoveForceCommand _ -> true;
            default -> false;
        };
    }
}
