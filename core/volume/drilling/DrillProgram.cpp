// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillProgram.h"

#include "volume/VolumeErrors.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <string>

namespace handwheel {
namespace {

struct Word {
  char letter;
  double value;
  std::string text;  // text in the program
};

constexpr double kLargestNumber = 1e6;  // mm, s, mm/min, of any number

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

// A line without its comments: from ; on, and in parentheses. None where a parenthesis does not end.
std::optional<std::string> withoutComments(std::string_view line) {
  std::string left;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ';') break;
    if (line[i] == '(') {
      i = line.find(')', i);
      if (i == std::string_view::npos) return std::nullopt;
      continue;
    }
    left += line[i];
  }
  return left;
}

// The interpreter of a program, word by word.
class Reader {
 public:
  Result<DrillProgram> read(std::string_view text) {
    for (std::size_t from = 0; from < text.size() && !m_isOver;) {
      const std::size_t end = std::min(text.find('\n', from), text.size());
      ++m_line;
      if (const auto error = readLine(text.substr(from, end - from))) return *error;
      from = end + 1;
    }
    if (m_program.waypoints.empty()) return Error{VolumeErrors::ProgramMovesNothing, {}, {}, {}};
    return std::move(m_program);
  }

 private:
  using MaybeError = std::optional<Error>;

  Error at(ErrorCode code, std::vector<std::string> arguments) const {
    return {code, std::move(arguments), InputPosition::line(m_line), {}};
  }

  MaybeError readLine(std::string_view line) {
    const std::optional<std::string> left = withoutComments(line);
    if (!left) return at(VolumeErrors::ProgramWord, {"("});
    std::vector<Word> words;
    for (std::size_t i = 0; i < left->size();) {
      if (isSpace((*left)[i])) {
        ++i;
        continue;
      }
      if ((*left)[i] == '%' && words.empty()) return std::nullopt;  // the mark of the beginning and the end
      std::size_t end = i + 1;
      while (end < left->size() && (isSpace((*left)[end]) || std::isdigit(static_cast<unsigned char>((*left)[end])) ||
                                    std::string_view("+-.").find((*left)[end]) != std::string_view::npos))
        ++end;
      std::string word = left->substr(i, end - i);
      std::erase_if(word, isSpace);
      const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
      if (letter < 'A' || letter > 'Z') return at(VolumeErrors::ProgramWord, {word});
      double value = 0.0;
      const char* const first = word.data() + (word.size() > 1 && word[1] == '+' ? 2 : 1);
      const auto [last, problem] = std::from_chars(first, word.data() + word.size(), value);
      if (problem != std::errc() || last != word.data() + word.size() || !(std::abs(value) <= kLargestNumber))
        return at(ErrorCode::NumberMalformed, {word});
      words.push_back({letter, value, word});
      i = end;
    }
    return run(words);
  }

  // In the order in which RS274/NGC does it: feed and speed first, then what holds, then motion.
  MaybeError run(const std::vector<Word>& words) {
    std::map<char, double> values;
    bool isDwell = false;
    for (const Word& word : words) {
      if (word.letter == 'G') {
        if (word.value == 4.0) isDwell = true;
        if (!takeMode(word.value)) return at(VolumeErrors::ProgramWord, {word.text});
      } else if (word.letter == 'M') {
        if (word.value == 2.0 || word.value == 30.0)
          m_isOver = true;
        else if (word.value != 3.0 && word.value != 5.0)
          return at(VolumeErrors::ProgramWord, {word.text});
      } else if (std::string_view("XYZRQPFSN").find(word.letter) == std::string_view::npos ||
                 !values.emplace(word.letter, word.value).second) {
        return at(VolumeErrors::ProgramWord, {word.text});
      }
    }
    if (const auto error = takeSpeeds(values)) return error;
    if (isDwell) return dwell(values);
    const bool isMove = values.contains('X') || values.contains('Y') || values.contains('Z');
    if (!isMove) return std::nullopt;
    Vec3 to = m_at;
    std::array<bool, 3> isNamed{};
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto found = values.find("XYZ"[k]); found != values.end()) {
        to[static_cast<Eigen::Index>(k)] = found->second;
        isNamed[k] = true;
      }
    if (m_mode == 0.0 || m_mode == 1.0) return line(to, isNamed);
    if (m_mode == 80.0) return at(VolumeErrors::ProgramLacks, {"G", "X, Y, Z"});
    return cycle(to, values);
  }

  bool takeMode(double code) {
    constexpr std::array kMotions{0.0, 1.0, 80.0, 81.0, 82.0, 83.0};
    // Accepted without effect, as they are the state: millimetres, absolute, mm/min, the plane across the shank, no
    // compensation.
    constexpr std::array kWithoutEffect{4.0, 17.0, 21.0, 40.0, 49.0, 54.0, 61.0, 64.0, 90.0, 94.0};
    if (std::find(kMotions.begin(), kMotions.end(), code) != kMotions.end()) {
      const bool wasCycle = m_mode > 80.0;
      if (code > 80.0 && !wasCycle) m_first = m_at.z();
      if (code <= 80.0) m_bottom = m_above = m_peck = m_pause = std::nullopt;
      m_mode = code;
      return true;
    }
    if (code == 98.0 || code == 99.0) {
      m_isBackToR = code == 99.0;
      return true;
    }
    return std::find(kWithoutEffect.begin(), kWithoutEffect.end(), code) != kWithoutEffect.end();
  }

  MaybeError takeSpeeds(const std::map<char, double>& values) {
    if (const auto feed = values.find('F'); feed != values.end()) {
      if (!(feed->second > 0.0)) return at(VolumeErrors::ProgramValue, {"F", "> 0"});
      m_feed = feed->second / 60.0;
    }
    if (const auto speed = values.find('S'); speed != values.end()) {
      if (!(speed->second >= 0.0)) return at(VolumeErrors::ProgramValue, {"S", ">= 0"});
      if (m_program.spindle && *m_program.spindle != speed->second)
        return at(VolumeErrors::ProgramValue, {"S", "one speed for the whole program"});
      m_program.spindle = speed->second;
    }
    return std::nullopt;
  }

  MaybeError dwell(const std::map<char, double>& values) {
    const auto time = values.find('P');
    if (time == values.end()) return at(VolumeErrors::ProgramLacks, {"P", "G4"});
    if (!(time->second >= 0.0)) return at(VolumeErrors::ProgramValue, {"P", ">= 0"});
    return m_program.waypoints.empty() ? std::nullopt : wait(time->second);
  }

  MaybeError line(const Vec3& to, const std::array<bool, 3>& isNamed) {
    if (m_program.waypoints.empty()) {
      for (std::size_t k = 0; k < 3; ++k)
        if (!isNamed[k]) return at(VolumeErrors::ProgramLacks, {std::string(1, "XYZ"[k]), "X, Y, Z"});
      m_at = to;
      m_program.waypoints.push_back({0.0, to});
      return std::nullopt;
    }
    if (m_mode == 0.0) return go(to, DrillProgram::kRapid);
    return feedTo(to);
  }

  MaybeError feedTo(const Vec3& to) {
    if (!m_feed) return at(VolumeErrors::ProgramLacks, {"F", "G" + std::to_string(static_cast<int>(m_mode))});
    return go(to, *m_feed);
  }

  MaybeError cycle(const Vec3& to, const std::map<char, double>& values) {
    const std::string name = "G" + std::to_string(static_cast<int>(m_mode));
    if (m_program.waypoints.empty()) return at(VolumeErrors::ProgramLacks, {"G0", name});
    const auto take = [&](char letter, std::optional<double>& value) {
      if (const auto found = values.find(letter); found != values.end()) value = found->second;
      return value.has_value();
    };
    if (!take('R', m_above)) return at(VolumeErrors::ProgramLacks, {"R", name});
    if (!take('Z', m_bottom)) return at(VolumeErrors::ProgramLacks, {"Z", name});
    if (!(*m_bottom <= *m_above)) return at(VolumeErrors::ProgramValue, {"Z", "<= R"});
    if (m_mode == 82.0) {
      if (!take('P', m_pause)) return at(VolumeErrors::ProgramLacks, {"P", name});
      if (!(*m_pause >= 0.0)) return at(VolumeErrors::ProgramValue, {"P", ">= 0"});
    }
    if (m_mode == 83.0) {
      if (!take('Q', m_peck)) return at(VolumeErrors::ProgramLacks, {"Q", name});
      if (!(*m_peck > 0.0)) return at(VolumeErrors::ProgramValue, {"Q", "> 0"});
    }
    // Up first where the head is below R, then across, and down to R.
    if (m_at.z() < *m_above)
      if (const auto error = go({m_at.x(), m_at.y(), *m_above}, DrillProgram::kRapid)) return error;
    if (const auto error = go({to.x(), to.y(), m_at.z()}, DrillProgram::kRapid)) return error;
    if (const auto error = toHeight(*m_above)) return error;
    if (const auto error = m_mode == 83.0 ? pecks() : feedTo({to.x(), to.y(), *m_bottom})) return error;
    if (m_mode == 82.0)
      if (const auto error = wait(*m_pause)) return error;
    return toHeight(m_isBackToR ? *m_above : std::max(m_first, *m_above));
  }

  MaybeError pecks() {
    for (double depth = *m_above; depth > *m_bottom;) {
      if (depth < *m_above)
        if (const auto error = toHeight(std::min(*m_above, depth + DrillProgram::kPeckClearance))) return error;
      // Never the same again for a peck that is lost in rounding.
      const double next = std::max(*m_bottom, depth - *m_peck);
      depth = next < depth ? next : *m_bottom;
      if (const auto error = feedTo({m_at.x(), m_at.y(), depth})) return error;
      if (depth > *m_bottom)
        if (const auto error = toHeight(*m_above)) return error;
    }
    return std::nullopt;
  }

  MaybeError toHeight(double z) { return go({m_at.x(), m_at.y(), z}, DrillProgram::kRapid); }

  MaybeError go(const Vec3& to, double speed) {
    const double distance = (to - m_at).norm();
    m_at = to;
    if (distance == 0.0) return std::nullopt;
    return add(distance / speed);
  }
  MaybeError wait(double time) { return time > 0.0 ? add(time) : std::nullopt; }
  MaybeError add(double time) {
    if (m_program.waypoints.size() >= DrillProgram::kMostWaypoints)
      return at(VolumeErrors::ProgramTooLong, {std::to_string(DrillProgram::kMostWaypoints)});
    m_program.waypoints.push_back({m_program.waypoints.back().time + time, m_at});
    return std::nullopt;
  }

  DrillProgram m_program;
  std::uint64_t m_line = 0;
  bool m_isOver = false, m_isBackToR = false;
  double m_mode = 80.0;                                      // code of the motion mode
  Vec3 m_at = Vec3::Zero();                                  // mm
  double m_first = 0.0;                                      // mm, the height before the cycle
  std::optional<double> m_feed;                              // mm/s
  std::optional<double> m_above, m_bottom, m_peck, m_pause;  // R, Z, Q and P of the cycle
};

}  // namespace

Result<DrillProgram> readDrillProgram(std::string_view text) {
  return Reader().read(text);
}

}  // namespace handwheel
