// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/ExternalAxes.h"
#include "robot/posts/FanucConfiguration.h"
#include "robot/posts/FanucFrames.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kLongestFanucName = 8;  // limit that every controller accepts
constexpr std::size_t kLongestPositionName = 16;
constexpr std::size_t kLongestFanucRemark = 25;  // with its sign; teach pendants cut what is longer
// The last user frame, and the position register by which a program sets it.
constexpr int kOwnFrame = 9;

// Returns a position in the frame of the cell, which the program sets itself, or in the world frame, which is user
// frame 0. Neither needs an entry on the controller.
// external: what follows in all positions (externalAxesOf()).
std::string positionText(const RobotProgram& program, const ProgramMotion& motion, const std::string& external) {
  const std::size_t group = std::min(external.find(kFanucGroup), external.size());
  const std::string axes = external.substr(0, group);
  std::string others = external.substr(group);
  if (const std::size_t end = others.find(':'); end != others.npos) others.insert(end + 1, "\n   ");
  const std::string ending = (axes.empty() ? "" : ", " + axes) + "\n" + (others.empty() ? "" : "   " + others + "\n");
  const bool isInFrame = !program.frameName.empty();
  std::string text = "   GP1:\n   UF : " + std::to_string(isInFrame ? kOwnFrame : 0) + ", UT : 1,";
  if (motion.kind == ProgramMotion::Kind::Joint) {
    text += "\n";
    const std::vector<double> degrees = degreesOf(countedByController(coupled(program.arm), motion.joints));
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      text += (i % 3 == 0 ? "   J" : " J") + std::to_string(i + 1) + " = " + fixedText(degrees[i], 6) + " deg" +
              (i + 1 < degrees.size() ? "," : ending) + (i == 2 ? "\n" : "");
    }
    return text;
  }
  const Pose frame = isInFrame ? program.frame : fanucWorld(program.arm);
  const Pose pose = frame.inverse(Eigen::Isometry) * program.tipOf(motion);
  const Vec3 at = pose.translation(), turn = zyxAngles(pose.linear()) / kRadiansPerDegree;
  text += " CONFIG : '" + fanucConfigurationOf(program.arm, motion.joints).text() + "',\n";
  text += "   X = " + fixedText(at.x(), 5) + " mm, Y = " + fixedText(at.y(), 5) + " mm, Z = " + fixedText(at.z(), 5) +
          " mm,\n";
  return text + "   W = " + fixedText(turn.z(), 7) + " deg, P = " + fixedText(turn.y(), 7) +
         " deg, R = " + fixedText(turn.x(), 7) + " deg" + ending;
}

std::string fanucSpeed(const ProgramMotion& motion) {
  constexpr double kLongestMilliseconds = 32.0;  // s
  if (motion.seconds > kLongestMilliseconds) return fixedText(motion.seconds, 1) + "sec";
  if (motion.seconds > 0.0) return fixedText(std::max(1e3 * motion.seconds, 1.0), 0) + "msec";
  if (motion.kind == ProgramMotion::Kind::Joint)
    return std::to_string(std::clamp(static_cast<int>(std::lround(100.0 * motion.speed)), 1, 100)) + "%";
  const std::string tenths = fixedText(std::max(motion.speed, 0.1), 1);
  return (tenths.ends_with(".0") ? tenths.substr(0, tenths.size() - 2) : tenths) + "mm/sec";
}

// Splits a sentence into remarks that are short enough.
void addRemark(std::string_view sentence, std::vector<std::string>& lines) {
  constexpr std::size_t kLongest = kLongestFanucRemark;
  std::string line = "!";
  while (!sentence.empty()) {
    const std::string_view word = sentence.substr(0, sentence.find(' '));
    sentence.remove_prefix(std::min(word.size() + 1, sentence.size()));
    if (line.size() > 1 && line.size() + 1 + word.size() > kLongest) {
      lines.push_back(line);
      line = "!";
    }
    line += (line.size() > 1 ? " " : "") + std::string(word);
    for (; line.size() > kLongest; line = "!" + line.substr(kLongest)) lines.push_back(line.substr(0, kLongest));
  }
  if (line.size() > 1) lines.push_back(line);
}

// Returns the instructions that set the frame of the cell as a user frame, through a position register.
std::vector<std::string> frameLines(const RobotProgram& program) {
  const Pose frame = fanucWorld(program.arm).inverse(Eigen::Isometry) * program.frame;
  const Vec3 at = frame.translation(), turn = zyxAngles(frame.linear()) / kRadiansPerDegree;
  const std::string number = std::to_string(kOwnFrame), position = "PR[" + number;
  std::vector<std::string> lines{kSetsFanucFrame + number + "], " + position + "] to",
                                 "!" + identifierOf(program.frameName, kLongestFanucRemark - 1),
                                 position + "]=LPOS-LPOS"};
  const double values[] = {at.x(), at.y(), at.z(), turn.z(), turn.y(), turn.x()};
  for (std::size_t i = 0; i < std::size(values); ++i) {
    const std::string value = fixedText(values[i], i < 3 ? 5 : 7);
    const bool isBelow = value.starts_with('-');  // the language requires brackets around it
    lines.push_back(position + "," + std::to_string(i + 1) + "]=" + (isBelow ? "(" + value + ")" : value));
  }
  lines.push_back("UFRAME[" + number + "]=" + position + "]");
  lines.push_back("UFRAME_NUM=" + number);
  return lines;
}

// Returns the lines before the motions.
std::vector<std::string> headLines(const RobotProgram& program) {
  std::vector<std::string> lines;
  if (program.hasPlainShapes) lines = {"!Collisions were checked", "!with simplified shapes", "!of the robot"};
  for (const std::string& remark : proofRemarks(program)) addRemark(remark, lines);
  for (const std::string& remark : program.remarks) addRemark(remark, lines);
  if (needsControllersBase(program)) lines.insert(lines.end(), {"!Lines: test whether the", "!base is the robot foot"});
  const Vec3 at = program.tool.translation(), turn = zyxAngles(program.tool.linear()) / kRadiansPerDegree;
  const auto pair = [](const char* first, double a, const char* second, double b) {
    return std::string("!") + first + " " + fixedText(a, 3) + " " + second + " " + fixedText(b, 3);
  };
  lines.insert(lines.end(), {"!Enter as UTOOL[1]:", pair("X", at.x(), "Y", at.y()), pair("Z", at.z(), "W", turn.z()),
                             pair("P", turn.y(), "R", turn.x())});
  const std::vector<std::string> frame =
      program.frameName.empty() ? std::vector<std::string>{"UFRAME_NUM=0"} : frameLines(program);
  lines.insert(lines.end(), frame.begin(), frame.end());
  lines.emplace_back("UTOOL_NUM=1");
  return lines;
}

}  // namespace

std::string FanucPost::write(const RobotProgram& program) const {
  std::string name = identifierOf(program.name, kLongestFanucName);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  const std::vector<std::string> head = headLines(program);
  const std::string external = externalAxesOf(program, id());
  std::string groups = "1";
  for (const char group : {'2', '3', '4', '5'})
    groups += external.find(std::string(kFanucGroup) + group) == external.npos ? ",*" : ",1";
  std::string lines, positions;
  std::size_t count = 0;
  const auto addLine = [&](const std::string& line) {
    lines += "   " + std::to_string(++count) + ":  " + line + " ;\n";
  };
  const auto addKept = [&](const std::vector<ProgramLine>& kept) {
    for (const ProgramLine& each : kept) {
      if (each.kind == ProgramLine::Kind::Axes) continue;
      std::vector<std::string> parts;
      if (each.kind == ProgramLine::Kind::Comment && program.language != id())
        addRemark(each.text, parts);
      else
        parts = {keptText(each, "!")};
      for (std::string& part : parts) {
        std::ranges::replace(part, ';', ',');
        addLine(part);
      }
    }
  };
  for (const std::string& line : head) addLine(line);
  addKept(program.head);
  for (std::size_t i = 0; i < program.motions.size(); ++i) {
    const ProgramMotion& motion = program.motions[i];
    const std::string number = std::to_string(i + 1);
    const std::string remark = motion.name.empty() ? "" : identifierOf(motion.name, kLongestPositionName);
    lines += "   " + std::to_string(++count) + (motion.kind == ProgramMotion::Kind::Joint ? ":J P[" : ":L P[") +
             number + (remark.empty() ? "" : ":" + remark) + "] " + fanucSpeed(motion) + " " +
             (motion.corner > 0.0 ? "CNT" + fixedText(motion.corner, 0) : "FINE") + "    ;\n";
    addKept(motion.lines);
    positions += "P[" + number + (remark.empty() ? "" : ":\"" + remark + "\"") + "]{\n" +
                 positionText(program, motion, external) + "};\n";
  }
  return "/PROG  " + name + "\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"HANDWHEEL\";\nPROTECT\t\t= READ_WRITE;\n" +
         "LINE_COUNT\t= " + std::to_string(count) + ";\nDEFAULT_GROUP\t= " + groups + ";\n/MN\n" + lines + "/POS\n" +
         positions + "/END\n";
}

}  // namespace handwheel
