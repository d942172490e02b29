package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.AnnounceModelCorrectionCommand;
import org.auvsim.auvsml.message.entity.AddFieldCommand;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.entity.ReviseWorldObjectCommand;
import org.auvsim.auvsml.message.learning.ModelCorrection;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;
import org.auvsim.server.simulator.Messenger;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.function.Predicate;

/** A world that does what a learner wants, but for what it refuses. */
final class ObedientWorld implements Messenger {
    private final World world;
    private final BlockingQueue<ModelCorrection> announced = new LinkedBlockingQueue<>();
    private volatile Predicate<Message> refuses = _ -> false;

    ObedientWorld(World world) {
        this.world = world;
    }

    /** From now on it refuses these. */
    void refuse(Predicate<Message> some) {
        refuses = some;
    }

    World world() {
        return world;
    }

    /** What was announced, in order; what is sent before that has been carried out then. */
    BlockingQueue<ModelCorrection> announced() {
        return announced;
    }

    @Override
    public List<Optional<ErrorResponse>> send(List<Message> messages) {
        return messages.stream().map(this::answer).toList();
    }

    private Optional<ErrorResponse> answer(Message message) {
        if (refuses.test(message)) {
            return Optional.of(error(ErrorCode.REFUSED, "not now"));
        }
        try {
            carryOut(message);
            return Optional.empty();
        } catch (WorldException e) {
            return Optional.of(error(ErrorCode.INVALID_VALUE, String.valueOf(e.getMessage())));
        }
    }

    private static ErrorResponse error(ErrorCode code, String text) {
        return new ErrorResponse(code, text, OptionalInt.empty(), OptionalInt.empty());
    }

    void carryOut(Message change) {
        switch (change) {
            case RemoveEntityCommand remove -> world.remove(remove.entityId());
            case AddFieldCommand add -> world.add(add.field());
            case ReviseWorldObjectCommand revise -> world.revise(revise.worldObject());
            case AnnounceModelCorrectionCommand announce ->
                    announced.add(announce.modelCorrection());
            default -> throw new AssertionError(change);
        }
    }
}
