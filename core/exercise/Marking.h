// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Exercise.h"

namespace handwheel {

// A translatable English text with %1, %2… for its arguments. It is translated where it is shown (context "Note").
struct ExerciseText {
  std::string text;
  std::vector<std::string> arguments = {};

  std::string inEnglish() const;
  bool operator==(const ExerciseText&) const = default;
};

// A figure that was measured for a criterion.
struct Measurement {
  std::string criterion;        // its id
  std::optional<double> value;  // in the unit of the figure; none: it could not be measured
  ExerciseText remark = {};     // where that was, or why there is none
  // It was so in an earlier try, which was taken back: it costs this criterion, and fails no other.
  bool isOfEarlierTry = false;
};

enum class Verdict { Met, TooSmall, TooLarge, NotMeasured };

// What a criterion gave, with its reason.
struct Mark {
  std::string criterion;
  Verdict verdict = Verdict::NotMeasured;
  std::optional<double> value;
  double points = 0.0, of = 0.0;  // hundredths exactly
  ExerciseText reason;
  ExerciseText remark;  // of the figure
};

// The marks for one student's work, in the order of the scheme.
struct Marking {
  std::vector<Mark> marks;
  double points = 0.0, of = 0.0;
  const Mark* find(std::string_view criterion) const;  // null when there is none
};

// Marks figures by a scheme. Deterministic: the same figures give the same marks. Criteria without a figure count as
// not measured, and so do those with points and without a limit. units: of the figures, by criterion in the same order,
// for the reasons; may be shorter.
Marking markMeasurements(const Exercise& exercise, const std::vector<Measurement>& figures,
                         const std::vector<std::string>& units = {});

// A measured figure to as many digits as mean something in its unit: mm to a micrometre, µm to a hundredth.
std::string measuredText(double value, const std::string& unit);

// " mm", or "°": what follows a number of this unit. A space comes before each but the sign of a degree (ISO 80000-1).
std::string unitAfter(const std::string& unit);

// "4:05 min"
std::string minutesText(double seconds);

// The share of its points that a value earns: 1 within the limits, falling to 0 over the slack beyond them. 0 for NaN.
double earnedShare(const MarkingCriterion& criterion, double value);

}  // namespace handwheel
