package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.Screen;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.auvsim.viz.source.Source;
import org.auvsim.viz.source.Steering;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;

import javax.swing.SwingUtilities;

/** What the parts of one window share. Of the Swing thread alone. */
final class Desk {
    private final Source source;
    private final OrbitCamera camera;
    private final Screen screen;
    private final ViewOptions options;
    private final Folder folder = new Folder();
    private final Outbox outbox = new Outbox(this::ask);
    private final List<Runnable> refreshers = new ArrayList<>();
    private final List<Consumer<Occurrence>> listeners = new ArrayList<>();
    private Optional<String> refusal = Optional.empty();
    private boolean isDriving;

    Desk(Source source, OrbitCamera camera, Screen screen, ViewOptions options) {
        this.source = source;
        this.camera = camera;
        this.screen = screen;
        this.options = options;
        onRefresh(new NewWorld(source.scene(), options, camera)::refresh);
        onRefresh(new Choice(source.scene(), options::selected, options::select)::refresh);
        onRefresh(new Choice(source.scene(), options::followed, options::follow)::refresh);
    }

    Source source() {
        return source;
    }

    Scene scene() {
        return source.scene();
    }

    OrbitCamera camera() {
        return camera;
    }

    Screen screen() {
        return screen;
    }

    ViewOptions options() {
        return options;
    }

    /** Where files are chosen. */
    Folder folder() {
        return folder;
    }

    Outbox outbox() {
        return outbox;
    }

    /** Whether keys and gamepad drive the selected object. */
    boolean isDriving() {
        return isDriving;
    }

    void drive(boolean on) {
        isDriving = on;
        refresh();
    }

    /** Calls this whenever what is seen may have changed. */
    void onRefresh(Runnable refresher) {
        refreshers.add(refresher);
    }

    void refresh() {
        List.copyOf(refreshers).forEach(Runnable::run);
    }

    /** Tells this what people are to read. */
    void onWords(Consumer<Occurrence> listener) {
        listeners.add(listener);
    }

    /** Lets people read a sentence. */
    void say(String sentence) {
        tell(new Occurrence(scene().time(), sentence));
    }

    void tell(Occurrence occurrence) {
        listeners.forEach(listener -> listener.accept(occurrence));
    }

    Optional<SeenObject> selected() {
        OptionalLong id = options.selected();
        return id.isPresent() ? scene().object(id.getAsLong()) : Optional.empty();
    }

    void select(OptionalLong id) {
        options.select(id);
        refresh();
    }

    /** Goes along with an object, or stays if it is that one already. */
    void toggleFollow(long id) {
        boolean isFollowed = options.followed().equals(OptionalLong.of(id));
        options.follow(isFollowed ? OptionalLong.empty() : OptionalLong.of(id));
        refresh();
    }

    /** Whether there is a simulator, and no connection to it now. */
    boolean isLost() {
        return !source.steering().map(Steering::isConnected).orElse(true);
    }

    /** Whether there is a simulator, and it lets this role's orders through. */
    boolean may(Role needed) {
        return source.steering().map(s -> s.isConnected() && s.role().allows(needed)).orElse(false);
    }

    /** Why something of this role cannot be done; empty if it can. */
    Optional<String> hindrance(Role needed) {
        Optional<Steering> steering = source.steering();
        if (steering.isEmpty()) {
            return Optional.of("A recording cannot be changed; this needs a simulator.");
        }
        if (!steering.get().isConnected()) {
            return Optional.of("There is no connection to the simulator.");
        }
        return steering.get().role().allows(needed)
                ? Optional.empty()
                : Optional.of(
                        "This needs the role '%s'; this viewer has the role '%s'."
                                .formatted(needed.roleName(), steering.get().role().roleName()));
    }

    /** The same for what is done with the selected object. */
    Optional<String> hindranceAtSelected(Role needed) {
        return hindrance(needed)
                .or(
                        () ->
                                options.selected().isPresent()
                                        ? Optional.empty()
                                        : Optional.of(
                                                "Nothing is selected; select an object first."));
    }

    /** Who controls the selected object. */
    Optional<Holder> holder() {
        OptionalLong id = options.selected();
        return id.isPresent()
                ? source.steering().flatMap(s -> Holder.of(id.getAsLong(), s))
                : Optional.empty();
    }

    /** Whether the simulator has told who is there, and so who controls what. */
    boolean knowsHolders() {
        return source.steering().filter(s -> s.isConnected() && !s.clients().isEmpty()).isPresent();
    }

    /** Who controls the selected object, or that nobody does; once that is known. */
    String holderWords() {
        return holder().map(Holder::words)
                .orElse(
                        knowsHolders()
                                ? "Nobody controls it."
                                : "Who controls it is not known yet.");
    }

    /** The same for what only who controls the selected object does, or could. */
    Optional<String> hindranceAtControlled(Role needed) {
        return hindranceAtSelected(needed)
                .or(() -> holder().filter(holder -> !holder.isUs()).map(Holder::words));
    }

    /** Why the selected object cannot be taken: also that this viewer controls it. */
    Optional<String> hindranceAtTaking() {
        return hindranceAtSelected(Role.CONTROLLER).or(() -> holder().map(Holder::words));
    }

    /** Why the selected object cannot be let go: that this viewer is not known to control it. */
    Optional<String> hindranceAtRelease() {
        return hindranceAtControlled(Role.CONTROLLER)
                .or(() -> holder().isPresent() ? Optional.empty() : Optional.of(holderWords()));
    }

    /** Asks the simulator; a refusal is told. */
    void ask(Message message) {
        ask(message, answer -> {});
    }

    /** Asks the simulator, and goes on with its answer; a refusal is told. */
    void ask(Message message, Consumer<Message> then) {
        ask(message, then, failure -> {});
    }

    /** Asks the simulator, and goes on with its answer or its refusal, which is told. */
    void ask(Message message, Consumer<Message> then, Consumer<Throwable> refused) {
        if (source.steering().isEmpty()) {
            say("A recording cannot be changed; this needs a simulator.");
            return;
        }
        var _ =
                source.steering()
                        .get()
                        .ask(message)
                        .whenComplete(
                                (answer, failure) ->
                                        SwingUtilities.invokeLater(
                                                () -> settle(answer, failure, then, refused)));
    }

    /** Asks the simulator for what nobody is told of: neither its answer nor its refusal. */
    void askQuietly(Message message) {
        source.steering()
                .ifPresent(
                        steering -> {
                            var _ = steering.ask(message);
                        });
    }

    private void settle(
            Message answer,
            @Nullable Throwable failure,
            Consumer<Message> then,
            Consumer<Throwable> refused) {
        if (failure == null) {
            refusal = Optional.empty();
            then.accept(answer);
        } else {
            refusal = Optional.of(sentence(failure));
            say(sentence(failure));
            refused.accept(bare(failure));
        }
    }

    /** The last refusal, until something succeeds. */
    Optional<String> refusal() {
        return refusal;
    }

    /** What a failure says to people. */
    static String sentence(Throwable failure) {
        Throwable bare = bare(failure);
        return Optional.ofNullable(bare.getMessage()).orElse(bare.toString());
    }

    /** The failure itself: a stage after the one that failed wraps it. */
    private static Throwable bare(Throwable failure) {
        return failure instanceof CompletionException && failure.getCause() != null
                ? failure.getCause()
                : failure;
    }
}
