// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Attempt.h"
#include "exercise/Marking.h"
#include "exercise/WorkOrigin.h"

namespace handwheel {

// One submission of a school class.
struct SubmissionRow {
  std::string file;  // name of the file
  Attempt attempt;
  Marking marking;
  WorkOrigin origin = WorkOrigin::Unknown;
  std::string problem = {};               // the reason why it was not marked; empty: it was marked
  std::vector<std::string> remarks = {};  // remarks on the file for the teacher
  std::optional<std::size_t> tries = {};  // number of tries; none: this kind of work does not count them
};

// The submissions of a class as one table. It has a row for each submission, and a column for each criterion.
class SubmissionTable {
 public:
  // The columns before those of the criteria, the most important ones first.
  enum Column : std::size_t { Student, Points, Percent, Minutes, Hints, Made, Tries, HandedIn, File, FirstCriterion };

  explicit SubmissionTable(const Exercise& exercise);

  void add(SubmissionRow row) { m_rows.push_back(std::move(row)); }
  const std::vector<SubmissionRow>& rows() const { return m_rows; }

  std::size_t columns() const { return m_criteria.size() + FirstCriterion; }
  // Returns the heading of a column in English, or the name of its criterion.
  std::string heading(std::size_t column) const;
  bool isNumber(std::size_t column) const {
    return column != Student && column != Made && column != HandedIn && column != File;
  }
  // Returns a cell as text. Numbers have a decimal point, and the origin of the work is in English. The text is empty
  // if there is no value.
  std::string cell(std::size_t row, std::size_t column) const;

  // Sorts the rows by a column. Numbers are sorted by value, and empty cells come last. Equal rows keep their order.
  void sort(std::size_t column, bool isDescending);

  // Returns the table as CSV according to RFC 4180 in UTF-8, with a byte order mark for spreadsheets and a header;
  // fields that a spreadsheet would take for a formula get an apostrophe in front. translated: a function that
  // translates the headings that are not names of criteria, and the origin of the work; null: they are in English.
  std::string csv(std::string (*translated)(const std::string&) = nullptr) const;

 private:
  std::optional<double> number(const SubmissionRow& row, std::size_t column) const;
  std::string cell(const SubmissionRow& row, std::size_t column) const;

  std::vector<MarkingCriterion> m_criteria;
  std::vector<SubmissionRow> m_rows;
};

}  // namespace handwheel
