// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/ExternalAxes.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"
#include "robot/posts/RapidConfiguration.h"
#include "robot/posts/RapidNames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace handwheel {

namespace {

constexpr std::size_t kMotionsOfARoutine = 1'000;
constexpr double kLargestRapidSpeed = 5'000.0;  // mm/s, limit of VelSet at the start of a task
constexpr const char* kNoAxes = "[9E9,9E9,9E9,9E9,9E9,9E9]";
constexpr const char* kRecordEnd = "ENDRECORD";  // no semicolon follows it

std::string rapidPose(const Pose& pose) {
  const Vec3 at = pose.translation();
  Eigen::Quaterniond turn(pose.linear());
  turn.normalize();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const double parts[] = {turn.w(), turn.x(), turn.y(), turn.z()};
  return "[" + fixedList(std::span(at.data(), 3), 5) + "],[" + fixedList(parts, 10) + "]";
}

std::string zoneText(double blend) {
  if (blend <= 0.0) return "fine";
  const double degrees = 0.1 * blend;
  // The tool may begin to turn only within the zone that was proven.
  const double numbers[] = {blend, blend, blend, degrees, blend, degrees};
  return "[FALSE," + fixedList(numbers, 3) + "]";
}

// Writes a module. Several of these modules may be loaded into one task: all global names include the path's name,
// except for a frame of the cell, which is the same in all.
class RapidWriting {
 public:
  explicit RapidWriting(const RobotProgram& program)
      : m_program(program),
        m_name(rapidName(program)),
        m_frame(rapidFrameName(program)),
        m_axes(externalAxesOf(program, "rapid")),
        m_names(keptNames(program, "rapid")) {
    if (m_axes.empty()) m_axes = kNoAxes;
    for (const ProgramMotion& motion : program.motions) {
      if (motion.kind == ProgramMotion::Kind::Linear) m_largestSpeed = std::max(m_largestSpeed, motion.speed);
    }
  }

  std::string text() {
    const std::size_t count = m_program.motions.size();
    std::string body, routines;
    if (count <= kMotionsOfARoutine) body = motionLines(0, count);
    for (std::size_t begin = 0; count > kMotionsOfARoutine && begin < count; begin += kMotionsOfARoutine) {
      const std::string routine = m_name + "_" + std::to_string(begin / kMotionsOfARoutine + 1);
      body += "    " + routine + ";\n";
      routines += "  LOCAL PROC " + routine + "()\n" + motionLines(begin, std::min(count, begin + kMotionsOfARoutine)) +
                  "  ENDPROC\n";
    }
    return "MODULE " + m_name + "_module\n" + head() + m_targets + "  PROC " + m_name + "()\n" +
           keptTexts(partOf(m_program.head, false), "    ", "! ", ";") + "    ConfL\\Off;\n" + body +
           "    VelSet 100," + fixedText(kLargestRapidSpeed, 0) + ";\n    ConfL\\On;\n  ENDPROC\n" + routines +
           "ENDMODULE\n";
  }

 private:
  std::string head() const {
    std::string text;
    for (const std::string& remark : headRemarks(m_program)) text += "  ! " + remark + "\n";
    text += "  ! To run it: " + m_name + ";\n";
    if (needsControllersBase(m_program) && !m_program.frameName.empty())
      text += "  ! The frame is counted from the base of the robot's description: measure it, or test this first.\n";
    const std::string mass = fixedText(std::max(0.001, m_program.toolMass), 3);
    text += "  ! The load of the tool is an assumption (" + mass + " kg): enter mass and centre of gravity of yours.\n";
    text += "  PERS tooldata " + m_name + "_tool:=[TRUE,[" + rapidPose(m_program.tool) + "],[" + mass +
            ",[0,0,1],[1,0,0,0],0,0,0]];\n";
    const std::string frame =
        "PERS wobjdata " + m_frame + ":=[FALSE,TRUE,\"\",[" + rapidPose(m_program.frame) + "],[[0,0,0],[1,0,0,0]]];\n";
    for (const ProgramLine& line : partOf(m_program.head, true))
      text += keptTexts({line}, "  ", "! ", line.text.ends_with(kRecordEnd) ? "" : ";");
    if (m_program.frameName.empty()) return text + "  " + frame;
    if (!m_program.declaresFrame)
      return text + "  ! Another module of the task has the frame. The path was proven with this one:\n  ! " + frame;
    return text +
           "  ! Other programs in this frame may have this line, too: within one task only one of them may.\n  " +
           frame;
  }

  std::string motionLines(std::size_t begin, std::size_t end) {
    std::string text;
    double share = -1.0;
    for (std::size_t i = begin; i < end; ++i) {
      const ProgramMotion& motion = m_program.motions[i];
      const double wanted = motion.kind == ProgramMotion::Kind::Joint ? std::min(motion.speed, 1.0) : 1.0;
      if (wanted != share)
        text += "    VelSet " + fixedText(100.0 * wanted, 2) + "," + fixedText(m_largestSpeed, 0) + ";\n";
      share = wanted;
      text += motionLine(motion) + keptTexts(motion.lines, "    ", "! ", ";");
    }
    return text;
  }

  // Returns the declarations among lines, or the others.
  static std::vector<ProgramLine> partOf(const std::vector<ProgramLine>& lines, bool isDeclarations) {
    std::vector<ProgramLine> part;
    std::ranges::copy_if(lines, std::back_inserter(part), [&](const ProgramLine& line) {
      return (line.kind == ProgramLine::Kind::Declaration) == isDeclarations;
    });
    return part;
  }

  std::string motionLine(const ProgramMotion& motion) {
    const std::string frame = m_name + "_tool\\WObj:=" + m_frame;
    const std::string end = zoneText(motion.blend) + "," + frame + ";\n";
    const std::string time = motion.seconds > 0.0 ? "\\T:=" + fixedText(motion.seconds, 3) : "";
    const bool hasLinkage = hasParallelLinkage(m_program.arm);
    const ArmValues counted = hasLinkage ? countedByController(m_program.arm, motion.joints) : motion.joints;
    const std::string joints = "[[" + fixedList(degreesOf(counted), 7) + "]," + m_axes + "]";
    if (motion.kind == ProgramMotion::Kind::Joint)
      return "    MoveAbsJ " + target("jointtarget", joints, motion) + "\\NoEOffs,vmax" + time + "," + end;
    const std::string speed = ",[" + fixedText(std::max(motion.speed, 0.01), 2) + ",500,5000,1000]" + time + ",";
    // If a description has turned or raised the base, a pose in it would be wrong: the controller computes its own, as
    // for parallel linkages. In a frame of the cell poses are written all the same, so that the path moves with the
    // work object; after ConfL\Off lines go on in the configuration of the joint motion before them.
    if ((!m_program.isBaseOfController || hasLinkage) && m_program.frameName.empty())
      return "    MoveL CalcRobT(" + target("jointtarget", joints, motion) + "," + frame + ")" + speed + end;
    const Pose toolPose = m_program.frame.inverse(Eigen::Isometry) * m_program.tipOf(motion);
    const std::string pose = "[" + rapidPose(toolPose) + "," +
                             rapidConfigurationOf(m_program.arm, motion.joints).text() + "," + m_axes + "]";
    return "    MoveL " + target("robtarget", pose, motion) + speed + end;
  }

  // Named waypoints become named data, which can be touched up.
  std::string target(const char* type, const std::string& numbers, const ProgramMotion& motion) {
    if (motion.name.empty()) return numbers;
    constexpr std::size_t kLongestNumber = 7;
    const std::string preferred = "p_" + identifierOf(motion.name, kLongestRapidName - kLongestNumber - 2);
    std::string name = preferred;
    for (std::size_t n = 2; !m_names.insert(lowerCase(name)).second; ++n) name = preferred + "_" + std::to_string(n);
    m_targets += std::string("  LOCAL CONST ") + type + " " + name + ":=" + numbers + ";\n";
    return name;
  }

  const RobotProgram& m_program;
  std::string m_name, m_frame, m_axes;
  double m_largestSpeed = kLargestRapidSpeed;  // mm/s
  std::string m_targets;
  std::set<std::string> m_names;  // names of targets and kept lines; in lower case
};

}  // namespace

// Parallel linkages of axis 3 that descriptions for ROS give without their coupling.
std::vector<Error> RapidPost::refusals(const RobotProgram& program) const {
  std::vector<Error> all = ControllerPost::refusals(program);
  std::string plain;
  for (const char letter : lowerCase(program.robot)) {
    if ((letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z')) plain += letter;
  }
  const auto isNamed = [&](const char* linkage) { return plain.find(linkage) != plain.npos; };
  constexpr std::array kLinkages = {"irb1400", "irb1410", "irb2400", "irb4400", "irb6400", "irb6660"};
  if (!program.arm.coupling() && std::ranges::any_of(kLinkages, isNamed) && !isNamed("irb6400r"))
    all.push_back({PostError::LinkageUnknown, {program.robot, title()}, {}, {}});
  return all;
}

std::string RapidPost::write(const RobotProgram& program) const {
  return RapidWriting(program).text();
}

}  // namespace handwheel
