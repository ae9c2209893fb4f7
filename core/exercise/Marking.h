// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Exercise.h"

namespace handwheel {

// A translatable English text with %1, %2… for its arguments. It is translated on display (context "Note").
struct ExerciseText {
  std::string text;
  std::vector<std::string> arguments = {};

  std::string inEnglish() const;
  bool operator==(const ExerciseText&) const = default;
};

// A figure that was measured for a criterion.
struct Measurement {
  std::string criterion;        // id of the criterion
  std::optional<double> value;  // in the unit of the figure; none: it could not be measured
  ExerciseText remark = {};     // the position of the measurement, or the reason why there is none
  // The value is of an earlier try, which was undone: it costs this criterion its points, but does not fail the others.
  bool isOfEarlierTry = false;
};

enum class Verdict { Met, TooSmall, TooLarge, NotMeasured };

// The result of a criterion, with its reason.
struct Mark {
  std::string criterion;
  Verdict verdict = Verdict::NotMeasured;
  std::optional<double> value;
  double points = 0.0, of = 0.0;  // multiples of 0.01
  ExerciseText reason;
  ExerciseText remark;  // remark of the measurement
};

// The marks for one student's work, in the order of the scheme.
struct Marking {
  std::vector<Mark> marks;
  double points = 0.0, of = 0.0;
  const Mark* find(std::string_view criterion) const;  // null: there is none
};

// Marks figures by a scheme. Deterministic: the same figures give the same marks. Criteria without a figure count as
// not measured, and so do those with points and without a limit. units: units of the figures for the reasons, in the
// order of the criteria; may be shorter.
Marking markMeasurements(const Exercise& exercise, const std::vector<Measurement>& figures,
                         const std::vector<std::string>& units = {});

// Returns a measured figure with as many digits as are significant in its unit: mm to a micrometre, µm to a hundredth.
std::string measuredText(double value, const std::string& unit);

// Returns the suffix of a number in this unit: " mm", or "°". A space precedes each unit but the degree sign (ISO
// 80000-1).
std::string unitAfter(const std::string& unit);

// "4:05 min"
std::string minutesText(double seconds);

// Returns the share of its points that a value earns: 1 within the limits, falling to 0 over the slack beyond them. 0
// for NaN.
double earnedShare(const MarkingCriterion& criterion, double value);

}  // namespace handwheel
