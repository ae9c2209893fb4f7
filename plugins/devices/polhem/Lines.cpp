// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polhem/Lines.h"

#include "base/NumberText.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace handwheel::polhem {

namespace {

constexpr int kDrive = 2;          // the command that sets the force
constexpr double kFarthest = 1e3;  // mm; ten times its reach
// "% 8.3f % 8.3f % 8.3f % 7.4f % 7.4f % 7.4f % 7.4f %hd": columns of the decimal points, and of the last number. There
// is firmware that writes the first angle one column wider.
constexpr std::size_t kPositionPoints[] = {4, 13, 22};
constexpr std::size_t kAnglePoints[] = {29, 37, 45, 53};
constexpr std::size_t kLastNumber = 59;

// Returns the next word of a line, which is shortened by it; empty at its end.
std::string_view nextWord(std::string_view& line) {
  const std::size_t start = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t end = std::min(line.find(' ', start), line.size());
  const std::string_view word = line.substr(start, end - start);
  line.remove_prefix(end);
  return word;
}

bool isInColumns(std::string_view line, std::size_t wider) {
  const auto isPoint = [&](std::size_t column) { return line[column] == '.'; };
  const auto isAnglePoint = [&](std::size_t column) { return line[column + wider] == '.'; };
  return line.find_last_not_of(' ') + 1 > kLastNumber + wider &&  // false for an empty one, too: npos + 1 is 0
         std::all_of(std::begin(kPositionPoints), std::end(kPositionPoints), isPoint) && line[26] == ' ' &&
         std::all_of(std::begin(kAnglePoints), std::end(kAnglePoints), isAnglePoint);
}

int millinewtons(double newtons) {
  return std::isfinite(newtons) ? static_cast<int>(std::lround(std::clamp(newtons * 1e3, -32767.0, 32767.0))) : 0;
}

}  // namespace

Eigen::Quaterniond Reading::orientation() const {
  using Eigen::AngleAxisd;
  return (AngleAxisd(angles[0], Vec3::UnitZ()) * AngleAxisd(-angles[1], Vec3::UnitY()) *
          AngleAxisd(angles[2], Vec3::UnitX()) * AngleAxisd(angles[3], Vec3::UnitY()))
      .normalized();
}

Line forceLine(const Vec3& force) {
  Line line{};
  line.fill(' ');
  line.back() = '\n';
  char* at = reinterpret_cast<char*>(line.data());
  char* const end = at + kLineSize - 1;
  for (const int number :
       {millinewtons(force.x()), millinewtons(force.y()), millinewtons(force.z()), kDrive, 0, 0, 0}) {
    at = std::to_chars(at, end, number).ptr + 1;  // a blank follows; 29 bytes at most
  }
  return line;
}

std::optional<Reading> parseLine(std::string_view line) {
  if (!isInColumns(line, 0) && !isInColumns(line, 1)) return {};
  std::array<double, 8> numbers{};
  for (double& number : numbers) {
    ErrorCode ignored{};
    if (!parseDecimal(nextWord(line), number, ignored) || !std::isfinite(number)) return {};
  }
  if (!nextWord(line).empty()) return {};
  Reading reading;
  reading.position = Vec3(numbers[0], numbers[1], numbers[2]);
  if (reading.position.cwiseAbs().maxCoeff() > kFarthest) return {};
  std::copy_n(numbers.begin() + 3, 4, reading.angles.begin());
  return reading;
}

int LineReader::take(std::span<const std::uint8_t> bytes) {
  int readings = 0;
  for (const std::uint8_t byte : bytes) {
    if (byte != '\n') {
      m_tooLong |= m_filled == m_line.size();
      if (!m_tooLong) m_line[m_filled++] = byte;
      continue;
    }
    const std::string_view line(reinterpret_cast<const char*>(m_line.data()), m_filled);
    if (const std::optional<Reading> reading = m_tooLong ? std::nullopt : parseLine(line)) {
      m_reading = *reading;
      ++readings;
    }
    m_filled = 0;
    m_tooLong = false;
  }
  return readings;
}

}  // namespace handwheel::polhem
