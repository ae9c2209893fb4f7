// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/SubdivideOperation.h"

#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/SharedParameters.h"

#include <QtGlobal>

namespace handwheel {
namespace {

constexpr double kMostTimes = 12.0;  // each has three or four times the faces

Parameter schemeParameter() {
  return {.property = {.id = "method",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Scheme"),
                       .value = 3.0,  // leaves the surface unchanged
                       .choices = {QT_TRANSLATE_NOOP("Property", "Loop"), QT_TRANSLATE_NOOP("Property", "√3"),
                                   QT_TRANSLATE_NOOP("Property", "Butterfly"),
                                   QT_TRANSLATE_NOOP("Property", "Midpoint")}},  // in the order of SubdivisionScheme
          .meaning =
              "loop and sqrt3 smooth the surface, butterfly bends it and moves no vertex, midpoint leaves it as it is; "
              "sqrt3 splits in three, the others in four",
          .word = "SCHEME",
          .words = {"loop", "sqrt3", "butterfly", "midpoint"}};
}

Parameter timesParameter() {
  Parameter times =
      countParameter("times", "N", "Number of subdivision levels", QT_TRANSLATE_NOOP("Property", "Levels"));
  times.property.value = 1.0;
  times.property.least = 1.0;
  times.property.largest = kMostTimes;
  return times;
}

}  // namespace

const Operation& subdivideMeshOperation() {
  static const Operation operation = {
      .id = "subdivide-mesh",
      .title = QT_TRANSLATE_NOOP("Tool", "Subdivide the mesh"),
      .meaning = "Refine the whole mesh, including open edges; 'subdivide' refines a patch",
      .parameters = {schemeParameter(), timesParameter(), numbersParameter()}};
  return operation;
}

SchemeSubdivision schemeSubdivisionOf(const OperationValues& values) {
  return {static_cast<SubdivisionScheme>(values.whole("method")), static_cast<int>(values.whole("times"))};
}

OperationValues valuesOf(const SchemeSubdivision& subdivision) {
  OperationValues values(subdivideMeshOperation());
  values.setValid("method", static_cast<double>(subdivision.scheme));
  values.setValid("times", static_cast<double>(subdivision.times));
  return values;
}

}  // namespace handwheel
