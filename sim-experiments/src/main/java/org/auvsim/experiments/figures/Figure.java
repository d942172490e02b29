package org.auvsim.experiments.figures;

import org.auvsim.auvsml.xml.XmlText;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;

/**
 * Lines over two axes, as SVG: the same bytes on every machine, as no fonts are measured.
 *
 * @param name of its file, without the ending
 */
record Figure(String name, String title, String x, String y, List<Series> series) {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 300;
    private static final int LEFT = 70;
    private static final int RIGHT = 20;
    private static final int TOP = 34;
    private static final int BOTTOM = 46;
    private static final String[] COLOURS = {"#d1495b", "#00798c", "#edae49", "#30323d"};
    private static final int LEGEND_LINE = 16;

    Figure {
        series = List.copyOf(series);
    }

    /** The picture. */
    String svg() {
        XmlText out = XmlText.indented();
        open(out, "svg", "xmlns", "http://www.w3.org/2000/svg");
        out.attribute("viewBox", "0 0 %d %d".formatted(WIDTH, HEIGHT));
        out.attribute("width", String.valueOf(WIDTH));
        out.attribute("height", String.valueOf(HEIGHT));
        out.attribute("font-family", "sans-serif");
        out.attribute("font-size", "12");
        open(out, "rect", "width", "100%");
        out.attribute("height", "100%");
        out.attribute("fill", "white");
        out.close("rect");
        Axis across = axis(x, Series.Point::x, LEFT, WIDTH - RIGHT);
        Axis up = axis(y, Series.Point::y, HEIGHT - BOTTOM, TOP);
        text(out, LEFT, 20, "start", title);
        grid(out, across, up);
        for (int k = 0; k < series.size(); k++) {
            line(out, series.get(k), COLOURS[k], across, up);
            legend(out, k);
        }
        out.close("svg");
        return out + "\n";
    }

    private Axis axis(String label, ToDoubleFunction<Series.Point> of, double begin, double end) {
        return Axis.of(
                label,
                series.stream().flatMap(s -> s.points().stream()).mapToDouble(of),
                begin,
                end);
    }

    private static void grid(XmlText out, Axis across, Axis up) {
        for (double tick : across.ticks()) {
            double at = across.place(tick);
            stroke(out, at, up.begin(), at, up.end());
            text(out, at, up.begin() + 16, "middle", across.text(tick));
        }
        for (double tick : up.ticks()) {
            double at = up.place(tick);
            stroke(out, across.begin(), at, across.end(), at);
            text(out, across.begin() - 6, at + 4, "end", up.text(tick));
        }
        text(out, across.end(), HEIGHT - 10, "end", across.label());
        String sideways = "translate(16,%d) rotate(-90)".formatted((TOP + HEIGHT - BOTTOM) / 2);
        label(out, sideways, "middle", "black", up.label());
    }

    private static void stroke(XmlText out, double x1, double y1, double x2, double y2) {
        open(out, "line", "x1", pixels(x1));
        out.attribute("y1", pixels(y1));
        out.attribute("x2", pixels(x2));
        out.attribute("y2", pixels(y2));
        out.attribute("stroke", "#dddddd");
        out.close("line");
    }

    private static void text(XmlText out, double x, double y, String anchor, String words) {
        label(out, "translate(%s,%s)".formatted(pixels(x), pixels(y)), anchor, "black", words);
    }

    private static void label(
            XmlText out, String transform, String anchor, String colour, String words) {
        open(out, "g", "transform", transform);
        out.attribute("text-anchor", anchor);
        out.attribute("fill", colour);
        out.element("text", words);
        out.close("g");
    }

    private static void line(XmlText out, Series series, String colour, Axis across, Axis up) {
        StringBuilder points = new StringBuilder();
        for (Series.Point point : series.points()) {
            points.append(points.isEmpty() ? "" : " ")
                    .append(pixels(across.place(point.x())))
                    .append(',')
                    .append(pixels(up.place(point.y())));
        }
        open(out, "polyline", "points", points.toString());
        out.attribute("fill", "none");
        out.attribute("stroke", colour);
        out.attribute("stroke-width", "2");
        out.close("polyline");
    }

    private void legend(XmlText out, int k) {
        if (series.size() > 1) {
            String at =
                    "translate(%d,%d)".formatted(WIDTH - RIGHT - 6, TOP + LEGEND_LINE * (k + 1));
            label(out, at, "end", COLOURS[k], series.get(k).name());
        }
    }

    private static void open(XmlText out, String element, String attribute, String value) {
        out.open(element);
        out.attribute(attribute, value);
    }

    private static String pixels(double value) {
        return String.format(Locale.ROOT, "%.1f", value + 0.0);
    }
}
