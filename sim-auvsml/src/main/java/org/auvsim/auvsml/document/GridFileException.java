package org.auvsim.auvsml.document;

/** A grid's file that cannot be used; a sentence with file, line and column. */
final class GridFileException extends Exception {
    GridFileException(String message) {
        super(message);
    }
}
