package org.auvsim.junit;

import java.io.IOException;
import java.nio.file.Path;

/** Takes what a failed test leaves behind, beside JUnit's other reports. */
@FunctionalInterface
interface Evidence {
    /**
     * Keeps a picture.
     *
     * @return the file that it is in
     */
    Path keep(String fileName, byte[] png) throws IOException;
}
