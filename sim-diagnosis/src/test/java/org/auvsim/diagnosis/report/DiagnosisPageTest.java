package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** What {@code docs/diagnosis.md} tells of {@code diagnosis.json} is all that its schema has. */
class DiagnosisPageTest {
    private static final Path DOCS = Path.of("../docs");

    /** Names of members at any depth. */
    private static Set<String> members(JsonNode schema) {
        Set<String> members = new TreeSet<>();
        Optional.ofNullable(schema.get("properties"))
                .filter(JsonNode::isObject)
                .ifPresent(of -> members.addAll(of.propertyNames()));
        schema.forEach(part -> members.addAll(members(part)));
        return members;
    }

    /** All that stands as code in the table's rows. */
    private static Set<String> told(String page) {
        return page.lines()
                .dropWhile(line -> !line.startsWith("| member |"))
                .takeWhile(line -> line.startsWith("|"))
                .flatMap(row -> Pattern.compile("`([a-z_]+)`").matcher(row).results())
                .map((MatchResult code) -> code.group(1))
                .collect(Collectors.toSet());
    }

    @Test
    void theTableNamesEachMemberOfTheSchema() throws IOException {
        JsonNode schema = JsonMapper.shared().readTree(DOCS.resolve("diagnosis.schema.json"));

        Set<String> members = members(schema);

        assertThat(members).contains("verdict", "log_evidence", "first_number", "before");
        assertThat(told(Files.readString(DOCS.resolve("diagnosis.md")))).containsAll(members);
    }
}
