package org.auvsim.experiments.report;

import java.util.List;

/**
 * What came of an experiment.
 *
 * @param title of the page
 * @param summary what was found, in a sentence or two
 */
public record Report(String title, String summary, List<Section> sections) {
    /** A report whose sections stay as they are. */
    public Report {
        sections = List.copyOf(sections);
    }

    /** This report with the words that its figures come of a small run and are none to compare. */
    public Report ofQuickRun() {
        return new Report(
                title + ": a quick run",
                "This is a quick run, which shows that the experiment works; its figures are not"
                        + " those to compare with the thesis. "
                        + summary,
                sections);
    }

    /** One question, and what answers it. */
    public record Section(String heading, List<Block> blocks) {
        /** A section whose blocks stay as they are. */
        public Section {
            blocks = List.copyOf(blocks);
        }

        /** A section of these blocks. */
        public static Section of(String heading, Block... blocks) {
            return new Section(heading, List.of(blocks));
        }
    }
}
