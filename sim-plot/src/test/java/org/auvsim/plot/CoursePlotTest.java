package org.auvsim.plot;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;

import javax.imageio.ImageIO;

class CoursePlotTest {
    private static final int RED = 0xD1495B;

    @Test
    void markedPointsAreSeenInAllThreeCharts() throws IOException {
        Course course = course("AUV", 1);
        var mark = new CoursePlot.Mark("here", new Course.Sample(1, new Vec3(1, 0, 0), 1));

        BufferedImage plain = image(new CoursePlot(List.of(course), List.of()));
        BufferedImage marked = image(new CoursePlot(List.of(course), List.of(mark)));

        int third = marked.getHeight() / 3;
        for (int chart = 0; chart < 3; chart++) {
            assertThat(pixels(plain, RED, chart * third, third)).isZero();
            assertThat(pixels(marked, RED, chart * third, third)).isPositive();
        }
    }

    @Test
    void coursesOfOneNameAndOfUnknownSpeedAreDrawn() throws IOException {
        List<Course> twins = List.of(course("AUV", 1), course("AUV", Double.NaN));

        assertThat(image(new CoursePlot(twins, List.of())).getHeight()).isPositive();
    }

    private static Course course(String name, double speed) {
        Course course = new Course(name);
        for (int i = 0; i < 5000; i++) {
            course.add(new Course.Sample(i * 1e-3, new Vec3(i * 1e-3, 0, 0), speed));
        }
        assertThat(course.values(Course.Sample::time)).hasSizeBetween(2000, 4000).contains(0);
        return course;
    }

    private static BufferedImage image(CoursePlot plot) throws IOException {
        return ImageIO.read(new ByteArrayInputStream(plot.png()));
    }

    private static int pixels(BufferedImage image, int color, int top, int height) {
        int count = 0;
        for (int y = top; y < top + height; y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                count += (image.getRGB(x, y) & 0xFFFFFF) == color ? 1 : 0;
            }
        }
        return count;
    }
}
