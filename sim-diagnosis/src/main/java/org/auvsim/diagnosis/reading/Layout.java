package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.LastingError;
import org.auvsim.auvsml.run.Limit;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.core.entity.Frame;
import org.auvsim.diagnosis.run.Axes;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What each column of one file has, by its header, a mapping and what the body can be told. */
final class Layout {
    private static final double RADIANS = Math.PI / 180;

    private final CsvTable table;
    private final ColumnMapping mapping;
    private final CommandNames known;
    private final List<BoundColumn> columns = new ArrayList<>();
    private final List<String> commands = new ArrayList<>();
    private final Map<Integer, String> filled = new LinkedHashMap<>();
    private final Map<Integer, List<LastingError>> lasting = new LinkedHashMap<>();
    private final List<Ends.LimitedColumn> limited = new ArrayList<>();
    private final List<String> unknown = new ArrayList<>();
    private final Set<String> meant = new LinkedHashSet<>();

    /**
     * That of a table.
     *
     * @throws DocumentException naming the columns that are unknown, missing or stated twice
     */
    Layout(CsvTable table, ColumnMapping mapping, CommandNames known) throws DocumentException {
        this.table = table;
        this.mapping = mapping;
        this.known = known;
        requireMapped();
        for (String column : shakingColumns()) {
            requireThere(column, "the mapping reads shaking from this column");
        }
        for (int field = 0; field < table.columns().size(); field++) {
            bind(field, rule(table.columns().get(field)));
        }
        if (!unknown.isEmpty()) {
            throw unknown().refusal(unknown);
        }
        require();
    }

    private UnknownColumns unknown() {
        return new UnknownColumns(table, mapping, known, filled.keySet());
    }

    /** All columns that count; one that moves several things is there for each. */
    List<BoundColumn> columns() {
        return columns;
    }

    /** Names of what is commanded, in order of its places. */
    List<String> commands() {
        return commands;
    }

    /** The axes of a velocity: the body's, if one of those names is there. */
    Frame frame(List<String> inBody) {
        return inBody.stream().anyMatch(meant::contains) ? Frame.BODY : Frame.WORLD;
    }

    /**
     * The axes of angles: the body's, where roll or pitch is there without the other. Neither tells
     * of a turn about an axis of the world, whatever the body heads for.
     */
    Frame ofAngles() {
        boolean isQuaternion = of(Slots.QUATERNION).isPresent();
        boolean isRoll = of(Slots.ANGLES).isPresent();
        boolean isPitch = of(Slots.ANGLES + 1).isPresent();
        return !isQuaternion && isRoll != isPitch ? Frame.BODY : Frame.WORLD;
    }

    /** Errors that last, by the place of what they are of. */
    Map<Integer, List<LastingError>> lastingErrors() {
        return lasting;
    }

    /** Columns by which runs end. */
    List<Ends.LimitedColumn> limited() {
        return limited;
    }

    /** The column that has the time. */
    BoundColumn time() {
        return of(Slots.TIME).orElseThrow();
    }

    /** Whether the mapping says in which unit the time is. */
    boolean statesUnitOfTime() {
        return time().form() != CellForm.NUMBER || rule(time().name()).scale().isPresent();
    }

    /** The column that fills a place. */
    Optional<BoundColumn> of(int slot) {
        return columns.stream().filter(c -> c.slot() == slot).findFirst();
    }

    /** The names of columns by the places that they fill. */
    Map<Integer, String> filled() {
        return filled;
    }

    /** The name of the column that fills a place; some name if none does. */
    String nameOf(int slot) {
        return filled.getOrDefault(slot, "?");
    }

    private void requireMapped() throws DocumentException {
        for (MappedColumn column : mapping.column()) {
            boolean isRead = !column.ignored() && !Renames.isRename(column);
            if (isRead || column.runEnds().isPresent()) {
                requireThere(column.name(), "the mapping names this column");
            }
        }
    }

    private void requireThere(String column, String why) throws DocumentException {
        if (!table.columns().contains(column)) {
            throw table.at(
                    1,
                    column,
                    "%s, but the header has none of this name; %s"
                            .formatted(why, Renames.thatAre(column, table.columns())));
        }
    }

    /** Of an accelerometer, and of a gyro; none if nothing is asked of shaking. */
    private List<String> shakingColumns() {
        return mapping.shaking().stream()
                .flatMap(shaking -> Stream.of(shaking.acceleration(), shaking.rate()))
                .toList();
    }

    private MappedColumn rule(String column) {
        return mapping.column().stream()
                .filter(mapped -> mapped.name().equals(column))
                .findFirst()
                .orElseGet(() -> MappedColumn.usual(column));
    }

    private void bind(int field, MappedColumn rule) throws DocumentException {
        rule.runEnds().ifPresent(limit -> limited.add(limited(field, rule, limit)));
        int ofShaking = shakingColumns().indexOf(rule.name());
        if (ofShaking >= 0) {
            int slot = Slots.SHAKING + ofShaking;
            columns.add(plain(field, rule, slot));
        }
        if (!rule.ignored()) {
            bindMeaning(field, rule);
        }
    }

    private static Ends.LimitedColumn limited(int field, MappedColumn rule, Limit limit) {
        return new Ends.LimitedColumn(plain(field, rule, Slots.NOWHERE), limit);
    }

    /** A column in its usual unit, whatever it means. */
    private static BoundColumn plain(int field, MappedColumn rule, int slot) {
        return new BoundColumn(field, rule.name(), slot, rule.factor(), rule.offset(), rule.form());
    }

    private void bindMeaning(int field, MappedColumn rule) throws DocumentException {
        String meaning = rule.means().orElse(rule.name());
        if (Slots.byName().containsKey(meaning)) {
            int slot = Slots.byName().get(meaning);
            meant.add(meaning);
            double unit = unit(slot, meaning);
            add(field, rule, slot, unit);
            lasting.put(slot, rule.lastingError().stream().map(e -> e.times(unit)).toList());
        } else if (known.isKnown(meaning)) {
            for (CommandNames.Part part : known.parts(meaning)) {
                int slot = Slots.COMMANDS + commands.size();
                commands.add(part.command());
                add(field, rule, slot, part.factor() * (part.isAngle() ? angle() : 1));
            }
        } else if (rule.means().isPresent()) {
            throw unknown().refusal(rule.name(), meaning);
        } else if (!(mapping.ignoreOthers() || isOfUse(rule))) {
            unknown.add(rule.name());
        }
    }

    /** Whether a column tells something, though it is none that is known by its name. */
    private boolean isOfUse(MappedColumn rule) {
        return rule.runEnds().isPresent() || shakingColumns().contains(rule.name());
    }

    private double unit(int slot, String meaning) {
        boolean isDepth = meaning.equals(Slots.DEPTH_NAME);
        boolean isUp = Axes.of(mapping.axes()) == Axes.ENU;
        double sign = isDepth && isUp ? -1 : 1;
        return sign * (Slots.isAngular(slot) ? angle() : 1);
    }

    private double angle() {
        return mapping.degrees() ? RADIANS : 1;
    }

    private void add(int field, MappedColumn rule, int slot, double factor)
            throws DocumentException {
        String other = filled.putIfAbsent(slot, rule.name());
        if (other != null) {
            throw table.at(
                    1,
                    rule.name(),
                    "column '%s' already provides this quantity; ignore one of the two %s"
                            .formatted(other, Remedy.ignoring(List.of(rule.name()))));
        }
        CellForm form = rule.form();
        columns.add(
                new BoundColumn(
                        field,
                        rule.name(),
                        slot,
                        factor * rule.factor(),
                        factor * rule.offset(),
                        form));
    }

    private void require() throws DocumentException {
        if (!filled.containsKey(Slots.TIME)) {
            throw table.at(
                    1,
                    Slots.TIME_NAME,
                    "the header has no column with the time in s, only %s; rename the one that has it %s"
                            .formatted(
                                    String.join(", ", table.columns()),
                                    Remedy.renaming(Remedy.COLUMN, Slots.TIME_NAME)));
        }
        if (filled.keySet().stream().noneMatch(Slots::isMeasured)) {
            throw new DocumentException(
                    "%s: the header has nothing that was measured; expected at least one of %s"
                            .formatted(
                                    table.file(),
                                    Slots.byName().entrySet().stream()
                                            .filter(e -> Slots.isMeasured(e.getValue()))
                                            .map(Map.Entry::getKey)
                                            .collect(Collectors.joining(", "))));
        }
        requireWhole();
    }

    private void requireWhole() throws DocumentException {
        long parts = filled.keySet().stream().filter(Layout::isOfQuaternion).count();
        if (parts != 0 && parts != 4) {
            throw table.at(
                    1,
                    first(Slots.QUATERNION, 4),
                    "a quaternion needs all of qw, qx, qy and qz, but there is no %s: name the columns that have them %s, or ignore what there is %s"
                            .formatted(
                                    String.join(" and no ", missingOfQuaternion()),
                                    Remedy.renaming(
                                            Remedy.COLUMN, missingOfQuaternion().getFirst()),
                                    Remedy.ignoring(named(Slots.QUATERNION_NAMES))));
        }
        boolean hasAngles = !first(Slots.ANGLES, 3).isEmpty();
        if (parts != 0 && hasAngles) {
            throw table.at(
                    1,
                    first(Slots.ANGLES, 3),
                    "the orientation is there as a quaternion already; ignore one of the two %s"
                            .formatted(Remedy.ignoring(named(Slots.ANGLE_NAMES))));
        }
        requireOneFrame(Slots.VX, Slots.U, Slots.VELOCITY);
        requireOneFrame(Slots.WX, Slots.P, Slots.ANGULAR_VELOCITY);
    }

    private List<String> missingOfQuaternion() {
        return Slots.QUATERNION_NAMES.stream()
                .filter(name -> !filled.containsKey(Slots.byName().get(name)))
                .toList();
    }

    /** Refuses vx beside v: no vector is measured in two frames at once. */
    private void requireOneFrame(List<String> world, List<String> body, int slot)
            throws DocumentException {
        boolean both =
                world.stream().anyMatch(meant::contains) && body.stream().anyMatch(meant::contains);
        if (both) {
            throw table.at(
                    1,
                    first(slot, 3),
                    "%s are in the world's axes and %s in the body's; ignore those of one kind %s"
                            .formatted(
                                    String.join(", ", world),
                                    String.join(", ", body),
                                    Remedy.ignoring(named(body))));
        }
    }

    /** The columns that have one of these meanings. */
    private List<String> named(List<String> meanings) {
        return table.columns().stream()
                .map(this::rule)
                .filter(rule -> !rule.ignored())
                .filter(rule -> meanings.contains(rule.means().orElse(rule.name())))
                .map(MappedColumn::name)
                .toList();
    }

    private static boolean isOfQuaternion(int slot) {
        return slot >= Slots.QUATERNION && slot < Slots.QUATERNION + 4;
    }

    private String first(int slot, int count) {
        for (int i = slot; i < slot + count; i++) {
            if (filled.containsKey(i)) {
                return filled.get(i);
            }
        }
        return "";
    }
}
