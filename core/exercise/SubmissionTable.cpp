// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercise/SubmissionTable.h"

#include "base/NumberText.h"
#include "base/Translatable.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSecondsOfMinute = 60.0;

std::string csvField(std::string text, bool isNumber) {
  if (!isNumber && !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos)
    text.insert(text.begin(), '\'');
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

const char* wordOf(WorkOrigin origin) {
  switch (origin) {
    case WorkOrigin::Hand:
      return translatable("SubmissionTable", "by hand");
    case WorkOrigin::Program:
      return translatable("SubmissionTable", "by program");
    case WorkOrigin::Both:
      return translatable("SubmissionTable", "both");
    case WorkOrigin::Command:
      return translatable("SubmissionTable", "by command");
    case WorkOrigin::HandAndCommand:
      return translatable("SubmissionTable", "by hand and command");
    case WorkOrigin::ProgramAndCommand:
      return translatable("SubmissionTable", "by program and command");
    case WorkOrigin::All:
      return translatable("SubmissionTable", "by hand, program and command");
    case WorkOrigin::Unknown:
      break;
  }
  return "";
}

}  // namespace

SubmissionTable::SubmissionTable(const Exercise& exercise) : m_criteria(exercise.criteria) {}

std::string SubmissionTable::heading(std::size_t column) const {
  switch (column) {
    case Student:
      return translatable("SubmissionTable", "Student");
    case File:
      return translatable("SubmissionTable", "File");
    case HandedIn:
      return translatable("SubmissionTable", "Handed in");
    case Minutes:
      return translatable("SubmissionTable", "Minutes");
    case Hints:
      return translatable("SubmissionTable", "Hints");
    case Made:
      return translatable("SubmissionTable", "Made");
    case Tries:
      return translatable("SubmissionTable", "Tries");
    case Points:
      return translatable("SubmissionTable", "Points");
    case Percent:
      return translatable("SubmissionTable", "Percent");
    default:
      return m_criteria[column - FirstCriterion].name;
  }
}

std::optional<double> SubmissionTable::number(const SubmissionRow& row, std::size_t column) const {
  if (column == Minutes) return std::round(10.0 * row.attempt.seconds / kSecondsOfMinute) / 10.0;
  if (column == Hints) return static_cast<double>(row.attempt.hintCount());
  if (column == Tries) return row.tries ? std::optional(static_cast<double>(*row.tries)) : std::nullopt;
  if (!row.problem.empty()) return std::nullopt;
  if (column == Points) return row.marking.points;
  if (column == Percent && row.marking.of > 0.0) return std::round(1000.0 * row.marking.points / row.marking.of) / 10.0;
  if (column < FirstCriterion) return std::nullopt;
  const Mark* mark = row.marking.find(m_criteria[column - FirstCriterion].id);
  return mark ? std::optional(mark->points) : std::nullopt;
}

std::string SubmissionTable::cell(const SubmissionRow& row, std::size_t column) const {
  switch (column) {
    case Student:
      return row.attempt.student;
    case File:
      return row.file;
    case Made:
      return wordOf(row.origin);
    case HandedIn:
      return row.attempt.handedIn;
    default:
      break;
  }
  const std::optional<double> value = number(row, column);
  if (column == Points && !row.problem.empty()) return row.problem;
  return value ? roundedText(*value) : std::string();
}

std::string SubmissionTable::cell(std::size_t row, std::size_t column) const {
  return cell(m_rows[row], column);
}

void SubmissionTable::sort(std::size_t column, bool isDescending) {
  const auto isBefore = [&](const SubmissionRow& a, const SubmissionRow& b) {
    if (isNumber(column)) {
      const auto x = number(a, column), y = number(b, column);
      if (!x || !y) return x.has_value() && !y.has_value();
      return isDescending ? *x > *y : *x < *y;
    }
    const std::string x = cell(a, column), y = cell(b, column);
    if (x.empty() || y.empty()) return !x.empty() && y.empty();
    return isDescending ? x > y : x < y;
  };
  std::stable_sort(m_rows.begin(), m_rows.end(), isBefore);
}

std::string SubmissionTable::csv(std::string (*translated)(const std::string&)) const {
  std::string text = "\xEF\xBB\xBF";
  const auto words = [&](const std::string& name) { return translated ? translated(name) : name; };
  for (std::size_t column = 0; column < columns(); ++column) {
    std::string head = column < FirstCriterion ? words(heading(column)) : heading(column);
    if (column >= FirstCriterion) head += " (" + words(translatable("SubmissionTable", "points")) + ")";
    text += (column > 0 ? "," : "") + csvField(std::move(head), false);
  }
  text += "\r\n";
  for (const SubmissionRow& row : m_rows) {
    for (std::size_t column = 0; column < columns(); ++column) {
      const bool isPlain = isNumber(column) && row.problem.empty();
      const bool isWord = column == Made && row.origin != WorkOrigin::Unknown;
      const std::string field = cell(row, column);
      text += (column > 0 ? "," : "") + csvField(isWord ? words(field) : field, isPlain);
    }
    text += "\r\n";
  }
  return text;
}

}  // namespace handwheel
