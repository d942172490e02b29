package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.cause.Earth;
import org.auvsim.diagnosis.cause.Quantity;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/** What each cause means, in a few words: {@code Quadratic drag is missing}. */
public final class Phrases {
    private static final Map<String, Phrase> KNOWN = new HashMap<>();

    private static final String ALIKE_EVERYWHERE =
            "An oscillating force, the same everywhere, is missing";

    private static final String TURNED = "thruster_misalignment";

    /** Which of the angles by which it is turned. */
    private static final List<String> ASPECTS = List.of("angle", "tilt");

    /** Numbers are within so many of their standard deviations, in 95 of 100 measurements. */
    static final double LIKELY = 2;

    private Phrases() {}

    /**
     * Words for a cause.
     *
     * @param words in which {@code %s} stands for what it is about, in quotation marks as a name,
     *     {@code %2$s} for the same without them, and {@code %3$s} for what that does, or all do
     * @param otherwise if a number is below 0
     * @param number the name of that; the first, if none is said
     */
    private record Phrase(String words, String otherwise, Optional<String> number) {
        boolean isOtherwise(Finding finding) {
            return finding.quantities().stream()
                    .filter(of -> number.isEmpty() || of.name().equals(number.get()))
                    .limit(1)
                    .anyMatch(of -> of.value() < 0);
        }
    }

    private static void put(String id, String words) {
        put(id, words, words);
    }

    private static void put(String id, String words, String otherwise) {
        KNOWN.put(id, new Phrase(words, otherwise, Optional.empty()));
    }

    static {
        put("linear_drag", "Linear drag is missing", "There is too much linear drag");
        put("quadratic_drag", "Quadratic drag is missing", "There is too much quadratic drag");
        put("anisotropic_drag", "Drag along the body's axes is missing");
        put("anisotropic_linear_drag", "Linear drag along the body's axes is missing");
        put("rotational_drag", "Rotational drag is missing", "There is too much rotational drag");
        put("added_mass", "Added mass is missing");
        put("current_constant", "A constant current is missing");
        put("current_oscillating", "An oscillating current is missing");
        put("current_shear", "A current that changes with height is missing");
        put("current_vortex", "A vortex is missing");
        put("buoyancy_weight", "An upward force is missing", "A downward force is missing");
        put("cob_offset", "The centre of buoyancy is misplaced");
        put("cog_offset", "The centre of mass is misplaced");
        put("mass_error", "The mass is wrong");
        put("inertia_error", "The moments of inertia are wrong");
        put("thruster_gain", "The thrust of %s is wrong", "%s %3$s backwards");
        put("thruster_deadzone", "A dead zone of %s is missing");
        put("thruster_lag", "A lag of %s is missing");
        put(
                "thruster_advance",
                "The thrust of %s falls with speed",
                "The thrust of %s falls less with speed than modelled");
        put("thruster_astern", "The thrust of %s astern is wrong");
        put("thruster_fade", "The thrust of %s fades", "The thrust of %s grows with time");
        put(TURNED, "The direction of %s is wrong");
        put("thruster_loss", "Thrust of %s is lost");
        put("propeller_imbalance", "A propeller is out of balance");
        put("fin_gain", "The lift of %s is wrong");
        put("fin_offset", "The zero of %s is off");
        put(
                "fin_race",
                "The flow past %s is faster than modelled",
                "The flow past %s is slower than modelled");
        put("hull_lift", "Lift of the hull in %2$s is missing");
        KNOWN.put(
                "magnetic",
                new Phrase(
                        "A magnetic attraction is missing",
                        "A magnetic repulsion is missing",
                        Optional.of("strength")));
        put("magnus", "The Magnus force is missing");
        put("coulomb_friction", "Dry friction is missing");
        put("coulomb_torque", "Dry friction about the pivot is missing");
        put("restitution", "The restitution of impacts is wrong");
        put("contact_friction", "The friction at contacts is wrong");
        put("tether_spring", "The pull of a tether is missing");
        put("wave_forcing", "The force of waves is missing");
        put("periodic_force", "A periodic force is missing");
        put("step_force", "A force that starts during the run is missing");
        put("impulse", "An impulse is missing");
        put("sensor_bias", "The measured heading is off");
        put("compass_deviation", "The compass has a deviation");
        put("sensor_drift", "The measured heading drifts");
        put("position_drift", "The measured position drifts");
        put("sensor_offset", "The measured positions have a constant offset");
        put("orientation_delay", "The measured orientations are late");
        put("position_delay", "The measured positions are late");
        put("sensor_lever_arm", "The measured positions are of another point of the body");
        put("sensor_scale", "The scale of the measured positions is wrong");
        put("sensor_delay", "The measurements are delayed");
        put(
                "clock_offset",
                "The measurement clock is offset",
                "The measurements are ahead of the commands, which may be stamped late");
        put("axis_misalignment", "The sensor axes are rotated");
    }

    /** Of a finding. */
    public static String of(Finding finding) {
        return isAlikeEverywhere(finding)
                ? ALIKE_EVERYWHERE
                : of(finding.cause(), finding.subject(), isBelow(finding));
    }

    /**
     * Whether a force as of waves is told by a wave number that may well be 0, but not that of
     * waves in deep water.
     */
    private static boolean isAlikeEverywhere(Finding finding) {
        double omega = 0;
        for (int i = 0; i < finding.deviations().size(); i++) {
            Quantity of = finding.quantities().get(i);
            if (of.isFrequency()) {
                omega = of.value();
            } else if (of.name().equals("wave_number")) {
                double far = LIKELY * finding.deviations().get(i);
                double ofDeepWater = omega * omega / Earth.GRAVITY;
                return Math.abs(of.value()) <= far
                        && Math.abs(Math.abs(of.value()) - ofDeepWater) > far;
            }
        }
        return false;
    }

    private static boolean isBelow(Finding finding) {
        Phrase phrase = KNOWN.get(finding.cause());
        return phrase != null && phrase.isOtherwise(finding);
    }

    /** Whether the words for a finding say that a number is below 0. */
    static boolean tellsSign(Finding finding) {
        Phrase phrase = KNOWN.get(finding.cause());
        return phrase != null && isBelow(finding) && !phrase.words().equals(phrase.otherwise());
    }

    /**
     * Of a cause as {@link org.auvsim.diagnosis.cause.Cause#label} has it: {@code thruster_gain
     * (port)}.
     */
    public static String of(String label) {
        int bracket = label.indexOf(" (");
        if (bracket < 0) {
            return of(label, Optional.empty(), false);
        }
        String id = label.substring(0, bracket);
        String about = label.substring(bracket + 2, label.length() - 1);
        for (String aspect : id.equals(TURNED) ? ASPECTS : List.<String>of()) {
            String begin = aspect + " of ";
            if (about.startsWith(begin)) {
                return "The %s of '%s' is wrong".formatted(aspect, about.substring(begin.length()));
            }
        }
        return of(id, Optional.of(about), false);
    }

    private static String of(String id, Optional<String> subject, boolean isBelow) {
        Phrase phrase = KNOWN.get(id);
        if (phrase == null) {
            return capitalised(id.replace('_', ' '))
                    + subject.map(" of '%s'"::formatted).orElse("")
                    + " is missing";
        }
        String about = subject.orElse("all thrusters");
        return capitalised(
                (isBelow ? phrase.otherwise() : phrase.words())
                        .formatted(
                                subject.map("'%s'"::formatted).orElse(about),
                                about,
                                subject.isPresent() ? "runs" : "run"));
    }

    private static String capitalised(String words) {
        return words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
    }

    /** A phrase within a sentence. */
    public static String inside(String phrase) {
        return phrase.substring(0, 1).toLowerCase(Locale.ROOT) + phrase.substring(1);
    }
}
