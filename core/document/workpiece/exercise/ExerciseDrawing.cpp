// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/ExerciseDrawing.h"

#include "base/NumberText.h"
#include "machining/force/WorkMaterials.h"
#include "machining/thread/ThreadDesignation.h"
#include "machining/thread/ThreadTolerance.h"

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

// The nominal size of a criterion, or the middle of its limits.
std::optional<double> sizeOf(const MarkingCriterion& c) {
  if (c.nominal) return c.nominal;
  if (c.lower && c.upper) return 0.5 * (*c.lower + *c.upper);
  return std::nullopt;
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
  const std::optional<double> size = sizeOf(c);
  if (known == kDrawnSizes.end() || !size || !c.hasLimit()) return std::nullopt;
  const bool isLength = known->second == Of::Length;
  const std::size_t first = isLength ? 1 : 0, second = isLength ? 3 : 1;  // heights of a length follow the radii
  if (c.arguments.size() <= second) return std::nullopt;
  return DrawnTolerance{known->second, *size, toleranceText(c, *size),
                        std::min(c.arguments[first], c.arguments[second]),
                        std::max(c.arguments[first], c.arguments[second])};
}

const MarkingCriterion* along(const Exercise& exercise, const char* figure, const MarkingCriterion& other) {
  const auto found = std::find_if(exercise.criteria.begin(), exercise.criteria.end(), [&](const MarkingCriterion& c) {
    return c.figure == figure && !c.isHidden && c.arguments == other.arguments;
  });
  return found == exercise.criteria.end() ? nullptr : &*found;
}

// A thread is asked for by its major diameter, and by its pitch along the same range.
std::optional<DrawnThread> threadOf(const Exercise& exercise, const TurningTask& task, const MarkingCriterion& major) {
  const MarkingCriterion* const pitch = along(exercise, "thread_pitch", major);
  const auto size = sizeOf(major), step = pitch ? sizeOf(*pitch) : std::nullopt;
  if (!size || !step || !(*step > 0.0) || major.arguments.size() < 2) return std::nullopt;
  ThreadCut cut;
  cut.pitch = *step;
  const double low = major.arguments[0], high = major.arguments[1];
  const auto extent = task.target->extentAt(0.5 * (low + high));
  const bool isInner = extent && 2.0 * extent->outer > *size + 2.0 * cut.pitch;
  DrawnThread thread;
  thread.isInner = isInner;
  thread.low = low;
  thread.high = high;
  thread.major = *size;
  thread.minor = *size - 2.0 * (isInner ? isoMetricInnerDepth(cut.pitch) : isoMetricDepth(cut.pitch));
  thread.designation = threadDesignation(cut, *size, isInner);
  // Only the class of "6g major diameter" and of "M20×2.5-6g".
  const auto tolerance = threadTolerance(major.tolerance);
  const std::string grade = tolerance ? tolerance->grade : major.tolerance.substr(0, major.tolerance.find(' '));
  if (!grade.empty()) thread.designation += " – " + grade;
  return thread;
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
    if (c.figure == "major_diameter" && task.target) {
      if (auto thread = threadOf(exercise, task, c)) title.threads.push_back(std::move(*thread));
    }
  }
  return title;
}

}  // namespace handwheel
