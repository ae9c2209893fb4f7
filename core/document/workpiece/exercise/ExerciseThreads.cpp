// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/ExerciseThreads.h"

#include "document/workpiece/exercise/DrawingTolerance.h"
#include "machining/thread/ThreadDesignation.h"
#include "machining/thread/ThreadTolerance.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

constexpr double kPitchDiameterDepth = 0.6495190528;  // share of the pitch, (3/8)·√3: d − d2 (ISO 724)
constexpr double kLimitSlack = 1e-6;                  // mm, rounding of limits

bool overlap(const MarkingCriterion& a, const MarkingCriterion& b) {
  return a.arguments.size() >= 2 && b.arguments.size() >= 2 && a.arguments[0] < b.arguments[1] &&
         b.arguments[0] < a.arguments[1];
}

// The criteria of one thread.
struct AskedThread {
  std::vector<const MarkingCriterion*> criteria;
  std::optional<ThreadTolerance> tolerance;

  const MarkingCriterion* find(const char* figure) const {
    const auto found =
        std::find_if(criteria.begin(), criteria.end(), [&](const auto* c) { return c->figure == figure; });
    return found == criteria.end() ? nullptr : *found;
  }

  // Returns the nominal size of a figure, or the middle of its limits.
  std::optional<double> sizeOf(const char* figure) const {
    const MarkingCriterion* const c = find(figure);
    return c ? drawnSizeOf(*c) : std::nullopt;
  }

  std::string grade() const {
    if (tolerance) return tolerance->grade;
    for (const MarkingCriterion* const c : criteria)
      if (const auto grade = threadClassIn(c->tolerance); !grade.empty()) return std::string(grade);
    return {};
  }
};

std::vector<AskedThread> threadsIn(const Exercise& exercise) {
  std::vector<AskedThread> threads;
  for (const MarkingCriterion& c : exercise.criteria) {
    if (c.isHidden || !isOfThread(c) || c.arguments.size() < 2) continue;
    const auto tolerance = threadTolerance(c.tolerance);
    // A bush may have threads outside and inside at the same z.
    const auto same = std::find_if(threads.begin(), threads.end(), [&](const AskedThread& thread) {
      const bool isOtherSide = tolerance && thread.tolerance && tolerance->isInner != thread.tolerance->isInner;
      return !isOtherSide && std::any_of(thread.criteria.begin(), thread.criteria.end(),
                                         [&](const auto* other) { return overlap(*other, c); });
    });
    AskedThread& thread = same == threads.end() ? threads.emplace_back() : *same;
    thread.criteria.push_back(&c);
    if (!thread.tolerance) thread.tolerance = tolerance;
  }
  return threads;
}

// Returns the pitch by two diameters of a thread. The middle of limits is no nominal size.
std::optional<double> pitchBetween(double major, const AskedThread& thread) {
  const MarkingCriterion* const middle = thread.find("pitch_diameter");
  if (middle && middle->nominal) return (major - *middle->nominal) / kPitchDiameterDepth;
  const MarkingCriterion* const minor = thread.find("minor_diameter");
  if (minor && minor->nominal) return 0.5 * (major - *minor->nominal) / isoMetricDepth(1.0);
  return std::nullopt;
}

std::optional<DrawnThread> drawn(const AskedThread& thread, const TargetProfile& target) {
  DrawnThread drawn;
  drawn.low = thread.criteria.front()->arguments[0];
  drawn.high = thread.criteria.front()->arguments[1];
  for (const MarkingCriterion* const c : thread.criteria) {
    drawn.low = std::min(drawn.low, c->arguments[0]);
    drawn.high = std::max(drawn.high, c->arguments[1]);
  }
  const auto extent = target.extentAt(0.5 * (drawn.low + drawn.high));
  std::optional<double> pitch = thread.sizeOf("thread_pitch"), major = thread.sizeOf("major_diameter");
  if (thread.tolerance) {
    pitch = thread.tolerance->pitch.nominal;
    major = thread.tolerance->major.nominal;
  }
  if (extent && !major && !(extent->inner > 0.0)) major = 2.0 * extent->outer;
  if (major && !pitch) pitch = pitchBetween(*major, thread);
  if (!major || !pitch || !(*pitch > 0.0) || !(*major > 2.0 * *pitch)) return std::nullopt;
  ThreadCut cut;
  cut.pitch = *pitch;
  drawn.isInner = thread.tolerance ? thread.tolerance->isInner : extent && 2.0 * extent->outer > *major + 2.0 * *pitch;
  drawn.major = *major;
  drawn.minor = *major - 2.0 * (drawn.isInner ? isoMetricInnerDepth(*pitch) : isoMetricDepth(*pitch));
  drawn.designation = threadDesignation(cut, *major, drawn.isInner);
  if (const std::string grade = thread.grade(); !grade.empty()) drawn.designation += " – " + grade;
  return drawn;
}

// Returns the size of a thread that a criterion limits.
const ToleratedSize* sizeIn(const ThreadTolerance& thread, const MarkingCriterion& c) {
  if (c.figure == "thread_pitch") return &thread.pitch;
  if (c.figure == "pitch_diameter") return &thread.pitchDiameter;
  if (c.figure == "major_diameter" || (c.figure == "diameter" && !thread.isInner)) return &thread.major;
  if (c.figure == "minor_diameter" || (c.figure == "bore" && thread.isInner)) return &thread.minor;
  return nullptr;
}

// Returns true if the limits of a criterion admit a size that the class refuses.
bool exceeds(const MarkingCriterion& c, const ToleratedSize& size) {
  const bool isBelow = size.lower && (!c.lower || *c.lower < *size.lower - kLimitSlack);
  const bool isAbove = size.upper && (!c.upper || *c.upper > *size.upper + kLimitSlack);
  return c.hasLimit() && (isBelow || isAbove);
}

}  // namespace

std::vector<DrawnThread> threadsAskedFor(const Exercise& exercise, const TurningTask& task) {
  std::vector<DrawnThread> all;
  if (!task.target) return all;
  for (const AskedThread& thread : threadsIn(exercise))
    if (auto found = drawn(thread, *task.target)) all.push_back(std::move(*found));
  return all;
}

std::string threadConflict(const MarkingCriterion& criterion, const Exercise& exercise) {
  for (const MarkingCriterion& other : exercise.criteria) {
    if (!isOfThread(other) || !overlap(other, criterion)) continue;
    const auto thread = threadTolerance(other.tolerance);
    const ToleratedSize* const size = thread ? sizeIn(*thread, criterion) : nullptr;
    if (size && exceeds(criterion, *size))
      return QT_TRANSLATE_NOOP("Property",
                               "the limits contradict the class of the thread there: they admit sizes that it refuses");
  }
  return {};
}

}  // namespace handwheel
