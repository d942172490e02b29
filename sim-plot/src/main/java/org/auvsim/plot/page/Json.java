package org.auvsim.plot.page;

import org.auvsim.plot.page.Block.Chart;
import org.auvsim.plot.page.Curve.Point;

import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;

/** Charts as JSON that may stand in a script element. */
final class Json {
    private Json() {}

    static String charts(List<Chart> charts) {
        return array(charts, Json::chart);
    }

    private static String chart(Chart chart) {
        return "{\"title\":%s,\"x\":%s,\"y\":%s,\"axes\":%s,\"alsoUp\":%s,\"curves\":%s}"
                .formatted(
                        text(chart.title()),
                        text(chart.x()),
                        text(chart.y()),
                        text(chart.axes().name().toLowerCase(Locale.ROOT)),
                        array(chart.alsoUp(), Json::number),
                        array(chart.curves(), Json::curve));
    }

    private static String curve(Curve curve) {
        return "{\"name\":%s,\"mark\":%s,\"x\":%s,\"y\":%s}"
                .formatted(
                        text(curve.name()),
                        text(curve.mark().name().toLowerCase(Locale.ROOT)),
                        numbers(curve.points(), Point::x),
                        numbers(curve.points(), Point::y));
    }

    private static String numbers(List<Point> points, ToDoubleFunction<Point> of) {
        return array(points, point -> number(of.applyAsDouble(point)));
    }

    /** To seven digits, which no screen can show; what is not finite is a gap. */
    private static String number(double value) {
        return Float.isFinite((float) value) ? Float.toString((float) value) : "null";
    }

    private static <T> String array(List<T> items, Function<T, String> json) {
        return items.stream().map(json).collect(Collectors.joining(",", "[", "]"));
    }

    /** A string that ends neither itself nor the element around it. */
    static String text(String text) {
        StringBuilder out = new StringBuilder("\"");
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            if (c < ' ' || c == '"' || c == '\\' || c == '<' || c == '>' || c == '&') {
                out.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
            } else {
                out.append(c);
            }
        }
        return out.append('"').toString();
    }
}
