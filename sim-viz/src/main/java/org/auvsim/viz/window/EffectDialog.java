package org.auvsim.viz.window;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTreeReader;
import org.auvsim.viz.scene.SeenObject;

import java.awt.BorderLayout;
import java.awt.Font;
import java.awt.Window;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.WindowConstants;

/** Adds an effect to an object, as a scenario states it. */
final class EffectDialog {
    private final Desk desk;
    private final Window window;

    EffectDialog(Desk desk, Window window) {
        this.desk = desk;
        this.window = window;
    }

    void open(long id) {
        String name = desk.scene().object(id).map(SeenObject::name).orElse("#" + id);
        JDialog dialog = new JDialog(window, "Add an effect to " + name);
        dialog.setName("effect-dialog");
        dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        JTextArea text = new JTextArea("<gravity acceleration=\"9.81\"/>", 6, 48);
        text.setName("effect-text");
        text.setFont(new Font(Font.MONOSPACED, Font.PLAIN, text.getFont().getSize()));
        JLabel words = new JLabel(" ");
        words.setName("effect-words");
        JButton add = new JButton("Add");
        add.setName("effect-add");
        add.addActionListener(
                e -> {
                    words.setText("Sent.");
                    add(id, text.getText(), words::setText);
                });
        JPanel below = new JPanel(new BorderLayout(8, 0));
        below.add(words);
        JPanel buttons = new JPanel();
        buttons.setLayout(new BoxLayout(buttons, BoxLayout.X_AXIS));
        buttons.add(add);
        buttons.add(Box.createHorizontalStrut(4));
        buttons.add(Closing.of(dialog));
        below.add(buttons, BorderLayout.EAST);
        JPanel all = new JPanel(new BorderLayout(0, 6));
        all.setBorder(BorderFactory.createEmptyBorder(12, 12, 12, 12));
        all.add(new JLabel("The effect's element, as in a scenario:"), BorderLayout.NORTH);
        all.add(new JScrollPane(text));
        all.add(below, BorderLayout.SOUTH);
        dialog.add(all);
        dialog.pack();
        dialog.setLocationRelativeTo(window);
        dialog.setVisible(true);
    }

    /** Sends an effect; says what is wrong with its text, or what has become of it. */
    void add(long id, String effect, Consumer<String> words) {
        String command =
                "<auvsml><add-effect-command world-object-id=\"%d\">%s</add-effect-command></auvsml>"
                        .formatted(id, effect);
        try {
            MessageCatalogue.load(ContextClasses.loader())
                    .decode(
                            new XmlTreeReader(Limits.MESSAGE)
                                    .read(command.getBytes(StandardCharsets.UTF_8)))
                    .forEach(
                            message ->
                                    desk.ask(
                                            message,
                                            answer -> words.accept("Added."),
                                            failure -> words.accept(Desk.sentence(failure))));
        } catch (AuvsmlException e) {
            words.accept(e.fault().problem());
        }
    }
}
