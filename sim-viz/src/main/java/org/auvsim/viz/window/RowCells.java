package org.auvsim.viz.window;

import java.awt.Component;
import java.awt.Font;

import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JTable;
import javax.swing.UIManager;
import javax.swing.table.DefaultTableCellRenderer;

/** The names of the tree of objects: indented, with a handle where there is something below. */
final class RowCells extends DefaultTableCellRenderer {
    private static final long serialVersionUID = 1L;

    /** Each step into the tree is so wide (pixels). */
    private static final int STEP = 12;

    private final ObjectRows rows;

    RowCells(ObjectRows rows) {
        this.rows = rows;
    }

    /** Whether a place from the cell's left is on a row's handle. */
    static boolean isHandle(Row row, int x) {
        int left = row.depth() * STEP;
        return row.isBranch() && x >= left && x < left + handle(true).getIconWidth() + STEP / 2;
    }

    private static Icon handle(boolean isOpen) {
        return UIManager.getIcon(isOpen ? "Tree.expandedIcon" : "Tree.collapsedIcon");
    }

    @Override
    public Component getTableCellRendererComponent(
            JTable table, Object value, boolean is, boolean has, int at, int column) {
        super.getTableCellRendererComponent(table, value, is, false, at, column);
        Row row = rows.row(at);
        int left = row.depth() * STEP;
        setIcon(row.isBranch() ? handle(rows.outline().isOpen(row)) : null);
        setBorder(
                BorderFactory.createEmptyBorder(
                        0, row.isBranch() ? left : left + handle(true).getIconWidth() + 4, 0, 0));
        setFont(table.getFont().deriveFont(row instanceof Row.Group ? Font.BOLD : Font.PLAIN));
        setToolTipText(row.words());
        return this;
    }
}
