// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/operations/PlaceOperation.h"

#include "tools/mesh/Placement.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Parameter unitParameter() {
  Parameter unit = {
      .property = {.id = "unit", .group = {}, .label = QT_TRANSLATE_NOOP("Property", "The file is in"), .value = 0.0},
      .meaning = "From this unit to mm, about the origin, before anything else",
      .word = "U"};
  for (const LengthUnit each : Placement::kUnits) unit.words.emplace_back(symbolOf(each));
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
          .meaning = "Scale about the middle",
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
          .meaning = "Then turn about x, y and z in degrees, about the middle",
          .word = "A,B,C",
          .parts = {{"x", QT_TRANSLATE_NOOP("Property", "Turn about X")},
                    {"y", QT_TRANSLATE_NOOP("Property", "Turn about Y")},
                    {"z", QT_TRANSLATE_NOOP("Property", "Turn about Z")}}};
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

std::vector<Operation> placeOperations() {
  std::vector<Operation> all = {{.id = "place",
                                 .title = QT_TRANSLATE_NOOP("Tool", "Place"),
                                 .meaning = "Scale, turn and move",
                                 .parameters = {unitParameter(), scaleParameter(), turnParameter(), moveParameter()}}};
  for (const StandardPlace& standard : standardPlaces())
    all.push_back({.id = standard.id, .title = standard.text, .meaning = standard.text});
  return all;
}

}  // namespace handwheel
