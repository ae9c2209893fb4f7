// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/ExternalAxes.h"
#include "robot/posts/KrlStatus.h"
#include "robot/posts/PostText.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kLongestKrlName = 24;
// Keywords and types of KRL, and the routines that programs commonly call.
constexpr const char* kKrlWords[] = {
    "and",      "anin",     "anout",   "axis",      "b_and",    "b_exor",  "b_not",    "b_or",      "bas",
    "bool",     "brake",    "case",    "cast_from", "cast_to",  "cclose",  "channel",  "char",      "cioctl",
    "circ",     "circ_rel", "confirm", "const",     "continue", "copen",   "cread",    "cwrite",    "decl",
    "def",      "defdat",   "default", "deffct",    "delay",    "digin",   "distance", "do",        "e6axis",
    "e6pos",    "else",     "end",     "enddat",    "endfct",   "endfor",  "endif",    "endloop",   "endswitch",
    "endwhile", "enum",     "exit",    "exor",      "ext",      "extfct",  "extp",     "false",     "for",
    "frame",    "global",   "goto",    "halt",      "if",       "import",  "int",      "interrupt", "is",
    "lin",      "lin_rel",  "loop",    "maximum",   "minimum",  "not",     "off",      "on",        "or",
    "path",     "pos",      "prio",    "ptp",       "ptp_rel",  "public",  "pulse",    "real",      "repeat",
    "resume",   "return",   "scirc",   "sec",       "signal",   "slin",    "spline",   "sptp",      "sread",
    "struc",    "switch",   "swrite",  "then",      "to",       "trigger", "true",     "until",     "wait",
    "when",     "while"};
constexpr const char* kBaseRemark =
    "; Lines hold if the base of the robot's description is $ROBROOT: test this first.\n";

std::string krlFrame(const Pose& pose) {
  const Vec3 at = pose.translation(), turn = zyxAngles(pose.linear()) / kRadiansPerDegree;
  return "X " + fixedText(at.x(), 5) + ",Y " + fixedText(at.y(), 5) + ",Z " + fixedText(at.z(), 5) + ",A " +
         fixedText(turn.x(), 7) + ",B " + fixedText(turn.y(), 7) + ",C " + fixedText(turn.z(), 7);
}

}  // namespace

std::string KrlPost::write(const RobotProgram& program) const {
  std::vector<const char*> words(std::begin(kKrlWords), std::end(kKrlWords));
  const std::set<std::string> names = keptNames(program, id());
  for (const std::string& name : names) words.push_back(name.c_str());
  std::string text = "&ACCESS RVP\n&REL 1\nDEF " + identifierBeside(words, program.name, kLongestKrlName) + "()\n";
  for (const std::string& remark : headRemarks(program)) text += "; " + remark + "\n";
  if (needsControllersBase(program)) text += kBaseRemark;
  const std::string axes = externalAxesOf(program, id()), external = axes.empty() ? "" : "," + axes;
  const auto isDeclaration = [](const ProgramLine& line) { return line.kind == ProgramLine::Kind::Declaration; };
  const auto kept = [](const std::vector<ProgramLine>& lines) { return keptTexts(lines, "", ";", ""); };
  std::vector<ProgramLine> before = program.head;
  const auto statements = std::ranges::stable_partition(before, isDeclaration);
  text += kept({before.begin(), statements.begin()});
  text += "BAS(#INITMOV,0)\n$TOOL={" + krlFrame(program.tool) + "}\n";
  if (!program.frameName.empty()) text += std::string(kKrlBaseName) + frameIdentifier(program, {}, 60) + "\n";
  text += "$BASE={" + krlFrame(program.frame) + "}\n";
  text += kept({statements.begin(), statements.end()});
  double share = -1.0, speed = -1.0;
  for (const ProgramMotion& motion : program.motions) {
    if (!motion.name.empty()) text += "; " + identifierOf(motion.name, 60) + "\n";
    if (motion.kind == ProgramMotion::Kind::Joint) {
      if (motion.speed != share) text += "BAS(#VEL_PTP," + fixedText(100.0 * motion.speed, 2) + ")\n";
      share = motion.speed;
      const std::vector<double> degrees = degreesOf(motion.joints);
      text += "PTP {";
      for (std::size_t i = 0; i < degrees.size(); ++i)
        text += (i > 0 ? ",A" : "A") + std::to_string(i + 1) + " " + fixedText(degrees[i], 7);
      text += external + "}\n";
    } else {
      if (motion.speed != speed) text += "$VEL.CP=" + fixedText(1e-3 * std::max(motion.speed, 0.01), 5) + "\n";
      speed = motion.speed;
      if (motion.blend > 0.0) text += "$APO.CDIS=" + fixedText(motion.blend, 3) + "\n";
      const Pose pose = program.frame.inverse(Eigen::Isometry) * program.tipOf(motion);
      text += "LIN {" + krlFrame(pose) + "," + krlStatusOf(program.arm, motion.joints).text() + external + "}" +
              (motion.blend > 0.0 ? " C_DIS\n" : "\n");
    }
    text += kept(motion.lines);
  }
  return text + "END\n";
}

}  // namespace handwheel
