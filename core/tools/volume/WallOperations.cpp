// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/WallOperations.h"

#include "volume/VolumeErrors.h"
#include "volume/VolumeOffset.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Parameter distanceParameter(const char* id, const char* label, double value, double least, std::string meaning) {
  return {.property = {.id = id,
                       .group = {},
                       .label = label,
                       .value = value,
                       .quantity = Quantity::Length,
                       .least = least,
                       .largest = 1e6},
          .meaning = std::move(meaning),
          .word = "MM"};
}

Parameter sideParameter() {
  return {.property = {.id = "side",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Wall"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "Inside the surface"),
                                   QT_TRANSLATE_NOOP("Property", "Outside the surface"),
                                   QT_TRANSLATE_NOOP("Property", "On both sides of it")}},  // as WallSide
          .meaning = "Where the wall is: inside of the surface, outside, or with the surface in its middle",
          .word = "SIDE",
          .words = {"inside", "outside", "middle"}};
}

Result<SparseVolume> unlessEmpty(Result<SparseVolume> made) {
  if (made && made->isEmpty()) return Error{VolumeErrors::NothingLeft, {}, {}, {}};
  return made;
}

}  // namespace

const Operation& shellOperation() {
  static const Operation operation = {
      .id = "shell",
      .title = QT_TRANSLATE_NOOP("Tool", "Make shell"),
      .meaning = "Leaves a wall along the surface of a volume",
      .parameters = {distanceParameter("wall", QT_TRANSLATE_NOOP("Property", "Wall thickness"), 2.0, 1e-9,
                                       "Thickness of the wall; at least two voxels"),
                     sideParameter()}};
  return operation;
}

const Operation& offsetOperation() {
  static const Operation operation = {
      .id = "offset",
      .title = QT_TRANSLATE_NOOP("Tool", "Move surface"),
      .meaning = "Moves the surface of a volume out or in",
      .parameters = {distanceParameter("distance", QT_TRANSLATE_NOOP("Property", "Distance"), 1.0, -1e6,
                                       "Outwards; below 0 inwards")}};
  return operation;
}

Result<SparseVolume> makeShell(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  return unlessEmpty(shellOf(volume, values.number("wall"), static_cast<WallSide>(values.whole("side")), progress));
}

Result<SparseVolume> makeOffset(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  return unlessEmpty(movedSurface(volume, values.number("distance"), progress));
}

}  // namespace handwheel
