// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForceCsv.h"

#include "base/NumberText.h"
#include "machining/force/CsvLine.h"
#include "machining/force/ForceErrors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace handwheel {

namespace {

using ColumnNames = std::vector<std::string_view>;

constexpr double kLeastValue = 1e-9, kLargestValue = 1e9;

std::string loweredName(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

// Index of a column that is missing in a line.
constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);

struct ForceColumns {
  std::size_t depth = kNoColumn, feed = kNoColumn, speed = kNoColumn, force = kNoColumn, wear = kNoColumn;
  bool isArea = false;     // the depth column contains depth times feed, mm²
  bool isSpindle = false;  // the speed column contains r/min
};

class ForceHeader {
 public:
  explicit ForceHeader(std::string_view line) {
    if (line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);  // byte order mark
    splitCsvLine(line, kMostForceColumns, m_names);
    for (const std::string& name : m_names) m_lowered.push_back(loweredName(name));
  }

  // Returns the column with the first of these names in exact case, else in any case: a table may have feed and F, a
  // force.
  std::size_t column(const ColumnNames& names) const {
    for (const std::string_view name : names)
      if (const std::size_t at = columnIn(m_names, name); at != kNoColumn) return at;
    for (const std::string_view name : names)
      if (const std::size_t at = columnIn(m_lowered, loweredName(name)); at != kNoColumn) return at;
    return kNoColumn;
  }
  bool has(std::string_view name) const { return column({name}) != kNoColumn; }

  // Returns the column with the first of these names.
  Result<std::size_t> find(const char* quantity, const ColumnNames& names) const {
    if (const std::size_t at = column(names); at != kNoColumn) {
      if (std::count(m_names.begin(), m_names.end(), m_names[at]) > 1)
        return Error{ForceErrors::ColumnTwice, {quantity}, InputPosition::line(1), {}};
      return at;
    }
    std::string list;
    for (const std::string_view name : names) list += (list.empty() ? "" : ", ") + std::string(name);
    return Error{ForceErrors::ColumnMissing, {quantity, list}, InputPosition::line(1), {}};
  }

 private:
  static std::size_t columnIn(const std::vector<std::string>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? kNoColumn : static_cast<std::size_t>(found - names.begin());
  }

  std::vector<std::string> m_names, m_lowered;
};

Result<ForceColumns> forceColumnsIn(std::string_view line, double diameter) {
  const ForceHeader header(line);
  ForceColumns columns;
  const ColumnNames depths{"ap", "depth", "a", "A_cal", "A0"}, feeds{"f_cal", "f", "feed"}, speeds{"vc", "v", "speed"};
  const ColumnNames forces = header.has("ap") ? ColumnNames{"Fc", "Fx"} : ColumnNames{"Fc", "Fz"};
  const Result<std::size_t> depth = header.find("depth of cut", depths), feed = header.find("feed", feeds),
                            force = header.find("cutting force", forces);
  Result<std::size_t> speed = header.find("cutting speed", speeds);
  columns.isSpindle = !speed && header.has("rpm");
  if (columns.isSpindle) speed = header.find("spindle speed", {"rpm"});
  for (const Result<std::size_t>* found : {&depth, &feed, &force, &std::as_const(speed)})
    if (!*found) return found->error();
  if (columns.isSpindle && !(diameter > 0.0)) return Error{ForceErrors::DiameterNeeded, {}, InputPosition::line(1), {}};
  columns.depth = *depth;
  columns.feed = *feed;
  columns.force = *force;
  columns.speed = *speed;
  columns.wear = header.column({"TCond", "VB"});
  columns.isArea = columns.depth == header.column({"A_cal"}) || columns.depth == header.column({"A0"});
  return columns;
}

// Returns a number of a row; NaN if it is marked as missing.
Result<double> forceNumberIn(const std::vector<std::string>& fields, std::size_t column, double least) {
  const std::string word = column < fields.size() ? fields[column] : "";
  if (word.empty() || loweredName(word) == "na" || loweredName(word) == "nan") return std::nan("");
  double value = 0.0;
  ErrorCode why;
  if (!parseDecimal(word, value, why)) return Error{why, {word}, {}, {}};
  if (!std::isfinite(value)) return Error{ErrorCode::NumberNotFinite, {word}, {}, {}};
  if (value < least || value > kLargestValue)
    return Error{
        ErrorCode::ValueOutOfRange, {"the value", word, shortestText(least), shortestText(kLargestValue)}, {}, {}};
  return value;
}

// Returns the values of one row: the depth (or area), feed, speed (or r/min), force and wear.
Result<std::array<double, 5>> forceValuesIn(const std::vector<std::string>& fields, const ForceColumns& columns) {
  const std::array indices{columns.depth, columns.feed, columns.speed, columns.force, columns.wear};
  std::array<double, 5> values{};
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] == kNoColumn) continue;
    const Result<double> value = forceNumberIn(fields, indices[i], i + 1 < indices.size() ? kLeastValue : 0.0);
    if (!value) return value.error();
    values[i] = *value;
  }
  return values;
}

}  // namespace

Result<ForceSamples> forceSamplesFromCsv(std::string_view text, double diameter, Progress progress) {
  constexpr std::size_t kLook = 1'000;  // rows between two checks of the cancel flag
  const std::size_t length = text.size();
  if (text.find_first_not_of(" \r\n") == text.npos) return Error{ErrorCode::FileEmpty, {}, {}, {}};
  const Result<ForceColumns> columns = forceColumnsIn(takeLine(text), diameter);
  if (!columns) return columns.error();
  ForceSamples table;
  std::set<std::array<double, 4>> known;
  std::vector<std::string> fields;
  for (std::uint64_t line = 2; !text.empty(); ++line) {
    if (line % kLook == 0) {
      if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
      progress.set(1.0 - static_cast<double>(text.size()) / static_cast<double>(length));
    }
    const std::string_view row = takeLine(text);
    if (row.find_first_not_of(' ') == row.npos) continue;
    if (++table.rows > kMostForceRows)
      return Error{ErrorCode::FileTooLarge, {"rows", {}, std::to_string(kMostForceRows)}, {}, {}};
    splitCsvLine(row, kMostForceColumns, fields);
    const Result<std::array<double, 5>> values = forceValuesIn(fields, *columns);
    if (!values) {
      Error error = values.error();
      error.position = InputPosition::line(line);
      return error;
    }
    auto [depth, feed, speed, force, wear] = *values;
    if (std::isnan(depth + feed + speed + force + wear)) {
      ++table.gapRows;
    } else if (wear > 0.0) {
      ++table.wornRows;
    } else {
      if (columns->isArea) depth /= feed;
      if (columns->isSpindle) speed = surfaceSpeed(speed, diameter);
      if (known.insert({depth, feed, speed, force}).second) table.samples.push_back({{depth, feed, speed}, force});
    }
  }
  return table;
}

}  // namespace handwheel
