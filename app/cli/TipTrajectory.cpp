// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/TipTrajectory.h"

#include "base/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr std::array<std::string_view, 5> kNames{"t_s", "x_mm", "y_mm", "z_mm", "stroke"};
constexpr std::size_t kNeeded = 4;  // number of required columns
// An hour and a half at 1 kHz.
constexpr std::size_t kMostPoses = 5'000'000;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) text.remove_suffix(1);
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  return text;
}

// Removes the text before the next separator, and the separator, and returns that text.
std::string_view taken(std::string_view& text, char separator) {
  const std::size_t end = text.find(separator);
  const std::string_view first = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return trimmed(first);
}

class PathReader {
 public:
  explicit PathReader(StrokeColumn strokes) : m_read(strokes == StrokeColumn::Read ? kNames.size() : kNeeded) {}

  TipTrajectory read(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // some editors put it there
    while (!text.empty() && m_path.problem.empty()) {
      ++m_line;
      const std::string_view line = taken(text, '\n');
      if (line.empty() || line.front() == '#') continue;
      m_hasHeader ? readPose(line) : readHeader(line);
    }
    if (m_path.problem.empty() && m_path.poses.empty()) m_path.problem = "It has no line of numbers.";
    return std::move(m_path);
  }

 private:
  void refuse(const std::string& what) { m_path.problem = "Line " + std::to_string(m_line) + ": " + what; }

  void readHeader(std::string_view line) {
    m_columns.fill(kMissing);
    std::string_view rest = line;
    for (std::size_t column = 0; !rest.empty(); ++column) {
      const std::string_view name = taken(rest, ',');
      for (std::size_t k = 0; k < m_read; ++k) {
        if (name != kNames[k]) continue;
        if (m_columns[k] != kMissing) return refuse("There are two columns " + std::string(name) + ".");
        m_columns[k] = column;
      }
    }
    std::string missing;
    for (std::size_t k = 0; k < kNeeded; ++k) {
      if (m_columns[k] == kMissing) missing += (missing.empty() ? "" : ", ") + std::string(kNames[k]);
    }
    if (!missing.empty())
      refuse("The first line must name the columns t_s,x_mm,y_mm,z_mm; it does not have " + missing + ".");
    m_hasHeader = true;
  }

  void readPose(std::string_view line) {
    std::array<double, kNames.size()> values;
    values.fill(std::numeric_limits<double>::quiet_NaN());
    std::string_view rest = line;
    for (std::size_t column = 0; !rest.empty(); ++column) {
      const std::string_view word = taken(rest, ',');
      for (std::size_t k = 0; k < kNames.size(); ++k) {
        if (m_columns[k] != column) continue;
        ErrorCode why = ErrorCode::NumberMalformed;
        if (!parseDecimal(word, values[k], why) || !(std::abs(values[k]) < kLargest))
          return refuse("'" + std::string(word) + "' is not a number that can be used for " + std::string(kNames[k]) +
                        ". Write numbers as 12.5 or 1e-3, with commas between the columns only.");
      }
    }
    for (std::size_t k = 0; k < kNames.size(); ++k)
      if (std::isnan(values[k]) && m_columns[k] != kMissing)
        return refuse("The value for " + std::string(kNames[k]) + " is missing.");
    if (!m_path.poses.empty() && values[0] < m_path.poses.back().time) return refuse("The time must not decrease.");
    if (m_path.poses.size() == kMostPoses)
      return refuse("A path can have at most " + std::to_string(kMostPoses) + " lines.");
    if (m_columns[kNeeded] != kMissing) {
      const double stroke = values[kNeeded];
      if (!(stroke >= 0.0 && stroke <= kMostStrokes && stroke == std::floor(stroke)))
        return refuse("The number of a stroke is a whole one from 0, which is none, to " +
                      std::to_string(kMostStrokes) + ".");
      m_path.strokes.push_back(static_cast<std::uint32_t>(stroke));
    }
    HandPose pose;
    pose.time = values[0];
    pose.position = Vec3(values[1], values[2], values[3]);
    m_path.poses.push_back(pose);
  }

  static constexpr std::size_t kMissing = ~std::size_t{0};
  static constexpr int kMostStrokes = 1'000'000;
  static constexpr double kLargest = 1e100;  // squares of it are still numbers

  TipTrajectory m_path;
  std::array<std::size_t, kNames.size()> m_columns{};
  std::size_t m_read;  // number of kNames
  bool m_hasHeader = false;
  std::uint64_t m_line = 0;
};

}  // namespace

TipTrajectory readTipTrajectory(std::string_view text, StrokeColumn strokes) {
  return PathReader(strokes).read(text);
}

}  // namespace handwheel
