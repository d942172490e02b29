package org.auvsim.viz.source;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.entity.WorldObjectDescriptionResponse;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** Says once of each object what of it this viewer does not know and so cannot show. */
final class Strangers {
    private final Scene scene;
    private final Set<String> told = ConcurrentHashMap.newKeySet();

    Strangers(Scene scene) {
        this.scene = scene;
    }

    /** Reads what is left out of a description. */
    void hear(Letter letter) {
        if (letter.unknown().isEmpty()) {
            return;
        }
        for (Message message : letter.messages()) {
            if (message instanceof WorldObjectDescriptionResponse description) {
                tell(
                        description.worldObject().name(),
                        "has %s, which this viewer does not know and does not show"
                                .formatted(letter.unknownWords()));
            }
        }
    }

    /** Says what is to be said of an object; nothing if it was said before. */
    void tell(String object, String words) {
        String sentence =
                "%s %s: start it with the simulator's --extensions.".formatted(object, words);
        if (told.add(sentence)) {
            scene.tell(new Occurrence(scene.time(), sentence));
        }
    }
}
