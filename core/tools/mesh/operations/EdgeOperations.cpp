// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/EdgeOperations.h"

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
          .meaning = "Remove waves that are shorter, in edges; below 2 only the spacing changes",
          .word = "EDGES"};
}

}  // namespace

std::vector<Operation> edgeOperations() {
  return {
      {.id = "bridge",
       .title = QT_TRANSLATE_NOOP("Tool", "Lay a bridge"),
       .meaning = "Put faces between two points of open edges; H: 3 times a triangle, plus the corner that it leaves",
       .operands = "H,H"},
      {.id = "join",
       .title = QT_TRANSLATE_NOOP("Tool", "Join points of the edge"),
       .meaning = "Move a point of an open edge to another, and join them",
       .operands = "H,H"},
      {.id = "face",
       .title = QT_TRANSLATE_NOOP("Tool", "Make a face"),
       .meaning = "Over three points of open edges",
       .operands = "V,V,V"},
      {.id = "pull",
       .title = QT_TRANSLATE_NOOP("Tool", "Pull a point of the edge"),
       .meaning = "Move a vertex, where no triangle turns over or crosses another",
       .operands = "V X,Y,Z"},
      {.id = "smooth-edge",
       .title = QT_TRANSLATE_NOOP("Tool", "Smooth the edge"),
       .meaning = "Draw an open edge onto a smooth curve",
       .operands = "LOOP",
       .parameters = {wavelengthParameter(), flagParameter("uneven", "Do not spread its points evenly"),
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
