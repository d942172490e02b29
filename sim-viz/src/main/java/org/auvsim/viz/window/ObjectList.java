package org.auvsim.viz.window;

import com.formdev.flatlaf.FlatClientProperties;

import org.auvsim.viz.scene.SeenObject;

import java.awt.BorderLayout;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.OptionalLong;

import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.event.ListSelectionEvent;
import javax.swing.table.DefaultTableCellRenderer;

/** The tree of all objects, with a filter. */
final class ObjectList {
    private final Desk desk;
    private final ObjectRows rows;
    private final JTable table;
    private final JTextField filter = new JTextField();
    private final JLabel nothing = new JLabel("Nothing matches.");
    private final JPanel panel = new JPanel(new BorderLayout(0, 4));
    private OptionalLong shown = OptionalLong.empty();

    /** The row that mouse or keyboard were on last, which need not be an object's. */
    private Optional<Row> current = Optional.empty();

    private boolean isUpdating;

    ObjectList(Desk desk) {
        this.desk = desk;
        rows = new ObjectRows(desk.scene(), desk.camera());
        table = new JTable(rows);
        table.setName("objects");
        filter.setName("filter");
        arrangeTable();
        filter.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, "Filter by name or id");
        filter.putClientProperty(FlatClientProperties.TEXT_FIELD_SHOW_CLEAR_BUTTON, true);
        filter.getDocument().addDocumentListener(Typing.calls(this::filter));
        panel.setBorder(BorderFactory.createEmptyBorder(6, 6, 6, 0));
        nothing.setName("nothing");
        nothing.setVisible(false);
        JPanel top = new JPanel(new BorderLayout(0, 4));
        top.add(filter, BorderLayout.CENTER);
        top.add(nothing, BorderLayout.SOUTH);
        panel.add(top, BorderLayout.NORTH);
        panel.add(new JScrollPane(table), BorderLayout.CENTER);
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    private void arrangeTable() {
        RowOrder order = new RowOrder(rows);
        order.addRowSorterListener(e -> restore());
        table.setRowSorter(order);
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.setFillsViewportHeight(true);
        int[] widths = {144, 36, 48, 62};
        DefaultTableCellRenderer toTheRight = new DefaultTableCellRenderer();
        toTheRight.setHorizontalAlignment(SwingConstants.RIGHT);
        for (int column = 0; column < widths.length; column++) {
            table.getColumnModel().getColumn(column).setPreferredWidth(widths[column]);
            table.getColumnModel()
                    .getColumn(column)
                    .setCellRenderer(column == ObjectRows.NAME ? new RowCells(rows) : toTheRight);
        }
        table.getSelectionModel().addListSelectionListener(this::selected);
        fold("LEFT", false);
        fold("RIGHT", true);
        table.addMouseListener(
                new MouseAdapter() {
                    @Override
                    public void mouseClicked(MouseEvent e) {
                        clicked(e);
                    }
                });
    }

    private void fold(String key, boolean on) {
        table.getInputMap().put(KeyStroke.getKeyStroke(key), key);
        table.getActionMap()
                .put(
                        key,
                        new AbstractAction() {
                            private static final long serialVersionUID = 1L;

                            @Override
                            public void actionPerformed(ActionEvent e) {
                                if (table.getSelectedRow() >= 0) {
                                    open(table.getSelectedRow(), on);
                                }
                            }
                        });
    }

    private void clicked(MouseEvent e) {
        int at = table.rowAtPoint(e.getPoint());
        if (at < 0) {
            return;
        }
        Row row = rows.row(at);
        boolean isTwice = e.getClickCount() == 2;
        boolean isHandle =
                table.columnAtPoint(e.getPoint()) == ObjectRows.NAME
                        && RowCells.isHandle(row, e.getX() - table.getCellRect(at, 0, false).x);
        if (isHandle || (isTwice && row instanceof Row.Group)) {
            open(at, !rows.outline().isOpen(row));
        } else if (isTwice) {
            rows.idOf(at).ifPresent(desk::toggleFollow);
        }
    }

    private void open(int at, boolean on) {
        rows.outline().open(rows.row(at), on);
        rebuild();
    }

    private void selected(ListSelectionEvent e) {
        int at = table.getSelectedRow();
        if (isUpdating || at < 0) {
            return;
        }
        current = Optional.of(rows.row(at));
        OptionalLong id = rows.idOf(at);
        if (id.isPresent() && !e.getValueIsAdjusting()) {
            shown = id;
            desk.select(id);
        }
    }

    private void filter() {
        rows.outline().filter(filter.getText());
        rebuild();
        scroll();
    }

    private void rebuild() {
        isUpdating = true;
        rows.build();
        isUpdating = false;
        restore();
    }

    private void refresh() {
        isUpdating = true;
        boolean isOther = rows.update();
        isUpdating = false;
        OptionalLong id = desk.options().selected();
        if (!id.equals(shown)) {
            shown = id;
            show(desk.selected());
        } else if (isOther) {
            restore();
        }
        table.repaint();
    }

    /** Goes to what has been selected elsewhere. */
    private void show(Optional<SeenObject> object) {
        current = object.map(Row.Item::new);
        if (object.map(rows.outline()::reveal).orElse(false)) {
            rebuild();
        } else {
            restore();
        }
        scroll();
    }

    /**
     * Rows that were read again are selected as they were; the list stays where it was scrolled.
     */
    private void restore() {
        nothing.setVisible(rows.getRowCount() == 0 && !filter.getText().isBlank());
        int same = current.map(rows::indexOf).orElse(-1);
        int at = same < 0 && shown.isPresent() ? rows.rowOf(shown.getAsLong()) : same;
        isUpdating = true;
        if (at < 0) {
            table.clearSelection();
        } else {
            table.setRowSelectionInterval(at, at);
        }
        isUpdating = false;
    }

    private void scroll() {
        int at = table.getSelectedRow();
        if (at >= 0) {
            table.scrollRectToVisible(table.getCellRect(at, 0, true));
        }
    }
}
