package org.auvsim.junit;

import org.auvsim.plot.Course;
import org.auvsim.plot.CoursePlot;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A finding to look at: the body's path, those that it is about, and the place marked. */
final class Picture {
    private Picture() {}

    /** Keeps the picture; says where it is, or why there is none. */
    static String of(Trajectory body, Finding finding) {
        try {
            return "picture: "
                    + body.replay()
                            .evidence()
                            .keep(fileName(body, finding), plot(body, finding).png());
        } catch (IOException | RuntimeException | LinkageError e) {
            // Java without fonts or graphics; what was found matters more.
            return "no picture could be made: " + e;
        }
    }

    private static String fileName(Trajectory body, Finding finding) {
        String words = "%s %s".formatted(body.name(), finding.verb());
        return words.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-").replaceAll("^-|-$", "")
                + ".png";
    }

    private static CoursePlot plot(Trajectory body, Finding finding) {
        List<Course> courses = new ArrayList<>();
        body.recorded().ifPresent(poses -> courses.add(recorded(body.name(), poses)));
        finding.beside().forEach(other -> courses.add(course(other)));
        courses.add(course(body));
        return new CoursePlot(
                courses, List.of(new CoursePlot.Mark(finding.verb(), point(finding.at()))));
    }

    private static Course course(Trajectory trajectory) {
        Course course = new Course(trajectory.name());
        trajectory.samples().forEach(sample -> course.add(point(sample)));
        return course;
    }

    private static Course recorded(String name, List<Pose> poses) {
        Course course = new Course(name + ", recorded");
        for (Pose pose : poses) {
            course.add(new Course.Sample(pose.time(), pose.position(), Double.NaN));
        }
        return course;
    }

    private static Course.Sample point(Sample sample) {
        return new Course.Sample(sample.time(), sample.position(), sample.velocity().norm());
    }
}
