// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ArmPosture.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace handwheel {

namespace {

constexpr std::size_t kLongestRapidName = 32;
constexpr std::size_t kMotionsOfARoutine = 1'000;
constexpr const char* kNoAxes = "[9E9,9E9,9E9,9E9,9E9,9E9]";

std::string rapidPose(const Pose& pose) {
  const Vec3 at = pose.translation();
  Eigen::Quaterniond turn(pose.linear());
  turn.normalize();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const double parts[] = {turn.w(), turn.x(), turn.y(), turn.z()};
  return "[" + fixedList(std::span(at.data(), 3), 5) + "],[" + fixedList(parts, 10) + "]";
}

// The quadrants of axes 1, 4 and 6, and how the arm stands.
std::string configurationText(const SerialArm& arm, const ArmValues& values) {
  const auto quadrant = [&](Eigen::Index i) {
    return std::to_string(static_cast<int>(std::floor(values[i] / (90.0 * kRadiansPerDegree))));
  };
  const ArmPosture posture = postureOf(arm, values);
  const int cfx = (posture.isRear ? 4 : 0) + (posture.isElbowDown ? 2 : 0) + (posture.isFlipped ? 1 : 0);
  return "[" + quadrant(0) + "," + quadrant(3) + "," + quadrant(5) + "," + std::to_string(cfx) + "]";
}

std::string zoneText(double blend) {
  if (blend <= 0.0) return "fine";
  const double turning = 1.5 * blend;
  const double numbers[] = {blend, turning, turning, 0.1 * turning, turning, 0.1 * turning};
  return "[FALSE," + fixedList(numbers, 3) + "]";
}

std::string motionLine(const RobotProgram& program, const ProgramMotion& motion) {
  std::string line = "    ";
  if (motion.kind == ProgramMotion::Kind::Joint) {
    line += "MoveAbsJ [[" + fixedList(degreesOf(motion.joints), 7) + "]," + kNoAxes + "]\\NoEOffs,vmax,";
  } else {
    const Pose place = program.frame.inverse(Eigen::Isometry) * program.tipOf(motion);
    line += "MoveL [" + rapidPose(place) + "," + configurationText(program.arm, motion.joints) + "," + kNoAxes + "],[" +
            fixedText(motion.speed, 2) + ",500,5000,1000],";
  }
  return line + zoneText(motion.blend) + ",hwTool\\WObj:=hwFrame;\n";
}

class RapidReading {
 public:
  explicit RapidReading(Eigen::Index joints) : m_joints(static_cast<std::size_t>(joints)) {}

  Status readLine(std::string_view text, std::size_t number) {
    LineReader line(text, number);
    while (line.takeWord("LOCAL") || line.takeWord("TASK")) {
    }
    if (line.takeWord("CONST") || line.takeWord("PERS") || line.takeWord("VAR")) return readData(line);
    if (line.takeWord("MoveAbsJ")) return readMotion(line, number, ProgramMotion::Kind::Joint, true);
    if (line.takeWord("MoveJ")) return readMotion(line, number, ProgramMotion::Kind::Joint, false);
    if (line.takeWord("MoveL")) return readMotion(line, number, ProgramMotion::Kind::Linear, false);
    line.skipSpace();
    LineReader other = line;
    const std::string_view word = other.name();
    if (word.size() >= 4 && LineReader(word, number).take("Move"))
      return Error{ErrorCode::Unsupported, {std::string(word)}, InputPosition::line(number), {}};
    return Done{};
  }
  std::vector<ReadMotion> motions;

 private:
  using Numbers = std::vector<double>;

  Status readData(LineReader& line) {
    const bool isJoints = line.takeWord("jointtarget");
    if (!isJoints && !line.takeWord("robtarget")) return Done{};
    const std::string name(line.name());
    if (name.empty() || !line.take(":=")) return line.malformed("target", "a name and := were expected");
    const auto numbers = line.numbersWithin('[', ']', 20);
    if (!numbers) return line.malformed("target", "numbers in brackets were expected");
    (isJoints ? m_jointTargets : m_robTargets)[name] = *numbers;
    return Done{};
  }

  Status readMotion(LineReader& line, std::size_t number, ProgramMotion::Kind kind, bool isJoints) {
    if (motions.size() >= Post::kMostMotions) return line.malformed("MoveAbsJ", "there are too many motions");
    while (line.take("\\")) {  // as \Conc
      line.name();
      line.take(",");
    }
    auto numbers = line.numbersWithin('[', ']', 20);
    if (!numbers) {
      const std::string name(line.name());
      const auto& known = isJoints ? m_jointTargets : m_robTargets;
      const auto found = known.find(name);
      if (found == known.end()) return line.malformed("target", "it is neither numbers nor a name given before");
      numbers = found->second;
      if (line.take("(")) return line.malformed("target", "functions as Offs are not read");
    }
    ReadMotion motion{kind, {}, {}, 0.0, number};
    if (numbers->size() < (isJoints ? m_joints : 7)) return line.malformed("target", "it has too few numbers");
    if (isJoints)
      motion.joints = radiansOf(std::span(*numbers).first(m_joints));
    else if (auto pose = poseFrom(*numbers))
      motion.pose = *pose;
    else
      return line.malformed("target", "its quaternion has no direction");
    motion.blend = blendFrom(line.rest());
    motions.push_back(std::move(motion));
    return Done{};
  }

  static std::optional<Pose> poseFrom(const Numbers& n) {
    Eigen::Quaterniond turn(n[3], n[4], n[5], n[6]);
    if (!(turn.norm() > 1e-3) || !(turn.norm() < 1e3)) return std::nullopt;
    Pose pose(Eigen::Translation3d(n[0], n[1], n[2]));
    pose.linear() = turn.normalized().toRotationMatrix();
    return pose;
  }

  // Of "…,z10,…" or "[FALSE,10,…]"; 0 for fine.
  static double blendFrom(std::string_view rest) {
    const std::size_t own = rest.find("[FALSE,");
    if (own != rest.npos) return LineReader(rest.substr(own + 7), 0).number().value_or(0.0);
    for (std::size_t at = rest.find(','); at != rest.npos; at = rest.find(',', at + 1)) {
      LineReader word(rest.substr(at + 1), 0);
      if (!word.take("z")) continue;
      if (const auto zone = word.number()) return *zone;
    }
    return 0.0;
  }

  std::size_t m_joints;
  std::map<std::string, Numbers> m_jointTargets, m_robTargets;
};

}  // namespace

std::string RapidPost::write(const RobotProgram& program) const {
  const std::string name = identifierOf(program.name, kLongestRapidName - 4);
  std::string text = "MODULE " + name + "\n  ! " + identifierOf(program.robot, 60) + "\n";
  text += "  PERS tooldata hwTool:=[TRUE,[" + rapidPose(program.tool) + "],[" +
          fixedText(std::max(0.001, program.toolMass), 3) + ",[0,0,1],[1,0,0,0],0,0,0]];\n";
  text += "  PERS wobjdata hwFrame:=[FALSE,TRUE,\"\",[" + rapidPose(program.frame) + "],[[0,0,0],[1,0,0,0]]];\n";
  std::string calls, routines;
  for (std::size_t begin = 0; begin < program.motions.size(); begin += kMotionsOfARoutine) {
    const std::string routine = name + "_" + std::to_string(begin / kMotionsOfARoutine + 1);
    calls += "    " + routine + ";\n";
    routines += "  PROC " + routine + "()\n";
    double share = -1.0;
    const std::size_t end = std::min(program.motions.size(), begin + kMotionsOfARoutine);
    for (std::size_t i = begin; i < end; ++i) {
      const ProgramMotion& motion = program.motions[i];
      const double wanted = motion.kind == ProgramMotion::Kind::Joint ? motion.speed : 1.0;
      if (wanted != share) routines += "    VelSet " + fixedText(100.0 * wanted, 2) + ",5000;\n";
      share = wanted;
      routines += motionLine(program, motion);
    }
    routines += "  ENDPROC\n";
  }
  return text + "  PROC main()\n    ConfL\\Off;\n" + calls + "  ENDPROC\n" + routines + "ENDMODULE\n";
}

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
