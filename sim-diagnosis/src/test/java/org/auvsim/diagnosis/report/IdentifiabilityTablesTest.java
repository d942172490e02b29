package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.plot.page.ReportPage;
import org.junit.jupiter.api.Test;

class IdentifiabilityTablesTest {
    @Test
    void ofCausesThatAreAlikeTheNumbersAreNamed() {
        String page = ReportPage.html(Page.of(Diagnoses.explained()));

        assertThat(page.replaceAll("<[^>]*>", "|").replaceAll("\\|+", "|"))
                .containsSubsequence(
                        "|one cause|its number|another|its number|angle|",
                        "|mass_error|factor|added_mass|m.x|0.40\u00b0|",
                        "|quadratic_drag|k|linear_drag|c|11\u00b0|");
    }
}
