package org.auvsim.diagnosis.model;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Current;
import org.auvsim.core.math.Vec3;

/** A current that one body alone feels. */
record CurrentOfOne(long id, String name, Current current, int slot) implements Current {
    @Override
    public boolean isUneven() {
        return current.isUneven();
    }

    @Override
    public double elevation(double x, double y, double time) {
        return current.elevation(x, y, time);
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        return current.valueAt(position, time);
    }

    @Override
    public Vec3 feltBy(int body, Vec3 position, double time) {
        return body == slot ? valueAt(position, time) : Vec3.ZERO;
    }

    @Override
    public void addTo(Block block) {
        int i = block.indexOf(slot);
        if (i >= 0) {
            current.addTo(block, i);
        }
    }
}
