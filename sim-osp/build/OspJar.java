// SPDX-License-Identifier: GPL-2.0-or-later
import java.io.IOException;
import java.nio.file.Path;
import java.util.jar.JarFile;

/** Ends with 1 and a sentence if a file is not the jar of Open Source Physics. */
public final class OspJar {
    private static final String SOLVER = "org/opensourcephysics/numerics/RK45MultiStep.class";

    private OspJar() {}

    public static void main(String[] arguments) {
        String file = arguments[0];
        String fault = "";
        try (JarFile jar = new JarFile(Path.of(file).toFile())) {
            if (jar.getEntry(SOLVER) == null) {
                fault = "has no " + SOLVER;
            }
        } catch (IOException e) {
            fault = "is not there or no jar (" + e.getMessage() + ")";
        }
        if (!fault.isEmpty()) {
            System.err.println(
                    "-Dosp.jar names "
                            + file
                            + ", which "
                            + fault
                            + ": give the absolute path of the jar of Open Source Physics"
                            + " (docs/osp.md says where to get it).");
            System.exit(1);
        }
    }
}
