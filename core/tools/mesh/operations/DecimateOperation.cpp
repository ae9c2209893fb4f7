// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/DecimateOperation.h"

#include "tools/mesh/operations/SharedParameters.h"

#include <QtGlobal>
#include <numbers>

namespace handwheel {
namespace {

Parameter errorParameter() {
  return {.property = {.id = "error",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Largest distance"),
                       .value = 0.0,
                       .quantity = Quantity::Length,
                       .least = 1e-12,
                       .largest = 1e12},
          .meaning = "Stay within this distance of the original, measured both ways",
          .word = "MM",
          .hasDefault = false};
}

Parameter creasesParameter() {
  return {.property = {.id = "keep-creases",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Sharp edge angle"),
                       .value = 0.0,
                       .quantity = Quantity::Angle,
                       .least = 0.01 * kRadiansPerDegree,
                       .largest = std::numbers::pi},
          .meaning = "Keep the vertices of edges with at least this angle on the edges",
          .word = "DEGREES",
          .hasDefault = false};
}

Parameter decimationMethodParameter() {
  return {.property = {.id = "method",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Method"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "Bounded"),
                                   QT_TRANSLATE_NOOP("Property", "Quadric")}},  // in the order of DecimationMethod
          .meaning = "bounded limits the distance; quadric only removes vertices, without --error and --no-crossings",
          .word = "METHOD",
          .words = {"bounded", "quadric"}};
}

}  // namespace

const Operation& decimateOperation() {
  static const Operation operation = {
      .id = "decimate",
      .title = QT_TRANSLATE_NOOP("Tool", "Reduce triangles"),
      .meaning = "As 'handwheel decimate'",
      .parameters = {
          countParameter("faces", "N", "Target number of triangles; 0: as few as --error allows",
                         QT_TRANSLATE_NOOP("Property", "Triangles")),
          errorParameter(),
          flagParameter("keep-borders", "Do not move the vertices of open edges",
                        QT_TRANSLATE_NOOP("Property", "Preserve open edges")),
          creasesParameter(),
          flagParameter("no-crossings", "Create no new self-intersections",
                        QT_TRANSLATE_NOOP("Property", "Prevent self-intersections")),
          decimationMethodParameter(),
      }};
  return operation;
}

DecimationOptions decimationOptionsOf(const OperationValues& values) {
  DecimationOptions options;
  options.faces = values.whole("faces");
  options.error = values.given("error");
  options.keepBorders = values.flag("keep-borders");
  options.creaseAngle = values.given("keep-creases");
  options.avoidIntersections = values.flag("no-crossings");
  options.method = static_cast<DecimationMethod>(values.whole("method"));
  return options;
}

OperationValues valuesOf(const DecimationOptions& options) {
  OperationValues values(decimateOperation());
  values.setValid("faces", static_cast<double>(options.faces));
  if (options.error) values.setValid("error", *options.error);
  values.setValid("keep-borders", options.keepBorders);
  if (options.creaseAngle) values.setValid("keep-creases", *options.creaseAngle);
  values.setValid("no-crossings", options.avoidIntersections);
  values.setValid("method", static_cast<double>(options.method));
  return values;
}

std::string problemOf(const OperationValues& values) {
  if (values.whole("faces") == 0 && !values.given("error")) return "give a target: --faces N, --error MM or both";
  if (static_cast<DecimationMethod>(values.whole("method")) == DecimationMethod::Bounded) return {};
  if (values.given("error"))
    return "--method quadric does not bound the distance: give --faces N alone, or use --method bounded";
  if (values.flag("no-crossings"))
    return "--method quadric does not check for self-intersections: omit --no-crossings, or use --method bounded";
  return {};
}

}  // namespace handwheel
