// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// A row of the marking scheme. It has a measured figure of the work and the limits of the figure. The kind of work
// (document/exercise/ExerciseSubject.h) defines the figures and their units.
struct MarkingCriterion {
  std::string id;                                // unique in the exercise; letters, digits, _ and -: "d1"
  std::string name;                              // name in the teacher's words: "⌀20 h10, front"
  std::string figure;                            // id of the measured figure: "diameter"
  std::vector<double> arguments = {};            // positions to measure at; their meaning depends on the figure
  std::optional<double> nominal = {};            // nominal size on the drawing
  std::string tolerance = {};                    // tolerance on the drawing: "h10", "N7"; empty: only the limits
  std::optional<double> lower = {}, upper = {};  // limits, inclusive; none: no limit
  double points = 0.0;
  double slack = 0.0;       // distance beyond a limit over which the points fall to 0 linearly; 0: they fall at once
  bool isHidden = false;    // true: not on the drawing; students see it only after marking
  bool isDecisive = false;  // true: if this criterion is not met, no other criterion gives points
  // Unknown keys of the file as the text of a JSON object, to be written back; empty: no keys.
  std::string others = {};

  bool hasLimit() const { return lower || upper; }
};

// One step of the procedure that an exercise suggests.
struct ExerciseStep {
  std::string title, text;
  std::vector<std::string> hints = {};     // shown one after another, when the student asks
  std::vector<std::string> criteria = {};  // criteria that complete the step; empty: the student ticks it
  std::string others = {};                 // unknown keys, as in MarkingCriterion
};

// A task with its steps and its marking scheme. It contains no machine and no part, which the kind of work prepares and
// measures. It is a value type.
struct Exercise {
  static constexpr std::size_t kMostCriteria = 500, kMostSteps = 200, kMostHints = 20, kMostArguments = 16;
  static constexpr std::size_t kLongestText = 20'000;  // bytes
  static constexpr double kMostPoints = 1e4, kLargestFigure = 1e9, kLongestTime = 1e6;

  std::string title, author, text;
  double allowedSeconds = 0.0;  // shown to the student; only a criterion can take points for a longer time; 0: no limit
  std::vector<ExerciseStep> steps;
  std::vector<MarkingCriterion> criteria;

  double points() const;                                    // sum over all criteria
  const MarkingCriterion* find(std::string_view id) const;  // null: there is none
};

// Returns the name of a criterion for errors, such as "criterion “⌀20 h10” (d1)".
std::string namedInErrors(const MarkingCriterion& criterion);

// Returns the error ElementMalformed {where, what is wrong} for the first invalid value of an exercise. Invalid are
// duplicate ids, numbers that are not finite or out of bounds, too many rows, and limits that no figure can meet.
Status checkExercise(const Exercise& exercise);

// Returns the exercise without anything that would reveal the answers: points, slack, hidden criteria, and unknown
// keys.
Exercise withoutAnswers(Exercise exercise);
// Returns true if an exercise has no answers.
bool hasNoAnswers(const Exercise& exercise);

}  // namespace handwheel
