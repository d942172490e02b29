package org.auvsim.checks.offender.auvsml;

import org.jdom2.input.SAXBuilder;

record ParsesWithSax(SAXBuilder builder) {}
