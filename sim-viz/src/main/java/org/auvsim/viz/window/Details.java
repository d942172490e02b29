package org.auvsim.viz.window;

import org.auvsim.core.entity.NamedForce;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.SeenObject;

import java.awt.Component;
import java.awt.Font;
import java.util.List;
import java.util.Optional;

import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;

/** The panel that tells about the selected object. */
final class Details {
    private static final DetailLines.Line NOBODY =
            new DetailLines.Line("Nothing selected", "Select in list or picture", false);

    private final Desk desk;
    private final Rows rows = new Rows();
    private final JTable table = new JTable(rows);
    private final JScrollPane pane = new JScrollPane(table);

    Details(Desk desk) {
        this.desk = desk;
        table.setName("details");
        table.setTableHeader(null);
        table.setFocusable(false);
        table.setRowSelectionAllowed(false);
        table.setDefaultRenderer(Object.class, new Words());
        table.getColumnModel().getColumn(0).setPreferredWidth(144);
        table.getColumnModel().getColumn(1).setPreferredWidth(170);
        table.setFillsViewportHeight(true);
        desk.onRefresh(this::refresh);
    }

    JScrollPane component() {
        return pane;
    }

    private void refresh() {
        if (pane.isShowing()) {
            rows.show(lines());
        }
    }

    private List<DetailLines.Line> lines() {
        Optional<SeenObject> object = desk.selected();
        Optional<Movement> motion = object.flatMap(o -> desk.scene().motion(o.id()));
        if (object.isEmpty() || motion.isEmpty()) {
            return List.of(NOBODY);
        }
        List<NamedForce> forces =
                desk.scene().lookAt(object.get().id(), ActorView::forces).orElse(List.of());
        return DetailLines.of(object.get(), motion.get(), forces);
    }

    private static final class Rows extends AbstractTableModel {
        private static final long serialVersionUID = 1L;
        private transient List<DetailLines.Line> lines = List.of(NOBODY);

        void show(List<DetailLines.Line> others) {
            if (others.equals(lines)) {
                return;
            }
            boolean isAsLong = others.size() == lines.size();
            lines = others;
            if (isAsLong) {
                fireTableRowsUpdated(0, lines.size() - 1);
            } else {
                fireTableDataChanged();
            }
        }

        @Override
        public int getRowCount() {
            return lines.size();
        }

        @Override
        public int getColumnCount() {
            return 2;
        }

        @Override
        public Object getValueAt(int row, int column) {
            DetailLines.Line line = lines.get(row);
            return column == 0 ? line.name() : line.value();
        }
    }

    private final class Words extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getTableCellRendererComponent(
                JTable of, Object value, boolean is, boolean has, int row, int column) {
            super.getTableCellRendererComponent(of, value, false, false, row, column);
            if (rows.lines.get(row).isHeading()) {
                setFont(getFont().deriveFont(Font.BOLD));
            }
            setToolTipText(value.toString().isBlank() ? null : value.toString());
            return this;
        }
    }
}
