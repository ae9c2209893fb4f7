// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ClosedFormIk.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/ExternalAxes.h"
#include "robot/posts/KeptLines.h"
#include "robot/posts/KrlData.h"
#include "robot/posts/KrlStatus.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"
#include "robot/posts/ProgramRoutines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace handwheel {

namespace {

// The speeds and zones that a program has set so far.
struct KrlSettings {
  std::array<std::optional<double>, 6> axes = {};   // shares of the largest
  std::optional<double> lineSpeed = {};             // mm/s
  bool isShareSet = false, isLineSpeedSet = false;  // also to something that is no number
  std::optional<double> blend = {};                 // mm; none: it is that of the controller

  // Returns the share of the slowest axis: all axes of a motion end together.
  std::optional<double> share() const {
    std::optional<double> least;
    for (const auto& axis : axes) {
      if (axis && *axis < least.value_or(2.0)) least = axis;
    }
    return least;
  }

  // Reads $VEL_AXIS[2]=50, in a loop $VEL_AXIS[I]=50; BAS(#VEL_PTP,50); $VEL.CP=0.1; BAS(#VEL_CP,0.1); $APO.CDIS=5.
  // Returns false for other statements. Zones of a technology package, as of BAS(#CP_PARAMS,0.1), are on the
  // controller.
  bool take(LineReader line) {
    if (line.take("$VEL_AXIS[")) {
      const auto axis = line.number();
      line.name();
      if (!line.take("]") || !line.take("=")) return true;
      const std::optional<double> share = positive(line, 0.01);
      isShareSet = true;
      for (std::size_t i = 0; i < axes.size(); ++i) {
        if (!axis || *axis == static_cast<double>(i + 1)) axes[i] = share;
      }
    } else if (line.take("$VEL.CP")) {
      line.take("=");
      lineSpeed = positive(line, kMillimetresOfMetre);
      isLineSpeedSet = true;
    } else if (LineReader whole = line; whole.takeWord("$VEL") && whole.take("=")) {  // $VEL={CP 0.1,…}
      lineSpeed = std::nullopt;
      isLineSpeedSet = true;
      return false;
    } else if (line.take("$APO.CDIS")) {
      blend = line.take("=") ? numberAlone(line.rest()) : std::nullopt;
    } else if (line.takeWord("$APO")) {
      if (!line.take(".")) blend = std::nullopt;
    } else if (line.takeWord("BAS")) {
      line.take("(");
      const bool isVelocity = LineReader(line).take("#VEL_"), isAcceleration = LineReader(line).take("#ACC_");
      const bool isShare = line.take("#VEL_PTP") || line.take("#PTP_PARAMS");
      const bool isSpeed = !isShare && (line.take("#VEL_CP") || line.take("#CP_PARAMS"));
      if (!isVelocity && !isAcceleration) blend = std::nullopt;
      line.take(",");
      if (isShare) axes.fill(positive(line, 0.01));
      if (isSpeed) lineSpeed = positive(line, kMillimetresOfMetre);
      isShareSet = isShareSet || isShare;
      isLineSpeedSet = isLineSpeedSet || isSpeed;
    } else {
      return false;
    }
    return true;
  }

 private:
  static constexpr double kMillimetresOfMetre = 1e3;

  static std::optional<double> positive(LineReader& line, double unit) {
    const auto value = line.number();
    return value && *value > 0.0 ? std::optional(unit * *value) : std::nullopt;
  }
};

// Reads a whole number: 2, 'B010' or 'H2'.
std::optional<unsigned> bitsOf(LineReader& line) {
  if (!line.take("'")) {
    const auto value = line.number();
    return value && *value >= 0.0 && *value < 64.0 ? std::optional(static_cast<unsigned>(*value)) : std::nullopt;
  }
  const std::string_view word = line.name();
  line.take("'");
  if (word.empty()) return std::nullopt;
  unsigned value = 0;
  const bool isHex = word[0] == 'H' || word[0] == 'h';
  const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), value, isHex ? 16 : 2);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

// Reads the values of "{X 1,Y 2,…}" under these names; none if one is missing. status: receives S and T. external:
// receives E1 to E6.
std::optional<std::array<double, 6>> aggregate(LineReader& line, const std::array<const char*, 6>& names,
                                               KrlStatus* status = nullptr, AxisValues* external = nullptr) {
  if (!line.take("{")) return std::nullopt;
  std::array<double, 6> values{};
  unsigned found = 0;
  while (!line.take("}")) {
    const std::string_view name = line.name();
    bool isKnown = false;
    for (std::size_t i = 0; i < names.size() && !isKnown; ++i) {
      LineReader word(name, 0);
      if (!word.takeWord(names[i]) || !word.rest().empty()) continue;
      const auto value = line.number();
      if (!value) return std::nullopt;
      values[i] = *value;
      found |= 1u << i;
      isKnown = true;
    }
    const bool isStatus = LineReader(name, 0).takeWord("S"), isTurn = LineReader(name, 0).takeWord("T");
    if (status && (isStatus || isTurn)) {
      (isStatus ? status->status : status->turn) = bitsOf(line);
    } else if (external && name.size() == 2 && (name[0] == 'E' || name[0] == 'e')) {
      const auto value = line.number();
      if (!value) return std::nullopt;
      if (*value < ExternalAxes::kNone) (*external)["E" + std::string(name.substr(1))] = *value;
    } else if (!isKnown) {
      if (name.empty() && !line.take(",") && !line.take("'")) return std::nullopt;
      if (line.take("'")) {
        line.name();
        line.take("'");
      } else if (!name.empty()) {
        line.number();
      }
    }
    line.take(",");
  }
  return found == 0x3f ? std::optional(values) : std::nullopt;
}

// First words of statements that neither move the robot nor change the effect of others. Anything that is in no list is
// refused.
constexpr std::array kKrlStill = {"WAIT", "CONTINUE", "HALT"};
// Beginnings of statements of this kind by which a tool may grip or release.
constexpr std::array kKrlGripping = {"PULSE", "$OUT", "$ANOUT", "$LOAD"};
constexpr std::array kKrlDeclarations = {"DECL", "INT", "REAL", "BOOL", "CHAR", "SIGNAL", "STRUC", "ENUM"};
// Variables of the controller that neither move the robot nor change the course of a motion.
constexpr std::array kKrlVariables = {"ACC",   "ACC_AXIS",   "ACC_EXTAX",  "ADVANCE", "BWDSTART", "CYCFLAG",
                                      "FLAG",  "H_POS",      "GEAR_JERK",  "JERK",    "OV_PRO",   "RED_VEL",
                                      "TIMER", "TIMER_FLAG", "TIMER_STOP", "VEL",     "VEL_AXIS", "VEL_EXTAX"};
// Statements that a program needs at its begin, and settings of KUKA's dialogues that only act through BAS.
constexpr std::array kKrlOwn = {"DEF", "EXT", "INI", "PDAT_ACT", "LDAT_ACT"};
// Functions without side effects, and words before brackets. Others may be routines that move the robot.
constexpr const char* kKrlFunctions[] = {"abs",     "acos", "and",  "atan2", "b_and",    "b_exor", "b_not",
                                         "b_or",    "bas",  "case", "cos",   "exor",     "for",    "if",
                                         "inv_pos", "not",  "or",   "pulse", "sec",      "sin",    "sqrt",
                                         "switch",  "tan",  "to",   "until", "varstate", "wait",   "while"};
bool takesOneOf(LineReader& line, std::span<const char* const> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* word) { return line.takeWord(word); });
}

class KrlReading {
 public:
  // data: the files of data beside the program, which must outlive this object.
  KrlReading(const RobotProgram& program, std::string_view data)
      : m_program(program),
        m_closed(ClosedFormIk::of(program.arm)),
        m_reference(ArmValues::Zero(program.arm.size())),
        m_base(program.frame),
        m_tool(program.tool),
        m_data(data) {}

  Result<std::vector<ParsedMotion>> takeMotions() {
    flushName();
    std::vector<ProgramLine> all = m_kept.before();
    for (const ParsedMotion& motion : m_kept.motions()) all.insert(all.end(), motion.lines.begin(), motion.lines.end());
    std::vector<ProgramLine> needed = m_data.neededBy(all);
    const auto isDeclaration = [](const ProgramLine& line) { return line.kind == ProgramLine::Kind::Declaration; };
    const auto values = std::ranges::find_if_not(needed, isDeclaration);
    std::vector<ProgramLine>& before = m_kept.before();
    before.insert(std::ranges::find_if_not(before, isDeclaration), values, needed.end());
    before.insert(before.begin(), needed.begin(), values);
    m_external.addTo(before);
    return m_kept.take();
  }
  bool isOver() const { return m_isOver; }  // at the end of the first routine: calls of others are refused

  // Reads the comment of a line; in the head of our own programs only the name of the next base.
  void readComment(std::string_view comment, std::size_t number) {
    if (comment.starts_with(kKrlBaseName))
      m_nextBase = readName(LineReader(comment.substr(kKrlBaseName.size()), 0).name());
    if (comment.find(kWrittenByUs) != comment.npos) {
      m_isOwn = m_isInOwnHead = true;
      m_kept.before().clear();
    }
    if (m_isInOwnHead || comment.starts_with(kKrlBaseName)) return;
    flushName();
    if (const std::string name = m_isOwn ? nameInComment(comment) : std::string(); !name.empty())
      m_nextName = {ProgramLine::Kind::Comment, name, number};
    else
      m_kept.keep(ProgramLine::Kind::Comment, comment.substr(1), number);
  }

  Status readLine(std::string_view text, std::size_t number) {
    LineReader line(text, number);
    line.skipSpace();
    if (line.rest().empty() || line.take("&")) return Done{};
    line.takeWord("GLOBAL");
    if (line.takeWord("INTERRUPT")) return isHarmlessInterrupt(line) ? Status(Done{}) : unread(text, number);
    const bool isDeclared = LineReader(line).takeWord("DEF") || LineReader(line).takeWord("EXT");
    if (!isDeclared && callsOther(line.rest(), kKrlFunctions)) return unread(text, number);
    // A loop may set the speeds of the axes, which is read; other loops are refused.
    if (line.takeWord("ENDFOR") && m_axisLoop) {
      m_axisLoop.reset();
      return Done{};
    }
    const bool isOfAxes = LineReader(line).take("$VEL_AXIS[") || LineReader(line).take("$ACC_AXIS[");
    if (m_axisLoop && !isOfAxes) return unread(m_axisLoop->text, m_axisLoop->line);
    if (line.takeWord("FOR")) {
      m_axisLoop = ProgramStatement{text, number};
      return Done{};
    }
    if (line.takeWord("END")) {
      m_isOver = true;
      return Done{};
    }
    const bool isTool = line.takeWord("$TOOL"), isBase = !isTool && line.takeWord("$BASE");
    if (isBase) {
      m_baseName = std::exchange(m_nextBase, kAnyBase);
      m_isInOwnHead = false;
    }
    m_isToolSet = m_isToolSet || isTool;
    if (isTool || isBase) return setFrame(line, isTool ? m_tool : m_base);
    if (readsOver(line, number)) return Done{};
    const bool isPtp = line.takeWord("PTP"), isLinear = !isPtp && line.takeWord("LIN");
    if (!isPtp && !isLinear) return unread(text, number);
    return readMotion(line, number, isPtp);
  }

 private:
  void keep(ProgramLine::Kind kind, std::string_view text, std::size_t number, bool mayGrip = false) {
    flushName();
    m_kept.keep(kind, text, number, mayGrip);
  }

  // Keeps a comment that may have been the name of a waypoint, and was none.
  void flushName() {
    if (m_nextName.text.empty()) return;
    m_kept.keep(std::exchange(m_nextName, {}));
  }

  // Recognises "OFF", or the handler of faults at the beginning of the maker's own programs: "DECL 3 WHEN
  // $STOPMESS==TRUE DO IR_STOPM()" and "ON 3". Other routines may move the robot at any time.
  bool isHarmlessInterrupt(LineReader line) {
    if (line.takeWord("OFF")) return true;
    if (line.takeWord("ON")) return m_faultInterrupt && line.number() == m_faultInterrupt;
    const auto number = line.takeWord("DECL") ? line.number() : std::nullopt;
    if (!number || !line.takeWord("WHEN") || !line.take("$STOPMESS") || !line.take("==") || !line.takeWord("TRUE") ||
        !line.takeWord("DO") || !line.takeWord("IR_STOPM") || !line.take("(") || !line.take(")"))
      return false;
    m_faultInterrupt = number;
    return true;
  }

  // Returns true for statements that do not change positions: speeds, outputs, declarations, waiting. Those that are
  // not interpreted are kept.
  bool readsOver(LineReader line, std::size_t number) {
    line.skipSpace();
    const std::string_view whole = line.rest();
    // Tools and bases by numbers are on the controller.
    const bool isBas = LineReader(line).takeWord("BAS"), isFrameData = LineReader(line).takeWord("FDAT_ACT");
    const std::string arguments = isBas ? lowerCase(std::string(line.rest())) : std::string();
    const auto isAbout = [&](const char* word) { return arguments.find(word) != arguments.npos; };
    const bool areBoth = isFrameData || isAbout("#frames") || isAbout("#ex_base");
    if (areBoth || isAbout("#tool")) m_tool = std::nullopt;
    if (areBoth || isAbout("#base")) {
      m_base = std::nullopt;
      m_baseName = kAnyBase;
    }
    if (m_settings.take(line) || isFrameData) return true;
    if (takesOneOf(line, kKrlOwn)) return true;
    if (takesOneOf(line, kKrlDeclarations)) {
      m_data.read(whole);
      keep(ProgramLine::Kind::Declaration, whole, number);
      return true;
    }
    const std::string_view named = LineReader(line).name();
    bool mayGrip = std::ranges::any_of(kKrlGripping, [&](const char* word) { return LineReader(line).take(word); });
    if (!mayGrip && !takesOneOf(line, kKrlStill)) {
      if (!isHarmlessAssignment(line)) return false;
      line.name();
      mayGrip = !named.empty() && line.take("=") && m_data.maySwitch(named);
    }
    keep(ProgramLine::Kind::Statement, whole, number, mayGrip);
    return true;
  }

  bool isHarmlessAssignment(LineReader line) const {
    if (line.take("$")) {
      const auto isSetTo = [&](const char* name, const char* value) {
        LineReader other = line;
        if (!other.takeWord(name) || !other.take("=") || !other.takeWord(value)) return false;
        other.skipSpace();
        return other.rest().empty();
      };
      LineReader name = line;
      return isSetTo("ORI_TYPE", "#VAR") || isSetTo("IPO_MODE", "#BASE") || isSetTo("CIRC_TYPE", "#BASE") ||
             takesOneOf(name, kKrlVariables);
    }
    const std::string_view named = line.name();
    line.skipSpace();
    const std::size_t sign = line.rest().find('=');
    if (named.empty() || sign == std::string_view::npos || m_data.valueOf(named)) return false;
    return sign == 0 || line.rest()[0] == '.' || line.rest()[0] == '[';  // "A=1", "P.X=1", "A[1]=1"
  }

  // Reads "={X 1,…}" or "=$NULLFRAME"; frames on the controller are not known.
  Status setFrame(LineReader& line, std::optional<Pose>& frame) {
    frame = std::nullopt;
    if (!line.take("=")) return Done{};
    const bool isNull = line.takeWord("$NULLFRAME");
    const auto values = isNull ? std::nullopt : aggregate(line, {"X", "Y", "Z", "A", "B", "C"});
    line.skipSpace();
    if (!line.rest().empty()) return Done{};  // the first of several, joined by ":"
    if (isNull) frame = Pose::Identity();
    if (values) frame = poseOf(*values);
    return Done{};
  }

  Status readMotion(LineReader line, std::size_t number, bool isPtp) {
    if (m_kept.isFull()) return line.malformed("PTP", "there are too many motions");
    ParsedMotion motion{isPtp ? ProgramMotion::Kind::Joint : ProgramMotion::Kind::Linear, {}, {}, 0.0, number};
    motion.speed = isPtp ? m_settings.share() : m_settings.lineSpeed;
    if (!motion.speed && (isPtp ? m_settings.isShareSet : m_settings.isLineSpeedSet)) m_kept.leaveOut(number);
    motion.frame = m_base;
    motion.frameName = m_baseName;
    if (m_isToolSet) motion.tool = m_tool;
    // A name stands for the numbers of its declaration.
    LineReader named = line;
    const std::string_view name = named.name();
    if (!name.empty()) {
      const auto value = m_data.valueOf(name);
      if (!value && isPtp && KrlData::isHome(name) && m_program.home)
        motion.joints = *m_program.home;
      else if (!value)
        return line.malformed("target", KrlData::isHome(name)
                                            ? "its joint values are on the controller: put $config.dat beside the "
                                              "program, or name a configuration of the cell 'home'"
                                            : "it has no numbers in the program or in a file of data beside it");
      motion.name = readName(name);
      line = LineReader(value.value_or(std::string_view()), number);
    }
    LineReader other = line;
    AxisValues axes, axesOfPose;
    if (motion.joints) {
      line = LineReader({}, number);
    } else if (const auto joints = aggregate(line, {"A1", "A2", "A3", "A4", "A5", "A6"}, nullptr, &axes)) {
      motion.joints = radiansOf(*joints);
    } else if (KrlStatus status;
               const auto frame = aggregate(other, {"X", "Y", "Z", "A", "B", "C"}, &status, &axesOfPose)) {
      axes = axesOfPose;
      if (!m_base || !m_tool) return line.refused(PostError::DataElsewhere);
      motion.pose = poseInProgram(m_program, *m_base, poseOf(*frame), *m_tool);
      line = other;
      // Controllers use S and T of joint motions only.
      if (isPtp && m_closed && (status.status || status.turn)) {
        motion.joints = jointsWith(status, m_program.arm, *m_closed, tipFor(*motion.pose), m_reference);
        if (!motion.joints) return line.refused(PostError::PoseUnreached);
        motion.pose = std::nullopt;
        motion.isAtPose = true;
      }
    } else {
      return line.malformed("target", "six axes or X, Y, Z, A, B, C were expected");
    }
    if (!name.empty()) line = named;
    line.skipSpace();
    // Other zones, such as C_PTP, have no size in mm.
    const std::string_view zone = line.rest();
    if (!isPtp && m_settings.blend.value_or(-1.0) >= 0.0 && line.takeWord("C_DIS")) motion.blend = *m_settings.blend;
    line.skipSpace();
    if (!line.rest().empty()) return unread(zone, number);
    if (!m_external.take(axes, number)) return line.malformed("target", ExternalAxes::kMoved);
    if (motion.joints) m_reference = *motion.joints;
    if (!m_nextName.text.empty()) motion.name = std::exchange(m_nextName, {}).text;
    m_kept.add(std::move(motion));
    return Done{};
  }

  // Returns the pose of the arm's tip for a pose of the program's tool in its frame.
  Pose tipFor(const Pose& pose) const { return m_program.frame * pose * m_program.tool.inverse(Eigen::Isometry); }

  static Pose poseOf(const std::array<double, 6>& frame) {
    Pose pose(Eigen::Translation3d(frame[0], frame[1], frame[2]));
    pose.linear() = fromZyx(Vec3(frame[3], frame[4], frame[5]) * kRadiansPerDegree);
    return pose;
  }

  const RobotProgram& m_program;
  std::optional<ClosedFormIk> m_closed;
  ArmValues m_reference;  // joint values, as far as the program defines them
  KrlSettings m_settings;
  std::optional<Pose> m_base, m_tool;  // in the base, in the flange; none: not known
  static constexpr const char* kAnyBase = "BASE";
  std::string m_baseName, m_nextBase = kAnyBase;
  KrlData m_data;
  std::optional<ProgramStatement> m_axisLoop;  // the open loop over the axes
  KeptLines m_kept;
  ExternalAxes m_external;
  ProgramLine m_nextName;  // comment that may be the name of the next motion's waypoint
  bool m_isOwn = false, m_isInOwnHead = false;
  std::optional<double> m_faultInterrupt;  // its number
  bool m_isToolSet = false;                // by the program; else m_tool is that of the cell
  bool m_isOver = false;
};

}  // namespace

Result<std::vector<ParsedMotion>> KrlPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::string> plain = programText(text), data = programText(frame.data);
  if (!plain) return plain.error();
  if (!data) return data.error();
  const Result<std::vector<std::string_view>> lines = programLines(*plain, ";");
  if (!lines) return lines.error();
  const Result<std::vector<std::string_view>> whole = programLines(*plain, {});
  KrlReading reading(frame, *data);
  for (std::size_t i = 0; i < lines->size() && !reading.isOver(); ++i) {
    if (const Status read = reading.readLine((*lines)[i], i + 1); !read) return read.error();
    const std::string_view comment = (*whole)[i].substr((*lines)[i].size());
    if (!comment.empty()) reading.readComment(comment, i + 1);
  }
  return reading.takeMotions();
}

}  // namespace handwheel
