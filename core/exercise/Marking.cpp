// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercise/Marking.h"

#include "base/NumberText.h"
#include "base/Translatable.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace handwheel {

namespace {

// Sizes that differ by less are the same: of rounding, not of the work.
constexpr double kSameFigure = 1e-9;

double excessOf(const MarkingCriterion& c, double value) {
  if (std::isnan(value)) return value;
  double excess = 0.0;
  if (c.lower) excess = std::max(excess, *c.lower - value);
  if (c.upper) excess = std::max(excess, value - *c.upper);
  return excess <= kSameFigure ? 0.0 : excess;
}

double hundredths(double points) {
  return std::round(100.0 * points) / 100.0;
}

// Long times as clocks show them.
bool isClockTime(double value, const std::string& unit) {
  return unit == "s" && std::abs(value) >= 60.0;
}

// Returns a limit as the teacher has written it; for angles, which follow from sizes, with two decimals.
std::string limitNumber(double value, const std::string& unit) {
  return unit == "°" ? measuredText(value, unit) : roundedText(value);
}

std::string withUnit(double value, const std::string& unit) {
  return isClockTime(value, unit) ? minutesText(value) : limitNumber(value, unit) + unitAfter(unit);
}

std::string measuredWithUnit(double value, const std::string& unit) {
  return isClockTime(value, unit) ? minutesText(value) : measuredText(value, unit) + unitAfter(unit);
}

ExerciseText limitsText(const MarkingCriterion& c, const std::string& value, const std::string& unit) {
  if (c.lower && c.upper)
    return {translatable("Note", "%1 is within %2 and %3"),
            {value, unit == "s" ? withUnit(*c.lower, unit) : limitNumber(*c.lower, unit), withUnit(*c.upper, unit)}};
  if (c.upper) return {translatable("Note", "%1 is not above %2"), {value, withUnit(*c.upper, unit)}};
  if (c.lower) return {translatable("Note", "%1 is not below %2"), {value, withUnit(*c.lower, unit)}};
  return {translatable("Note", "%1, without a limit"), {value}};
}

// Points without a limit would be given for any work: that is an oversight.
bool lacksLimit(const MarkingCriterion& c) {
  return c.points > 0.0 && !c.hasLimit();
}

ExerciseText reasonFor(const MarkingCriterion& c, const Mark& mark, const std::string& unit) {
  if (lacksLimit(c)) return {translatable("Note", "the marking scheme has no limit for it")};
  if (mark.verdict == Verdict::NotMeasured) return {translatable("Note", "it could not be measured")};
  const std::string value = measuredWithUnit(*mark.value, unit);
  if (mark.verdict == Verdict::Met) return limitsText(c, value, unit);
  const bool isSmall = mark.verdict == Verdict::TooSmall;
  const double limit = isSmall ? *c.lower : *c.upper;
  const std::string beyond = measuredWithUnit(std::abs(*mark.value - limit), unit);
  return {isSmall ? translatable("Note", "%1 is %2 below the lower limit, %3")
                  : translatable("Note", "%1 is %2 above the upper limit, %3"),
          {value, beyond, withUnit(limit, unit)}};
}

Mark markFor(const MarkingCriterion& c, const Measurement* figure, const std::string& unit) {
  Mark mark;
  mark.criterion = c.id;
  mark.of = hundredths(c.points);
  if (figure) mark.remark = figure->remark;
  const bool isMeasured = figure && figure->value && std::isfinite(*figure->value);
  if (isMeasured && lacksLimit(c)) mark.value = figure->value;
  if (isMeasured && !lacksLimit(c)) {
    mark.value = figure->value;
    const bool isMet = excessOf(c, *mark.value) == 0.0;
    const bool isSmall = c.lower && *mark.value < *c.lower;
    mark.verdict = isMet ? Verdict::Met : isSmall ? Verdict::TooSmall : Verdict::TooLarge;
    mark.points = hundredths(c.points * earnedShare(c, *mark.value));
  }
  mark.reason = reasonFor(c, mark, unit);
  return mark;
}

// The figure of a criterion; null: there is none.
const Measurement* figureOf(const std::vector<Measurement>& figures, const std::string& criterion) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const Measurement& each) { return each.criterion == criterion; });
  return found == figures.end() ? nullptr : &*found;
}

// The criterion that the work fails by; null: by none.
const MarkingCriterion* failedBy(const Exercise& exercise, const Marking& marking,
                                 const std::vector<Measurement>& figures) {
  for (std::size_t i = 0; i < exercise.criteria.size(); ++i) {
    const MarkingCriterion& c = exercise.criteria[i];
    if (!c.isDecisive || marking.marks[i].verdict == Verdict::Met) continue;
    const Measurement* const figure = figureOf(figures, c.id);
    if (!figure || !figure->isOfEarlierTry) return &c;
  }
  return nullptr;
}

}  // namespace

std::string measuredText(double value, const std::string& unit) {
  // A micrometre of a length, a hundredth of a roughness, an angle or a power, whole newtons. Torque and heat are known
  // no better than forces.
  constexpr std::pair<std::string_view, double> kSteps[] = {{"mm", 1e-3}, {"µm", 1e-2},  {"°", 1e-2}, {"kW", 1e-2},
                                                            {"N", 1.0},   {"N·mm", 1.0}, {"K", 0.1},  {"s", 0.1}};
  constexpr int kDigits = 12;      // significant ones
  constexpr double kNoise = 1e-9;  // rounding of the computation, in any unit
  for (const auto& [name, step] : kSteps) {
    if (unit != name) continue;
    const double rounded = std::round(value / step) * step + 0.0;  // no -0
    if (rounded != 0.0 || std::abs(value) < kNoise) return roundedText(rounded, kDigits);
    const double digit = std::pow(10.0, std::floor(std::log10(std::abs(value))));
    return shownText(std::round(value / digit) * digit);
  }
  return roundedText(value);
}

std::string unitAfter(const std::string& unit) {
  return unit.empty() || unit == "°" ? unit : " " + unit;
}

std::string minutesText(double seconds) {
  const auto whole = std::lround(seconds);
  const std::string rest = std::to_string(whole % 60);
  return std::to_string(whole / 60) + ":" + (rest.size() < 2 ? "0" : "") + rest + " min";
}

std::string ExerciseText::inEnglish() const {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 1 < text.size() && isDigit(text[i + 1])) {
      const auto argument = static_cast<std::size_t>(text[++i] - '1');
      if (argument < arguments.size()) result += arguments[argument];
    } else {
      result += text[i];
    }
  }
  return result;
}

const Mark* Marking::find(std::string_view criterion) const {
  const auto found =
      std::find_if(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.criterion == criterion; });
  return found == marks.end() ? nullptr : &*found;
}

double earnedShare(const MarkingCriterion& criterion, double value) {
  const double excess = excessOf(criterion, value);
  if (excess == 0.0) return 1.0;
  if (!(criterion.slack > 0.0) || !(excess < criterion.slack)) return 0.0;
  return 1.0 - excess / criterion.slack;
}

Marking markMeasurements(const Exercise& exercise, const std::vector<Measurement>& figures,
                         const std::vector<std::string>& units) {
  Marking marking;
  for (std::size_t i = 0; i < exercise.criteria.size(); ++i) {
    const MarkingCriterion& c = exercise.criteria[i];
    const std::string unit = i < units.size() ? units[i] : std::string();
    marking.marks.push_back(markFor(c, figureOf(figures, c.id), unit));
    marking.of = hundredths(marking.of + marking.marks.back().of);
  }
  const MarkingCriterion* const failed = failedBy(exercise, marking, figures);
  for (Mark& mark : marking.marks) {
    if (failed && mark.points > 0.0 && mark.criterion != failed->id)
      mark.reason = {translatable("Note", "no points, because “%1” was not met"), {failed->name}};
    if (failed) mark.points = 0.0;
    marking.points = hundredths(marking.points + mark.points);
  }
  return marking;
}

}  // namespace handwheel
