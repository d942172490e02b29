package org.auvsim.auvsml.document;

/** A file that cannot be used; one sentence with file, line and column, for people. */
public final class DocumentException extends Exception {
    /** With that sentence. */
    public DocumentException(String message, Throwable cause) {
        super(message, cause);
    }
}
