package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class AudienceTest {
    @Test
    void tellsOfOneObjectAsOfOne() {
        assertThat(Audience.projectedWords(201))
                .isEqualTo("There are 201 objects: their projected states are left out");
        assertThat(Audience.projectedWords(200))
                .isEqualTo("There are 200 objects: their projected states are shown again");
        assertThat(Audience.projectedWords(1))
                .isEqualTo("There is 1 object: its projected state is shown again");
    }
}
