// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/MarkingWords.h"

#include "base/NumberText.h"

namespace handwheel {

namespace {

std::string limitsOf(const MarkingCriterion& c) {
  if (c.lower && c.upper) return roundedText(*c.lower) + " … " + roundedText(*c.upper);
  if (c.upper) return "≤ " + roundedText(*c.upper);
  return c.lower ? "≥ " + roundedText(*c.lower) : std::string();
}

}  // namespace

std::string unitOf(const ClassReport& report, const MarkingCriterion& c) {
  const FigureType* type = figureType(report.figures, c.figure);
  return type ? type->unit : std::string();
}

std::string pointsText(const Marking& marking) {
  return roundedText(marking.points) + " of " + roundedText(marking.of) + " points";
}

std::vector<std::array<std::string, 5>> rowsOf(const ClassReport& report, const Marking& marking) {
  std::vector<std::array<std::string, 5>> rows;
  for (const Mark& mark : marking.marks) {
    const MarkingCriterion* c = report.exercise.find(mark.criterion);
    if (!c) continue;
    const std::string unit = unitOf(report, *c);
    const std::string remark = mark.remark.inEnglish();
    rows.push_back({c->name, limitsOf(*c) + (unit.empty() ? "" : " " + unit),
                    mark.value ? roundedText(*mark.value) : "–",
                    roundedText(mark.points) + " / " + roundedText(mark.of),
                    mark.reason.inEnglish() + (remark.empty() ? "" : " (" + remark + ")")});
  }
  return rows;
}

}  // namespace handwheel
