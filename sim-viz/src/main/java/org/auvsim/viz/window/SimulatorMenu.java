package org.auvsim.viz.window;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.message.command.KeptSnapshot;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.control.ListSnapshotsRequest;
import org.auvsim.auvsml.message.control.LoadScenarioCommand;
import org.auvsim.auvsml.message.control.ResetCommand;
import org.auvsim.auvsml.message.control.RestoreSnapshotCommand;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;
import org.auvsim.auvsml.message.control.SnapshotListResponse;
import org.auvsim.auvsml.message.control.TakeSnapshotCommand;
import org.auvsim.auvsml.message.session.ClientListResponse;
import org.auvsim.auvsml.message.session.DisconnectClientCommand;
import org.auvsim.auvsml.message.session.ListClientsRequest;

import java.awt.Window;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;

import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/** What an administrator does with the simulator. */
final class SimulatorMenu {
    private final Desk desk;
    private final Window window;
    private final JMenu restore = new JMenu("Restore a snapshot");
    private final JMenu clients = new JMenu("Clients");

    SimulatorMenu(Desk desk, Window window) {
        this.desk = desk;
        this.window = window;
        restore.setName("restore-snapshot");
        clients.setName("clients");
    }

    JMenu menu(SimulatorBar bar) {
        JMenu menu = new JMenu("Simulator");
        menu.setName("menu-simulator");
        menu.setMnemonic('S');
        item(menu, "pause-item", act("Pause or go on", bar::toggle).key("SPACE"));
        item(menu, "step-item", act("Make steps", bar::step).key("PERIOD"));
        menu.addSeparator();
        item(menu, "take-snapshot", act("Take a snapshot", this::takeSnapshot).key("ctrl T"));
        menu.add(restore);
        item(menu, "reset", act("Reset...", this::reset));
        item(menu, "load-scenario", act("Load a scenario...", this::load).key("ctrl L"));
        menu.addSeparator();
        menu.add(clients);
        menu.addSeparator();
        item(menu, "shutdown", act("Shut down...", this::shutdown));
        desk.onRefresh(this::allow);
        menu.addMenuListener(
                new MenuListener() {
                    @Override
                    public void menuSelected(MenuEvent e) {
                        list();
                    }

                    @Override
                    public void menuDeselected(MenuEvent e) {}

                    @Override
                    public void menuCanceled(MenuEvent e) {}
                });
        return menu;
    }

    private Act act(String words, Runnable deed) {
        return new Act(words, deed).needs(desk, Role.ADMIN);
    }

    private static void item(JMenu menu, String name, Act act) {
        menu.add(act).setName(name);
    }

    private void allow() {
        for (JMenu list : new JMenu[] {restore, clients}) {
            list.setEnabled(desk.may(Role.ADMIN));
            list.setToolTipText(desk.hindrance(Role.ADMIN).orElse(null));
        }
    }

    /** Fills the menus of snapshots and clients. */
    void list() {
        if (desk.may(Role.ADMIN)) {
            desk.ask(
                    new ListSnapshotsRequest(),
                    answer -> {
                        if (answer instanceof SnapshotListResponse response) {
                            snapshots(response);
                        }
                    });
            desk.ask(
                    new ListClientsRequest(),
                    answer -> {
                        if (answer instanceof ClientListResponse response) {
                            clients(response);
                        }
                    });
        }
    }

    private void snapshots(SnapshotListResponse response) {
        restore.removeAll();
        response.snapshot()
                .forEach(
                        kept -> {
                            JMenuItem item =
                                    restore.add(new Act(words(kept) + "...", () -> restore(kept)));
                            item.setName("restore-" + kept.name());
                        });
        none(restore);
    }

    private static String words(KeptSnapshot kept) {
        return String.format(Locale.ROOT, "%s, of %.2f s", kept.name(), kept.time());
    }

    private void clients(ClientListResponse response) {
        clients.removeAll();
        response.client()
                .forEach(
                        client -> {
                            String words =
                                    "Disconnect %s, %s at %s%s..."
                                            .formatted(
                                                    client.name(),
                                                    client.role(),
                                                    client.peer(),
                                                    isUs(client) ? ": this viewer" : "");
                            String session = Long.toString(client.sessionId());
                            JMenuItem item =
                                    clients.add(
                                            new Act(
                                                    words,
                                                    () ->
                                                            disconnect(
                                                                    isUs(client)
                                                                            ? "this viewer"
                                                                            : client.name(),
                                                                    session)));
                            item.setName("disconnect-" + session);
                        });
        none(clients);
    }

    private boolean isUs(ListedClient client) {
        return desk.source()
                .steering()
                .filter(simulator -> simulator.session() == client.sessionId())
                .isPresent();
    }

    private static void none(JMenu menu) {
        if (menu.getItemCount() == 0) {
            menu.add("None").setEnabled(false);
        }
    }

    private void takeSnapshot() {
        String name = String.format(Locale.ROOT, "viewer at %.2f s", desk.scene().time());
        desk.ask(
                new TakeSnapshotCommand(name),
                answer -> desk.say("Snapshot '" + name + "' is kept."));
    }

    private void load() {
        Folder folder = desk.folder();
        folder.toOpen(folder.chooser("Scenarios", "xml"), window).ifPresent(this::load);
    }

    /** Reads a scenario aside and sends it, if that is meant. */
    void load(Path file) {
        var _ =
                CompletableFuture.supplyAsync(() -> read(file))
                        .whenComplete(
                                (scenario, failure) ->
                                        SwingUtilities.invokeLater(
                                                () -> {
                                                    if (failure == null) {
                                                        load(file, scenario);
                                                    } else {
                                                        desk.say(Desk.sentence(failure));
                                                        notLoaded(failure);
                                                    }
                                                }));
    }

    private static Scenario read(Path file) {
        try {
            return ScenarioLoader.load(ContextClasses.loader()).load(file);
        } catch (DocumentException e) {
            throw new CompletionException(e);
        }
    }

    private void load(Path file, Scenario scenario) {
        String question =
                "Put %s in the place of the world for all clients, and lose how it is now?"
                        .formatted(file.getFileName());
        if (Question.confirms(window, question, "Load")) {
            desk.ask(new LoadScenarioCommand(scenario), answer -> {}, this::notLoaded);
        }
    }

    /** A sentence about a scenario has a place in it and is long: the line below shows its head. */
    private void notLoaded(Throwable failure) {
        Notice.show(window, "The scenario was not loaded", Desk.sentence(failure));
    }

    private void restore(KeptSnapshot kept) {
        String question =
                "Bring the world back to %s, for all clients, and lose how it is now?"
                        .formatted(words(kept));
        if (Question.confirms(window, question, "Restore")) {
            desk.ask(new RestoreSnapshotCommand(kept.name()));
        }
    }

    private void reset() {
        String question =
                "Bring the world back to its beginning for all clients, and lose how it is now?";
        if (Question.confirms(window, question, "Reset")) {
            desk.ask(new ResetCommand());
        }
    }

    private void disconnect(String name, String session) {
        String question = "End the session of %s, and let go what it controls?".formatted(name);
        if (Question.confirms(window, question, "Disconnect")) {
            desk.ask(
                    new DisconnectClientCommand(session, "an administrator has ended the session"));
        }
    }

    private void shutdown() {
        String question =
                "Shut the simulator down for all its clients, and lose its world and snapshots?";
        if (Question.confirms(window, question, "Shut down")) {
            desk.ask(new ShutdownSimulatorCommand());
        }
    }
}
