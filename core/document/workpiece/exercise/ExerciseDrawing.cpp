// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/ExerciseDrawing.h"

#include "base/NumberText.h"
#include "document/workpiece/exercise/DrawingTolerance.h"
#include "document/workpiece/exercise/ExerciseThreads.h"
#include "machining/force/WorkMaterials.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

using Of = DrawnTolerance::Of;

std::string drawnSizeText(double value) {
  return roundedText(std::round(value * 1e3) / 1e3, 9);
}

std::string signedText(double deviation) {
  return deviation > 0.0 ? "+" + drawnSizeText(deviation) : drawnSizeText(deviation);
}

// Returns the tolerance as the teacher wrote it, else the deviations: "±0.1", "+0.1 −0.2".
std::string toleranceText(const MarkingCriterion& c, double size) {
  if (!c.tolerance.empty()) return c.tolerance;
  if (c.lower && c.upper && std::abs(*c.lower + *c.upper - 2.0 * size) < 1e-9)
    return "±" + drawnSizeText(*c.upper - size);
  std::string text;
  if (c.upper) text = signedText(*c.upper - size);
  if (c.lower) text += (text.empty() ? "" : " ") + signedText(*c.lower - size);
  return text;
}

std::optional<DrawnTolerance> toleranceOf(const MarkingCriterion& c) {
  static constexpr std::array<std::pair<const char*, Of>, 6> kDrawnSizes{{{"diameter", Of::Diameter},
                                                                          {"bore", Of::Bore},
                                                                          {"length", Of::Length},
                                                                          {"depth", Of::Length},
                                                                          {"arc", Of::Radius},
                                                                          {"bore_arc", Of::Radius}}};
  const auto known =
      std::find_if(kDrawnSizes.begin(), kDrawnSizes.end(), [&](const auto& each) { return c.figure == each.first; });
  const std::optional<double> size = drawnSizeOf(c);
  if (known == kDrawnSizes.end() || !size || !c.hasLimit()) return std::nullopt;
  const bool isLength = known->second == Of::Length;
  const std::size_t first = isLength ? 1 : 0, second = isLength ? 3 : 1;  // heights of a length follow the radii
  if (c.arguments.size() <= second) return std::nullopt;
  return DrawnTolerance{known->second, *size, toleranceText(c, *size),
                        std::min(c.arguments[first], c.arguments[second]),
                        std::max(c.arguments[first], c.arguments[second])};
}

}  // namespace

DrawingTitle drawingTitleOf(const Exercise& exercise, const TurningTask& task) {
  DrawingTitle title;
  title.name = exercise.title;
  const WorkMaterials& materials = WorkMaterials::standard();
  if (const WorkMaterial* const material = materials.find(task.material)) title.material = material->name;
  for (const MarkingCriterion& c : exercise.criteria) {
    if (c.isHidden) continue;
    if (auto tolerance = toleranceOf(c)) title.tolerances.push_back(std::move(*tolerance));
    const bool isInner = c.figure == "bore_roughness";
    if ((c.figure == "roughness" || isInner) && c.upper && c.arguments.size() >= 2)
      title.roughness.push_back({*c.upper, c.arguments[0], c.arguments[1], isInner});
  }
  title.threads = threadsAskedFor(exercise, task);
  return title;
}

}  // namespace handwheel
