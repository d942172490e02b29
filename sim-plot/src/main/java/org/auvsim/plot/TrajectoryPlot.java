package org.auvsim.plot;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Where the objects of a world go, from the time on at which it is made: paths, heights, speeds.
 */
public final class TrajectoryPlot implements WorldListener {
    private static final int MOST_OBJECTS = 10;

    private final World world;
    private final Map<Long, Course> courses = new LinkedHashMap<>();

    /** Watches what moves in a world; of many objects the first ten. */
    public TrajectoryPlot(World world) {
        this.world = world;
        look();
    }

    @Override
    public void happened(WorldEvent event) {
        if (event instanceof WorldEvent.StepAdvanced) {
            look();
        }
    }

    private void look() {
        for (WorldObject object : world.objects()) {
            if (!object.isFixed()
                    && (courses.size() < MOST_OBJECTS || courses.containsKey(object.id()))) {
                courses.computeIfAbsent(object.id(), _ -> new Course(object.name()))
                        .add(
                                new Course.Sample(
                                        world.time(), object.position(), object.velocity().norm()));
            }
        }
    }

    /** The picture of what has been seen so far. */
    public byte[] png() throws IOException {
        return new CoursePlot(courses.values(), List.of()).png();
    }
}
