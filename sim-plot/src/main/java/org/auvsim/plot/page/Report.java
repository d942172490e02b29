package org.auvsim.plot.page;

import java.util.List;

/**
 * What came of an experiment or another investigation.
 *
 * @param title of the page
 * @param summary what was found, in a sentence or two
 */
public record Report(String title, String summary, List<Section> sections) {
    /** A report whose sections stay as they are. */
    public Report {
        sections = List.copyOf(sections);
    }

    /**
     * One question, and what answers it.
     *
     * @param isFolded whether the page shows its heading alone until it is opened; charts stand
     *     side by side in it where there is room
     */
    public record Section(String heading, boolean isFolded, List<Block> blocks) {
        /** A section whose blocks stay as they are. */
        public Section {
            blocks = List.copyOf(blocks);
        }

        /** One that is open. */
        public Section(String heading, List<Block> blocks) {
            this(heading, false, blocks);
        }

        /** A section of these blocks. */
        public static Section of(String heading, Block... blocks) {
            return new Section(heading, List.of(blocks));
        }
    }
}
