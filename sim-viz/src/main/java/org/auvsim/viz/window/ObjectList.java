package org.auvsim.viz.window;

import com.formdev.flatlaf.FlatClientProperties;

import java.awt.BorderLayout;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Locale;
import java.util.OptionalLong;

import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.ListSelectionModel;
import javax.swing.RowFilter;
import javax.swing.SwingConstants;
import javax.swing.event.ListSelectionEvent;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableRowSorter;

/** The list of all objects, with a filter. */
final class ObjectList {
    private final Desk desk;
    private final ObjectRows rows;
    private final JTable table;
    private final TableRowSorter<ObjectRows> sorter;
    private final JTextField filter = new JTextField();
    private final JPanel panel = new JPanel(new BorderLayout(0, 4));
    private boolean isUpdating;

    ObjectList(Desk desk) {
        this.desk = desk;
        rows = new ObjectRows(desk.scene(), desk.camera());
        table = new JTable(rows);
        sorter = new TableRowSorter<>(rows);
        table.setName("objects");
        filter.setName("filter");
        arrangeTable();
        filter.putClientProperty(FlatClientProperties.PLACEHOLDER_TEXT, "Filter by name or id");
        filter.putClientProperty(FlatClientProperties.TEXT_FIELD_SHOW_CLEAR_BUTTON, true);
        filter.getDocument().addDocumentListener(Typing.calls(this::filter));
        panel.setBorder(BorderFactory.createEmptyBorder(6, 6, 6, 0));
        panel.add(filter, BorderLayout.NORTH);
        panel.add(new JScrollPane(table), BorderLayout.CENTER);
        desk.onRefresh(this::refresh);
    }

    JPanel component() {
        return panel;
    }

    private void arrangeTable() {
        sorter.setSortable(ObjectRows.SPEED, false);
        sorter.setSortable(ObjectRows.DISTANCE, false);
        table.setRowSorter(sorter);
        table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        table.setFillsViewportHeight(true);
        int[] widths = {128, 34, 46, 54};
        for (int column = 0; column < widths.length; column++) {
            table.getColumnModel().getColumn(column).setPreferredWidth(widths[column]);
        }
        DefaultTableCellRenderer toTheRight = new DefaultTableCellRenderer();
        toTheRight.setHorizontalAlignment(SwingConstants.RIGHT);
        table.getColumnModel().getColumn(ObjectRows.SPEED).setCellRenderer(toTheRight);
        table.getColumnModel().getColumn(ObjectRows.DISTANCE).setCellRenderer(toTheRight);
        table.getSelectionModel().addListSelectionListener(this::selected);
        table.addMouseListener(
                new MouseAdapter() {
                    @Override
                    public void mouseClicked(MouseEvent e) {
                        int row = table.rowAtPoint(e.getPoint());
                        if (e.getClickCount() == 2 && row >= 0) {
                            desk.toggleFollow(rows.object(table.convertRowIndexToModel(row)).id());
                        }
                    }
                });
    }

    private void selected(ListSelectionEvent e) {
        if (!isUpdating && !e.getValueIsAdjusting() && table.getSelectedRow() >= 0) {
            int row = table.convertRowIndexToModel(table.getSelectedRow());
            desk.select(OptionalLong.of(rows.object(row).id()));
        }
    }

    private void filter() {
        String wanted = filter.getText().strip().toLowerCase(Locale.ROOT);
        isUpdating = true;
        sorter.setRowFilter(
                new RowFilter<>() {
                    @Override
                    public boolean include(Entry<? extends ObjectRows, ? extends Integer> entry) {
                        var object = entry.getModel().object(entry.getIdentifier());
                        return object.name().toLowerCase(Locale.ROOT).contains(wanted)
                                || Long.toString(object.id()).equals(wanted);
                    }
                });
        isUpdating = false;
        refresh();
    }

    private void refresh() {
        isUpdating = true;
        rows.update();
        OptionalLong id = desk.options().selected();
        int row = id.isPresent() ? rows.rowOf(id.getAsLong()) : -1;
        int seen = row < 0 ? -1 : table.convertRowIndexToView(row);
        if (seen != table.getSelectedRow()) {
            if (seen < 0) {
                table.clearSelection();
            } else {
                table.setRowSelectionInterval(seen, seen);
                table.scrollRectToVisible(table.getCellRect(seen, 0, true));
            }
        }
        isUpdating = false;
        table.repaint();
    }
}
