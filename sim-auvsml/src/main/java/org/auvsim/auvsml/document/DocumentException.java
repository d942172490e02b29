package org.auvsim.auvsml.document;

/** A file that cannot be used; a sentence with file, line and column for each fault, for people. */
public final class DocumentException extends Exception {
    /** With that sentence. */
    public DocumentException(String message) {
        super(message);
    }

    /** With those sentences, a line each. */
    public DocumentException(String message, Throwable cause) {
        super(message, cause);
    }
}
