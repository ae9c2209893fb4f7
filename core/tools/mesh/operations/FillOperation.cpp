// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/FillOperation.h"

#include "mesh/measure/MeshFidelity.h"
#include "tools/mesh/ScriptLine.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Parameter methodParameter() {
  return {.property = {.id = "fill",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Method"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "Fair"), QT_TRANSLATE_NOOP("Property", "Refined"),
                                   QT_TRANSLATE_NOOP("Property", "Ear clipping"),
                                   QT_TRANSLATE_NOOP("Property", "Area and bending"),
                                   QT_TRANSLATE_NOOP("Property", "Minimum area"),
                                   QT_TRANSLATE_NOOP("Property", "Minimum bending"),
                                   QT_TRANSLATE_NOOP("Property", "Ridges"),
                                   QT_TRANSLATE_NOOP("Property", "Flat")}},  // in the order of FillMethod
          .meaning = "Method that fills holes",
          .word = "METHOD",
          .words = {"fair", "refined", "ear", "minimal", "area", "dihedral", "ridge", "flat"},
          .isAlwaysWritten = true};
}

Parameter continuityParameter() {
  return {.property = {.id = "continuity",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Continuity"),
                       .value = static_cast<double>(FillOptions().continuity),
                       .choices = {QT_TRANSLATE_NOOP("Property", "Position"), QT_TRANSLATE_NOOP("Property", "Tangents"),
                                   QT_TRANSLATE_NOOP("Property", "Curvature")}},  // in the order of Continuity
          .meaning = "Continuity of fair patches and ridges with their surroundings",
          .word = "HOW",
          .words = {"position", "tangent", "curvature"}};
}

std::vector<double> numbersOf(const EarWeights& ears) {
  return {ears.length, ears.angles, ears.normal, ears.lid};
}

Parameter earsParameter() {
  Parameter ears = {
      .property = {.id = "ears", .group = {}, .label = {}, .value = "", .least = 0.0, .largest = 1e6},
      .meaning = "Weights of ear clipping: short edges, even angles, small bends, and of the normal of the whole hole",
      .word = "L,A,N,W",
      .parts = {{"length", QT_TRANSLATE_NOOP("Property", "Weight of short edges")},
                {"angles", QT_TRANSLATE_NOOP("Property", "Weight of even angles")},
                {"normal", QT_TRANSLATE_NOOP("Property", "Weight of small bends")},
                {"whole"}}};
  ears.property.value = listText(ears, numbersOf(EarWeights()));
  return ears;
}

}  // namespace

Parameter numbersParameter() {
  return {.property = {.id = "numbers", .group = {}, .label = {}, .value = 0.0},
          .meaning = "Round coordinates to this type; default: the type of the file",
          .word = "TYPE",
          .words = {"single", "double"},  // in the order of NumberType
          .hasDefault = false};
}

std::vector<Parameter> fillParameters() {
  std::vector<Parameter> all = {methodParameter(), continuityParameter(),
                                measuredParameter("density", patchDensitySetting(), "N", patchDensitySetting().label),
                                measuredParameter("piece-edges", pieceEdgesSetting(), "N", pieceEdgesSetting().label),
                                earsParameter()};
  all.push_back(numbersParameter());
  for (Parameter& parameter : all) parameter.bundle = "FILL";
  return all;
}

const Operation& fillOperation() {
  static const Operation operation = [] {
    Operation fill = {.id = "fill",
                      .title = QT_TRANSLATE_NOOP("Tool", "Fill hole"),
                      .meaning = "Close one hole",
                      .operands = "LOOP",
                      .parameters = fillParameters()};
    fill.parameters.push_back({.property = {.id = "bridges", .group = {}, .label = {}, .value = ""},
                               .meaning = "Divide it by bridges between these vertices, counted along the loop from 0",
                               .word = "P:P,...",
                               .hasDefault = false});
    return fill;
  }();
  return operation;
}

std::optional<NumberType> numbersOf(const OperationValues& values) {
  const auto given = values.given("numbers");
  return given ? std::optional(static_cast<NumberType>(*given)) : std::nullopt;
}

void setNumbers(OperationValues& values, NumberType numbers) {
  values.setValid("numbers", static_cast<double>(numbers));
}

FillOptions fillOptionsOf(const OperationValues& values) {
  FillOptions options;
  options.method = static_cast<FillMethod>(values.whole("fill"));
  options.continuity = static_cast<Continuity>(values.whole("continuity"));
  options.density = values.number("density");
  options.pieceEdges = values.whole("piece-edges");
  const std::vector<double> ears = values.numbers("ears");
  options.ears = {ears[0], ears[1], ears[2], ears[3]};
  options.numbers = numbersOf(values).value_or(NumberType::Float64);
  return options;
}

void setFillOptions(OperationValues& values, const FillOptions& options) {
  values.setValid("fill", static_cast<double>(options.method));
  values.setValid("continuity", static_cast<double>(options.continuity));
  values.setValid("density", options.density);
  values.setValid("piece-edges", static_cast<double>(options.pieceEdges));
  values.setValid("ears", numbersOf(options.ears));
  setNumbers(values, options.numbers);
}

OperationValues valuesOf(const FillOptions& options) {
  OperationValues values(fillOperation());
  setFillOptions(values, options);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
  for (const HoleBridge& bridge : options.bridges) ends.emplace_back(bridge.a, bridge.b);
  if (!ends.empty()) values.setValid("bridges", pairsText(ends));
  return values;
}

}  // namespace handwheel
