package org.auvsim.auvsml;

/** The kinds of errors, as {@code error-response} names them. */
public enum ErrorCode {
    /** The text is not well-formed XML. */
    MALFORMED_XML,
    /** A DOCTYPE, an entity, or another thing that AUVSML never reads. */
    FORBIDDEN_XML,
    /** Larger, deeper, or with more attributes than this reader takes. */
    LIMIT_EXCEEDED,
    /** The root is none of AUVSML's. */
    UNKNOWN_ROOT,
    /** No registered message has this name. */
    UNKNOWN_MESSAGE,
    /** An element that its parent does not have. */
    UNKNOWN_ELEMENT,
    /** An attribute that its element does not have. */
    UNKNOWN_ATTRIBUTE,
    /** An attribute or element that must be there is not. */
    MISSING_VALUE,
    /** An element that may stand once stands twice. */
    DUPLICATE_ELEMENT,
    /** A value that cannot be read, or that makes no sense. */
    INVALID_VALUE,
    /** An id or name that the world does not have. */
    UNKNOWN_ENTITY,
    /** The client's role does not allow it. */
    NOT_ALLOWED,
    /** Somebody else controls the world object. */
    NOT_IN_CONTROL,
    /** The world could not make a step and stands still. */
    STEP_FAILED,
    /** Understood, but not possible now or not allowed. */
    REFUSED
}
