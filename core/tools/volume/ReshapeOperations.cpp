// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ReshapeOperations.h"

#include "tools/volume/VoxelizeOperations.h"
#include "volume/VolumeBoolean.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeFilters.h"
#include "volume/VolumeMemory.h"
#include "volume/VolumeOffset.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {
namespace {

constexpr double kLeastLength = 1e-9, kLargestLength = 1e6;  // mm
constexpr double kMostPasses = 50.0;                         // passes of smoothing; more would change the shape

Parameter sideParameter() {
  return {.property = {.id = "side",
                       .group = {},
                       .label = QT_TRANSLATE_NOOP("Property", "Wall"),
                       .value = 0.0,
                       .choices = {QT_TRANSLATE_NOOP("Property", "Inside the surface"),
                                   QT_TRANSLATE_NOOP("Property", "Outside the surface"),
                                   QT_TRANSLATE_NOOP("Property", "On both sides of it")}},  // in the order of WallSide
          .meaning = "Where the wall is: inside of the surface, outside, or with the surface in its middle",
          .word = "SIDE",
          .words = {"inside", "outside", "middle"}};
}

Result<SparseVolume> unlessEmpty(Result<SparseVolume> made, const Progress& progress) {
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (made && made->isEmpty()) return Error{VolumeErrors::NothingLeft, {}, {}, {}};
  return made;
}

}  // namespace

const Operation& booleanOperation() {
  static const Operation operation = {
      .id = "boolean",
      .title = QT_TRANSLATE_NOOP("Tool", "Combine volumes"),
      .meaning = "Unites, subtracts or intersects the material of two volumes",
      .parameters = {
          {.property = {.id = "how",
                        .group = {},
                        .label = QT_TRANSLATE_NOOP("Property", "Result"),
                        .value = 0.0,
                        .choices = {QT_TRANSLATE_NOOP("Property", "Unite"), QT_TRANSLATE_NOOP("Property", "Subtract"),
                                    QT_TRANSLATE_NOOP("Property", "Intersect")}},  // in the order of VolumeBoolean
           .meaning = "What is in either, in the first alone, or in both",
           .word = "HOW",
           .words = {"unite", "subtract", "intersect"}}}};
  return operation;
}

const Operation& shellOperation() {
  static const Operation operation = {
      .id = "shell",
      .title = QT_TRANSLATE_NOOP("Tool", "Make shell"),
      .meaning = "Leaves a wall along the surface of a volume",
      .parameters = {lengthParameter("wall", QT_TRANSLATE_NOOP("Property", "Wall thickness"),
                                     "Thickness of the wall; at least two voxels", kLeastLength, kLargestLength),
                     sideParameter()}};
  return operation;
}

const Operation& offsetOperation() {
  static const Operation operation = {
      .id = "offset",
      .title = QT_TRANSLATE_NOOP("Tool", "Move surface"),
      .meaning = "Moves the surface of a volume out or in",
      .parameters = {lengthParameter("distance", QT_TRANSLATE_NOOP("Property", "Distance"), "Outwards; below 0 inwards",
                                     -kLargestLength, kLargestLength)}};
  return operation;
}

const Operation& debrisOperation() {
  static const Operation operation = {
      .id = "debris",
      .title = QT_TRANSLATE_NOOP("Tool", "Remove debris"),
      .meaning = "Takes the small parts of a volume away",
      .parameters = {
          lengthParameter("below", QT_TRANSLATE_NOOP("Property", "Smaller than a ball of"),
                          "Take parts away that have less volume than a ball of this diameter; the largest part "
                          "stays",
                          kLeastLength, kLargestLength)}};
  return operation;
}

const Operation& gapsOperation() {
  static const Operation operation = {
      .id = "gaps",
      .title = QT_TRANSLATE_NOOP("Tool", "Close gaps"),
      .meaning = "Fills gaps, cracks and pits of a volume",
      .parameters = {lengthParameter("radius", QT_TRANSLATE_NOOP("Property", "Radius"),
                                     "Fill what a ball of this radius does not get into", kLeastLength,
                                     kLargestLength)}};
  return operation;
}

const Operation& smoothOperation() {
  static const Operation operation = {
      .id = "smooth",
      .title = QT_TRANSLATE_NOOP("Tool", "Smooth volume"),
      .meaning = "Takes small bumps and dents off the surface of a volume",
      .parameters = {{.property = {.id = "passes",
                                   .group = {},
                                   .label = QT_TRANSLATE_NOOP("Property", "Passes"),
                                   .value = 1.0,
                                   .least = 1.0,
                                   .largest = kMostPasses},
                      .meaning = "How often each depth becomes the mean of those around",
                      .word = "N",
                      .isWhole = true}}};
  return operation;
}

double diameterOf(std::uint64_t voxels, double voxel) {
  return voxel * std::cbrt(6.0 * static_cast<double>(voxels) / std::numbers::pi);
}

std::uint64_t voxelsOf(double diameter, double voxel) {
  constexpr double kMost = 1e18;  // more than any volume has
  const double share = diameter / voxel;
  return static_cast<std::uint64_t>(std::ceil(std::min(kMost, std::numbers::pi / 6.0 * share * share * share)));
}

std::size_t keptParts(const VolumeParts& parts, const OperationValues& values, double voxel) {
  const std::size_t kept = parts.countFrom(voxelsOf(values.number("below"), voxel));
  return std::min(parts.voxels().size(), std::max<std::size_t>(kept, 1));
}

Result<SparseVolume> makeShell(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  return unlessEmpty(shellOf(volume, values.number("wall"), static_cast<WallSide>(values.whole("side")), progress),
                     progress);
}

Result<SparseVolume> makeOffset(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  return unlessEmpty(movedSurface(volume, values.number("distance"), progress), progress);
}

Result<SparseVolume> makeBoolean(const SparseVolume& volume, const SparseVolume& other, const OperationValues& values,
                                 Progress progress) {
  return unlessEmpty(combined(volume, other, static_cast<VolumeBoolean>(values.whole("how")), progress), progress);
}

Result<SparseVolume> removeDebris(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  if (const auto error = VolumeParts::refusal(volume)) return *error;
  const VolumeParts parts(volume, progress.part(0.0, 0.5));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return unlessEmpty(parts.only(0, keptParts(parts, values, volume.voxel()), progress.part(0.5, 1.0)), progress);
}

Result<SparseVolume> closeGaps(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  return unlessEmpty(withoutGaps(volume, values.number("radius"), progress), progress);
}

Result<SparseVolume> smoothWhole(const SparseVolume& volume, const OperationValues& values, Progress progress) {
  SparseVolume smoothed = volume;
  const std::size_t passes = values.whole("passes");
  // A pass computes each block from the result of the previous pass.
  const double anew = static_cast<double>(std::min<std::size_t>(passes, 2) * volume.blockCount());
  if (const auto error = memoryRefusal(volume.voxel(), anew * (sizeof(VolumeBlock) + 64.0))) return *error;
  for (std::size_t i = 0; i < passes && !progress.cancelled(); ++i) {
    const auto at = [&](std::size_t done) { return static_cast<double>(done) / static_cast<double>(passes); };
    smooth(smoothed, progress.part(at(i), at(i + 1)));
  }
  return unlessEmpty(std::move(smoothed), progress);
}

}  // namespace handwheel
