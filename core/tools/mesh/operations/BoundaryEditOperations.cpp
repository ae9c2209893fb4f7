// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/BoundaryEditOperations.h"

#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/MeshOperations.h"
#include "tools/mesh/operations/SharedParameters.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Parameter wavelengthParameter() {
  return {.property = {.id = "wavelength",
                       .group = {},
                       .label = {},
                       .value = SmoothingOptions().wavelength,
                       .least = 0.0,
                       .largest = SmoothingOptions::kLongestWavelength},
          .meaning = "Remove shorter waves, in edges; below 2 only the spacing changes",
          .word = "EDGES"};
}

}  // namespace

std::vector<Operation> boundaryEditOperations() {
  return {
      {.id = "bridge",
       .title = QT_TRANSLATE_NOOP("Tool", "Add a bridge"),
       .meaning = "Add triangles between two vertices of open edges; H: 3 times a triangle, plus the corner where the "
                  "edge starts",
       .operands = "H,H"},
      {.id = "join",
       .title = QT_TRANSLATE_NOOP("Tool", "Join boundary vertices"),
       .meaning = "Move a vertex of an open edge to another, and join them",
       .operands = "H,H"},
      {.id = "face",
       .title = QT_TRANSLATE_NOOP("Tool", "Make a face"),
       .meaning = "Create a face from three vertices of open edges",
       .operands = "V,V,V"},
      {.id = "pull",
       .title = QT_TRANSLATE_NOOP("Tool", "Move a boundary vertex"),
       .meaning = "Move a vertex, unless a triangle would flip or intersect another",
       .operands = "V X,Y,Z"},
      {.id = "smooth-edge",
       .title = QT_TRANSLATE_NOOP("Tool", "Smooth the boundary"),
       .meaning = "Fit a smooth curve to a boundary loop",
       .operands = "LOOP",
       .parameters = {wavelengthParameter(), flagParameter("uneven", "Do not space its vertices evenly"),
                      numbersParameter()}},
  };
}

SmoothingOptions smoothingOptionsOf(const OperationValues& values) {
  return {values.number("wavelength"), !values.flag("uneven"), numbersOf(values).value_or(NumberType::Float64)};
}

OperationValues valuesOf(const SmoothingOptions& options) {
  OperationValues values(meshOperation("smooth-edge"));
  values.setValid("wavelength", options.wavelength);
  values.setValid("uneven", !options.evenly);
  setNumbers(values, options.numbers);
  return values;
}

}  // namespace handwheel
