// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/exercise/MarkingWords.h"

#include "base/NumberText.h"
#include "text/NoteText.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

namespace handwheel {

namespace {

// Those of an angle follow from sizes: they have as many decimals as what is measured.
std::string limitsOf(const MarkingCriterion& c, const std::string& unit) {
  const auto text = [&](double limit) { return unit == "°" ? measuredText(limit, unit) : roundedText(limit); };
  if (c.lower && c.upper) return text(*c.lower) + " … " + text(*c.upper);
  if (c.upper) return "≤ " + text(*c.upper);
  return c.lower ? "≥ " + text(*c.lower) : std::string();
}

}  // namespace

std::string unitOf(const SubmissionsReport& report, const MarkingCriterion& c) {
  const MeasurementType* type = measurementType(report.figures, c.figure);
  return type ? type->unit : std::string();
}

std::string pointsText(const Marking& marking) {
  if (marking.of == 1.0)
    return translatedText({QT_TRANSLATE_NOOP("Note", "%1 of 1 point"), {roundedText(marking.points)}});
  return translatedText(
      {QT_TRANSLATE_NOOP("Note", "%1 of %2 points"), {roundedText(marking.points), roundedText(marking.of)}});
}

std::string translatedText(const ExerciseText& text) {
  return noteText({text.text, text.arguments}).toStdString();
}

std::string translatedHeading(const std::string& heading) {
  return QCoreApplication::translate("SubmissionTable", heading.c_str()).toStdString();
}

std::string momentOf(const ReportEvent& event) {
  return event.seconds ? minutesText(*event.seconds) + ": " : std::string();
}

std::string localTime(const std::string& utc) {
  const QDateTime at = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
  return at.isValid() ? QLocale().toString(at.toLocalTime(), QLocale::ShortFormat).toStdString() : utc;
}

std::vector<std::array<std::string, 5>> rowsOf(const SubmissionsReport& report, const Marking& marking) {
  std::vector<std::array<std::string, 5>> rows;
  for (const Mark& mark : marking.marks) {
    const MarkingCriterion* c = report.exercise.find(mark.criterion);
    if (!c) continue;
    const std::string symbol = unitOf(report, *c), unit = unitAfter(symbol);
    const std::string remark = mark.remark.text.empty() ? std::string() : translatedText(mark.remark);
    rows.push_back({c->name, c->hasLimit() ? limitsOf(*c, symbol) + unit : std::string(),
                    mark.value ? measuredText(*mark.value, symbol) + unit : "–",
                    roundedText(mark.points) + " / " + roundedText(mark.of),
                    translatedText(mark.reason) + (remark.empty() ? "" : " (" + remark + ")")});
  }
  return rows;
}

}  // namespace handwheel
