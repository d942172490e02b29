package org.auvsim.cli.feed;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The names of the columns with time and position.
 *
 * @param z empty: the log has none, all heights are 0
 */
record LogColumns(String t, String x, String y, Optional<String> z) {
    private static final List<String> KEYS = List.of("t", "x", "y", "z");

    /**
     * From {@code t}, {@code x}, {@code y}, {@code z} to names; what is left out has its key's
     * name, but z is then only read where a column {@code z} exists.
     *
     * @throws LogException naming a key that is none of these
     */
    static LogColumns of(Map<String, String> names, List<String> header) throws LogException {
        for (String key : names.keySet()) {
            if (!KEYS.contains(key)) {
                throw new LogException(
                        "--columns gives names to t, x, y and z, but not to '%s'.".formatted(key));
            }
        }
        String z = names.getOrDefault("z", "z");
        boolean hasZ = names.containsKey("z") || header.contains(z);
        return new LogColumns(
                names.getOrDefault("t", "t"),
                names.getOrDefault("x", "x"),
                names.getOrDefault("y", "y"),
                hasZ ? Optional.of(z) : Optional.empty());
    }
}
