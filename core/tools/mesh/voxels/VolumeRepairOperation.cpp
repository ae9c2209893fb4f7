// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairOperation.h"

#include "tools/mesh/operations/FillOperation.h"

#include <QtGlobal>

namespace handwheel {
namespace {

Parameter voxelParameter() {
  return {.property = {.id = "voxel",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Edge of a voxel"),
                       .value = 1.0,
                       .quantity = Quantity::Length,
                       .least = 1e-9,
                       .largest = 1e9},
          .meaning = "Edge of a voxel, in mm; what is smaller is lost. Default: a 256th of the largest extent",
          .word = "MM",
          .hasDefault = false};
}

Parameter gapsParameter() {
  return {.property = {.id = "close-gaps",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Close gaps up to a radius of"),
                       .value = 0.0,
                       .quantity = Quantity::Length,
                       .least = 0.0,
                       .largest = 1e9},
          .meaning = "Fill gaps that a ball of this radius, in mm, does not get into",
          .word = "MM"};
}

Parameter wallParameter() {
  return {.property = {.id = "wall",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Wall thickness"),
                       .value = 0.0,
                       .quantity = Quantity::Length,
                       .least = 0.0,
                       .largest = 1e9},
          .meaning = "Make walls of this thickness, in mm, of the triangles, where they enclose nothing",
          .word = "MM"};
}

Parameter consentParameter() {
  return {.property = {.id = "yes",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "More than a quarter of the memory"),
                       .value = false},
          .meaning = "Also where it needs more than a quarter of the available memory"};
}

}  // namespace

const Operation& volumeRepairOperation() {
  static const Operation operation = {
      .id = "by-volume",
      .title = QT_TRANSLATE_NOOP("Tool", "Repair by volume"),
      .meaning =
          "Replace everything by the surface of the volume that is enclosed, which is closed and free of "
          "self-intersections",
      .parameters = {voxelParameter(), gapsParameter(), wallParameter(), consentParameter(), numbersParameter()}};
  return operation;
}

}  // namespace handwheel
