// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/TransformOperations.h"

#include "tools/mesh/Placement.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Parameter unitParameter() {
  Parameter unit = {
      .property = {.id = "unit", .group = {}, .label = QT_TRANSLATE_NOOP("Property", "Unit of the file"), .value = 0.0},
      .meaning = "Convert from this unit to mm, about the origin, before anything else",
      .word = "U"};
  for (const Placement::Unit& each : Placement::kUnits) unit.words.emplace_back(each.symbol);
  unit.property.choices = unit.words;
  return unit;
}

Parameter scaleParameter() {
  return {.property = {.id = "scale",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Scale by"),
                       .value = 1.0,
                       .least = 1e-9,
                       .largest = 1e9},
          .meaning = "Scale about the centre",
          .word = "N"};
}

Parameter turnParameter() {
  return {.property = {.id = "turn",
                       .group = {},
                       .label = {},
                       .value = "0,0,0",
                       .quantity = Quantity::Angle,
                       .least = -2.0 * std::numbers::pi,
                       .largest = 2.0 * std::numbers::pi},
          .meaning = "Then rotate about x, y and z in degrees, about the centre",
          .word = "A,B,C",
          .parts = {{"x", QT_TRANSLATE_NOOP("Property", "Rotate about X")},
                    {"y", QT_TRANSLATE_NOOP("Property", "Rotate about Y")},
                    {"z", QT_TRANSLATE_NOOP("Property", "Rotate about Z")}}};
}

Parameter moveParameter() {
  return {.property = {.id = "move",
                       .group = {},
                       .label = {},
                       .value = "0,0,0",
                       .quantity = Quantity::Length,
                       .least = -1e9,
                       .largest = 1e9},
          .meaning = "Then move, in mm",
          .word = "X,Y,Z",
          .parts = {{"x", QT_TRANSLATE_NOOP("Property", "Move along X")},
                    {"y", QT_TRANSLATE_NOOP("Property", "Move along Y")},
                    {"z", QT_TRANSLATE_NOOP("Property", "Move along Z")}}};
}

}  // namespace

std::vector<Operation> transformOperations() {
  std::vector<Operation> all = {{.id = "place",
                                 .title = QT_TRANSLATE_NOOP("Tool", "Place"),
                                 .meaning = "Scale, rotate and move",
                                 .parameters = {unitParameter(), scaleParameter(), turnParameter(), moveParameter()}}};
  for (const StandardPlacement& standard : standardPlacements())
    all.push_back({.id = standard.id, .title = standard.text, .meaning = standard.text});
  return all;
}

}  // namespace handwheel
