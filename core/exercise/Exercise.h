// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// A row of the marking scheme: a measured figure of the work and its limits. What can be measured, and in which unit,
// is defined by the kind of work (document/exercise/ExerciseSubject.h).
struct MarkingCriterion {
  std::string id;                                // unique in the exercise, of letters, digits, _ and -: "d1"
  std::string name;                              // in the teacher's words: "⌀20 h10, front"
  std::string figure;                            // what is measured: "diameter"
  std::vector<double> arguments = {};            // where it is measured; what they mean depends on the figure
  std::optional<double> nominal = {};            // of a drawing
  std::string tolerance = {};                    // as the drawing has it: "h10", "N7"; empty: the limits alone
  std::optional<double> lower = {}, upper = {};  // what is within them is right; none: no limit
  double points = 0.0;
  double slack = 0.0;       // how far beyond a limit the last point is lost, in proportion; 0: at once
  bool isHidden = false;    // not on the drawing: students do not see it before they are marked
  bool isDecisive = false;  // what does not meet it fails: no other criterion gives points then
  // What else the file has of it, for programs that know more: keys and values as the text of a JSON object; empty:
  // nothing. It goes back into files.
  std::string others = {};

  bool hasLimit() const { return lower || upper; }
};

// One step of the way that an exercise suggests.
struct ExerciseStep {
  std::string title, text;
  std::vector<std::string> hints = {};     // shown one after another, when the student asks
  std::vector<std::string> criteria = {};  // it is done once these are met; none: the student says so
  std::string others = {};                 // as those of a criterion
};

// A task with its steps and its marking scheme. It knows no machine and no part: what is prepared and measured depends
// on the kind of work. A value type.
struct Exercise {
  static constexpr std::size_t kMostCriteria = 500, kMostSteps = 200, kMostHints = 20, kMostArguments = 16;
  static constexpr std::size_t kLongestText = 20'000;  // bytes
  static constexpr double kMostPoints = 1e4, kLargestFigure = 1e9, kLongestTime = 1e6;

  std::string title, author, text;
  double allowedSeconds = 0.0;  // shown to the student; marked by a criterion only. 0: no limit
  std::vector<ExerciseStep> steps;
  std::vector<MarkingCriterion> criteria;

  double points() const;                                    // of all criteria
  const MarkingCriterion* find(std::string_view id) const;  // null when there is none
};

// How errors name a criterion: "criterion “⌀20 h10” (d1)".
std::string namedInErrors(const MarkingCriterion& criterion);

// The error ElementMalformed {where, what is wrong} for the first thing that an exercise must not have: an id twice, a
// number that is not finite or out of bounds, too many rows, limits that no figure meets.
Status checkExercise(const Exercise& exercise);

// The exercise without what would tell the answers: points, slack, hidden criteria, and what is not known.
Exercise withoutAnswers(Exercise exercise);
// Whether it holds no answers.
bool hasNoAnswers(const Exercise& exercise);

}  // namespace handwheel
