package org.auvsim.viz.window;

import java.util.List;

import javax.swing.RowSorter;
import javax.swing.SortOrder;

/** Orders objects within their branches when somebody clicks at a column's head. */
final class RowOrder extends RowSorter<ObjectRows> {
    private final ObjectRows rows;
    private List<SortKey> keys = List.of();

    RowOrder(ObjectRows rows) {
        this.rows = rows;
    }

    /** By a column upwards, downwards, and no more. */
    @Override
    public void toggleSortOrder(int column) {
        List<SortKey> up = List.of(new SortKey(column, SortOrder.ASCENDING));
        List<SortKey> down = List.of(new SortKey(column, SortOrder.DESCENDING));
        setSortKeys(keys.equals(up) ? down : keys.equals(down) ? List.of() : up);
    }

    @Override
    public void setSortKeys(List<? extends SortKey> others) {
        keys = List.copyOf(others);
        rows.sort(keys.stream().findFirst());
        fireSortOrderChanged();
    }

    @Override
    public List<? extends SortKey> getSortKeys() {
        return keys;
    }

    @Override
    public ObjectRows getModel() {
        return rows;
    }

    // The rows come in their order: what is seen is what the model has.

    @Override
    public int convertRowIndexToModel(int index) {
        return index;
    }

    @Override
    public int convertRowIndexToView(int index) {
        return index;
    }

    @Override
    public int getViewRowCount() {
        return rows.getRowCount();
    }

    @Override
    public int getModelRowCount() {
        return rows.getRowCount();
    }

    @Override
    public void modelStructureChanged() {}

    @Override
    public void allRowsChanged() {}

    @Override
    public void rowsInserted(int first, int last) {}

    @Override
    public void rowsDeleted(int first, int last) {}

    @Override
    public void rowsUpdated(int first, int last) {}

    @Override
    public void rowsUpdated(int first, int last, int column) {}
}
