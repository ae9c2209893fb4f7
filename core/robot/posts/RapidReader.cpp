// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <map>

namespace handwheel {

namespace {

// The parts between the commas that are in no brackets.
std::vector<std::string_view> argumentsOf(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || (text[i] == ',' && depth == 0)) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    } else if (text[i] == '[' || text[i] == '(') {
      ++depth;
    } else if (text[i] == ']' || text[i] == ')') {
      --depth;
    }
  }
  return parts;
}

std::string folded(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

class RapidReading {
 public:
  explicit RapidReading(Eigen::Index joints) : m_joints(static_cast<std::size_t>(joints)) {}

  Status readLine(std::string_view text, std::size_t number) {
    LineReader line(text, number);
    while (line.takeWord("LOCAL") || line.takeWord("TASK")) {
    }
    if (line.takeWord("CONST") || line.takeWord("PERS") || line.takeWord("VAR")) return readData(line);
    if (line.takeWord("VelSet")) {
      readOverride(line);
      return Done{};
    }
    if (line.takeWord("MoveAbsJ")) return readMotion(line, number, ProgramMotion::Kind::Joint, true);
    if (line.takeWord("MoveJ")) return readMotion(line, number, ProgramMotion::Kind::Joint, false);
    if (line.takeWord("MoveL")) return readMotion(line, number, ProgramMotion::Kind::Linear, false);
    line.skipSpace();
    LineReader other = line;
    const std::string_view word = other.name();
    const bool isCall = other.take(";");  // of a procedure without arguments, whose name may begin so
    if (!isCall && word.size() >= 4 && LineReader(word, number).take("Move"))
      return Error{ErrorCode::Unsupported, {std::string(word)}, InputPosition::line(number), {}};
    return Done{};
  }
  std::vector<ReadMotion> motions;

 private:
  using Numbers = std::vector<double>;
  using Table = std::map<std::string, Numbers>;  // by names in lower case

  Status readData(LineReader& line) {
    Table* const table = line.takeWord("jointtarget") ? &m_jointTargets
                         : line.takeWord("robtarget") ? &m_robTargets
                         : line.takeWord("speeddata") ? &m_speeds
                                                      : nullptr;
    if (!table) return Done{};
    const std::string name = folded(line.name());
    const bool isTarget = table != &m_speeds;
    if (name.empty() || !line.take(":="))
      return isTarget ? Status(line.malformed("target", "a name and := were expected")) : Done{};
    const auto numbers = line.numbersWithin('[', ']', 20);
    if (numbers && !numbers->empty())
      (*table)[name] = *numbers;
    else if (isTarget)
      return line.malformed("target", "numbers in brackets were expected");
    return Done{};
  }

  // VelSet percent, largest speed of the tool's centre point. Where these are no numbers no speed is known.
  void readOverride(LineReader& line) {
    const auto percent = line.number();
    const auto most = line.take(",") ? line.number() : std::nullopt;
    m_share = percent && most ? 0.01 * *percent : 0.0;
    m_most = most.value_or(0.0);
  }

  // "[[…],…]", a name, CalcRobT(joints,tool): the numbers, and whether they are joint values.
  Result<std::pair<Numbers, bool>> target(LineReader& line, bool isJoints) {
    if (!isJoints && line.takeWord("CalcRobT")) {
      if (!line.take("(")) return line.malformed("target", "( was expected");
      auto within = target(line, true);
      std::size_t end = 0;
      for (int depth = 1; depth > 0 && end < line.rest().size(); ++end)
        depth += line.rest()[end] == '(' ? 1 : line.rest()[end] == ')' ? -1 : 0;
      line.skip(end);
      return within;
    }
    if (auto numbers = line.numbersWithin('[', ']', 20)) return std::pair(std::move(*numbers), isJoints);
    const Table& known = isJoints ? m_jointTargets : m_robTargets;
    const auto found = known.find(folded(line.name()));
    if (line.take("(")) return line.malformed("target", "functions as Offs are not read");
    if (found == known.end()) return line.malformed("target", "it is neither numbers nor a name given before");
    return std::pair(found->second, isJoints);
  }

  Status readMotion(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool wantsJoints) {
    if (motions.size() >= Post::kMostMotions) return line.malformed("MoveAbsJ", "there are too many motions");
    while (line.take("\\")) {  // as \Conc
      line.name();
      line.take(",");
    }
    const auto read = target(line, wantsJoints);
    if (!read) return read.error();
    const auto& [numbers, isJoints] = *read;
    ReadMotion motion{kind, {}, {}, 0.0, number};
    if (numbers.size() < (isJoints ? m_joints : 7)) return line.malformed("target", "it has too few numbers");
    if (isJoints)
      motion.joints = radiansOf(std::span(numbers).first(m_joints));
    else if (auto pose = poseFrom(numbers))
      motion.pose = *pose;
    else
      return line.malformed("target", "its quaternion has no direction");
    const std::vector<std::string_view> arguments = argumentsOf(line.rest());
    if (arguments.size() > 1) setSpeed(arguments[1], motion);
    if (arguments.size() > 2) motion.blend = blendFrom(arguments[2]);
    motions.push_back(std::move(motion));
    return Done{};
  }

  // "v100", "[100,500,5000,1000]", a name of the file; "v100\V:=50". vmax is the largest of the joints.
  void setSpeed(std::string_view text, ReadMotion& motion) const {
    LineReader line(text, 0);
    std::optional<double> speed;
    if (const auto numbers = line.numbersWithin('[', ']', 20); numbers && !numbers->empty()) {
      speed = numbers->front();
    } else {
      const std::string name = folded(line.name());
      LineReader number(std::string_view(name).substr(std::min<std::size_t>(1, name.size())), 0);
      const auto found = m_speeds.find(name);
      if (found != m_speeds.end())
        speed = found->second.front();
      else if (name == "vmax" && motion.kind == ProgramMotion::Kind::Joint && m_share > 0.0)
        motion.speed = std::min(1.0, m_share);
      else if (name.starts_with('v'))
        speed = number.number();
    }
    if (line.take("\\V") && line.take(":=")) speed = line.number();
    if (!speed || !(*speed * m_share > 0.0)) return;
    (motion.kind == ProgramMotion::Kind::Linear ? motion.speed : motion.toolSpeed) = std::min(*speed * m_share, m_most);
  }

  static std::optional<Pose> poseFrom(const Numbers& n) {
    Eigen::Quaterniond turn(n[3], n[4], n[5], n[6]);
    if (!(turn.norm() > 1e-3) || !(turn.norm() < 1e3)) return std::nullopt;
    Pose pose(Eigen::Translation3d(n[0], n[1], n[2]));
    pose.linear() = turn.normalized().toRotationMatrix();
    return pose;
  }

  // Of "z10" or "[FALSE,10,…]"; 0 for fine.
  static double blendFrom(std::string_view text) {
    LineReader line(text, 0);
    if (!line.take("z") && !(line.take("[") && line.takeWord("FALSE") && line.take(","))) return 0.0;
    return line.number().value_or(0.0);
  }

  std::size_t m_joints;
  double m_share = 1.0, m_most = 5'000.0;  // of VelSet; 0: not known
  Table m_jointTargets, m_robTargets, m_speeds;
};

}  // namespace

Result<std::vector<ReadMotion>> RapidPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::vector<std::string_view>> lines = programLines(text, "!");
  if (!lines) return lines.error();
  RapidReading reading(frame.arm.size());
  for (std::size_t i = 0; i < lines->size(); ++i) {
    if (const Status read = reading.readLine((*lines)[i], i + 1); !read) return read.error();
  }
  return std::move(reading.motions);
}

}  // namespace handwheel
