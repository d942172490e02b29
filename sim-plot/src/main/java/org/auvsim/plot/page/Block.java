package org.auvsim.plot.page;

import java.util.List;

/** A part of a section. */
public sealed interface Block {
    /** Plain sentences. */
    record Text(String sentences) implements Block {}

    /**
     * Rows below a header; columns of numbers are right-aligned.
     *
     * @param reading what the figures say, in a sentence; may be empty
     */
    record Table(List<String> header, List<List<String>> rows, String reading) implements Block {
        /**
         * A checked table.
         *
         * @throws IllegalArgumentException if a row is not as long as the header
         */
        public Table {
            header = List.copyOf(header);
            rows = rows.stream().map(List::copyOf).toList();
            for (List<String> row : rows) {
                if (row.size() != header.size()) {
                    throw new IllegalArgumentException(
                            "a row of %d cells does not fit a header of %d: %s"
                                    .formatted(row.size(), header.size(), row));
                }
            }
        }

        /** Whether most cells of a column begin with a letter. */
        boolean isOfWords(int column) {
            List<String> cells =
                    rows.stream().map(row -> row.get(column)).filter(c -> !c.isEmpty()).toList();
            long words = cells.stream().filter(c -> Character.isLetter(c.charAt(0))).count();
            return 2 * words > cells.size();
        }
    }

    /**
     * Curves over two axes.
     *
     * @param axes how their scales are divided
     * @param x what the axis across shows, with its unit
     * @param y what the axis up shows, with its unit
     * @param alsoUp what the axis up shows besides the curves, so that charts beside each other may
     *     have one scale; may be empty
     * @param reading what the curves say, in a sentence; may be empty
     */
    record Chart(
            String title,
            String x,
            String y,
            Axes axes,
            List<Double> alsoUp,
            List<Curve> curves,
            String reading)
            implements Block {
        /** How the scales of the axes are divided. */
        public enum Axes {
            /** Evenly, each as it suits. */
            EVEN,
            /** Evenly and alike: a unit is as long across as it is up. */
            MAP,
            /** Each by powers of ten, so that what is not above 0 has no point. */
            LOGARITHMIC
        }

        /** A chart whose curves stay as they are. */
        public Chart {
            alsoUp = List.copyOf(alsoUp);
            curves = List.copyOf(curves);
        }

        /** One whose axes have scales of their own. */
        public Chart(String title, String x, String y, List<Curve> curves, String reading) {
            this(title, x, y, Axes.EVEN, List.of(), curves, reading);
        }

        /** One of two lengths, as long across as they are up. */
        public static Chart map(
                String title, String x, String y, List<Curve> curves, String reading) {
            return new Chart(title, x, y, Axes.MAP, List.of(), curves, reading);
        }

        /** One of what grows by factors: by powers of ten, across and up. */
        public static Chart logarithmic(
                String title, String x, String y, List<Curve> curves, String reading) {
            return new Chart(title, x, y, Axes.LOGARITHMIC, List.of(), curves, reading);
        }

        /** The same with other curves. */
        Chart with(List<Curve> others) {
            return new Chart(title, x, y, axes, alsoUp, others, reading);
        }

        /** The same, its axis up at least as long as to show these values, too. */
        public Chart showing(List<Double> values) {
            return new Chart(title, x, y, axes, values, curves, reading);
        }
    }
}
