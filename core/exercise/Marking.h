// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Exercise.h"

namespace handwheel {

// A translatable English text with %1, %2… for its arguments. It is translated in the context "Note" when it is
// displayed.
struct ExerciseText {
  std::string text;
  std::vector<std::string> arguments = {};

  std::string inEnglish() const;
  bool operator==(const ExerciseText&) const = default;
};

// A figure that was measured for a criterion.
struct Measurement {
  std::string criterion;        // id of the criterion
  std::optional<double> value;  // in the unit of the figure; none: the figure could not be measured
  ExerciseText remark = {};     // the position of the measurement, or the reason why there is none
  // True: the value is of an earlier try that was undone. It costs this criterion its points but does not fail the
  // other criteria.
  bool isOfEarlierTry = false;
};

enum class Verdict { Met, TooSmall, TooLarge, NotMeasured };

// The result of a criterion, with its reason.
struct Mark {
  std::string criterion;
  Verdict verdict = Verdict::NotMeasured;
  std::optional<double> value;
  double points = 0.0, of = 0.0;  // earned and possible points; multiples of 0.01
  ExerciseText reason;
  ExerciseText remark;  // remark of the measurement
};

// The marks for one student's work, in the order of the scheme.
struct Marking {
  std::vector<Mark> marks;
  double points = 0.0, of = 0.0;
  const Mark* find(std::string_view criterion) const;  // null: there is none
};

// Marks figures by a scheme. The same figures always give the same marks. Criteria without a figure count as not
// measured, and so do those with points and without a limit. units: the units of the figures for the reasons, in the
// order of the criteria; the list may be shorter.
Marking markMeasurements(const Exercise& exercise, const std::vector<Measurement>& figures,
                         const std::vector<std::string>& units = {});

// Returns a measured figure with as many digits as are significant in its unit. Values in mm are rounded to a
// micrometre, values in µm to a hundredth.
std::string measuredText(double value, const std::string& unit);

// Returns the suffix of a number in a unit: " mm", or "°". A space precedes each unit but the degree sign (ISO
// 80000-1).
std::string unitAfter(const std::string& unit);

// Returns a time in minutes and seconds: "4:05 min".
std::string minutesText(double seconds);

// Returns the fraction of a criterion's points that a value earns. It is 1 within the limits and falls to 0 over the
// slack beyond them. It is 0 for NaN.
double earnedShare(const MarkingCriterion& criterion, double value);

}  // namespace handwheel
