// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/FanucConfiguration.h"
#include "robot/posts/PostText.h"
#include "robot/posts/ProgramRoutines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace handwheel {

namespace {

constexpr std::size_t kLongestFanucName = 8;  // limit that every controller accepts
constexpr std::size_t kLongestPositionName = 16;
constexpr std::size_t kLongestFanucRemark = 25;  // with its sign; teach pendants cut what is longer
// The last user frame, and the position register by which a program sets it.
constexpr int kOwnFrame = 9;
constexpr const char* kSetsFrame = "!Sets UFRAME[";

// Returns the arm as this maker's controllers count its joints: the third from the horizontal, which is that of the
// model minus the second. Only the arms that come with the program have limits for that.
SerialArm coupled(const SerialArm& arm) {
  return arm.coupling() && arm.coupling()->factor < 0.0 ? arm : arm.withCoupling(AxisCoupling{.factor = -1.0});
}

// Returns the world frame in the base, which this maker puts at the height of the second axis.
Pose fanucWorld(const SerialArm& arm) {
  std::array<Pose, 6> axes;
  arm.jointPoses(ArmValues::Zero(6), axes);
  const Vec3 up = axes[0].linear().col(2);
  return Pose(Eigen::Translation3d(up.dot(axes[1].translation()) * up));
}

// Returns a position in the frame of the cell, which the program sets itself, or in the world frame, which is user
// frame 0. Neither needs an entry on the controller.
std::string positionText(const RobotProgram& program, const ProgramMotion& motion) {
  const bool isInFrame = !program.frameName.empty();
  std::string text = "   GP1:\n   UF : " + std::to_string(isInFrame ? kOwnFrame : 0) + ", UT : 1,";
  if (motion.kind == ProgramMotion::Kind::Joint) {
    text += "\n";
    const std::vector<double> degrees = degreesOf(countedByController(coupled(program.arm), motion.joints));
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      text += (i % 3 == 0 ? "   J" : " J") + std::to_string(i + 1) + " = " + fixedText(degrees[i], 6) + " deg" +
              (i + 1 < degrees.size() ? "," : "") + (i % 3 == 2 ? "\n" : "");
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
         " deg, R = " + fixedText(turn.x(), 7) + " deg\n";
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
  std::vector<std::string> lines{kSetsFrame + number + "], " + position + "] to",
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

// The positions of a /POS section, by their numbers: their components, by name.
using FanucPosition = std::map<std::string, double, std::less<>>;

// Reads "UF : 0, J1 = 1.5 deg, X = 2 mm": each name with its number. Others are skipped.
void readAssignments(std::string_view text, FanucPosition& position) {
  for (std::size_t at = text.find_first_of("=:"); at != text.npos; at = text.find_first_of("=:", at + 1)) {
    std::size_t end = at;
    while (end > 0 && text[end - 1] == ' ') --end;
    std::size_t begin = end;
    while (begin > 0 && text[begin - 1] != ' ' && text[begin - 1] != ',' && text[begin - 1] != '\t') --begin;
    LineReader value(text.substr(at + 1), 0);
    if (const auto number = value.number(); number && end - begin <= 2)
      position[std::string(text.substr(begin, end - begin))] = *number;
  }
}

std::optional<std::vector<double>> valuesOf(const FanucPosition& position, std::initializer_list<const char*> names) {
  std::vector<double> values;
  for (const char* const name : names) {
    const auto found = position.find(name);
    if (found == position.end()) return std::nullopt;
    values.push_back(found->second);
  }
  return values;
}

// Reads the number of "P[12]", or with a remark "P[12:home]". 0: none.
std::size_t positionNumber(LineReader& line) {
  if (!line.take("P[")) return 0;
  const auto number = line.number();
  if (!number || !(*number >= 1.0 && *number <= static_cast<double>(PostProcessor::kMostMotions))) return 0;
  line.skip(line.rest().find(']') + 1);
  return static_cast<std::size_t>(*number);
}

// Returns the remark of "P[12:home]"; empty: none.
std::string_view positionRemark(std::string_view position) {
  const std::size_t begin = position.find(':'), end = position.find(']');
  return begin < end && end != position.npos ? position.substr(begin + 1, end - begin - 1) : std::string_view();
}

// Parses the speed after the target: "50%", "100mm/sec", "60cm/min", "4inch/min", or the duration in "2sec",
// "500msec", which becomes `seconds`. None: another unit.
std::optional<double> fanucSpeedFrom(LineReader line, bool isJoint, double& seconds) {
  const auto value = line.number();
  if (!value || !(*value > 0.0)) return std::nullopt;
  const bool isInSeconds = line.takeWord("sec");
  if (isInSeconds || line.takeWord("msec")) {
    seconds = isInSeconds ? *value : 1e-3 * *value;
    return std::nullopt;
  }
  if (isJoint) return line.take("%") ? std::optional(std::min(1.0, 0.01 * *value)) : std::nullopt;
  if (line.take("mm/sec")) return *value;
  if (line.take("cm/min")) return *value * 10.0 / 60.0;
  if (line.take("inch/min")) return *value * 25.4 / 60.0;
  return std::nullopt;
}

// Beginnings of statements that neither move the robot nor change the effect of others. Anything that is in no list is
// refused.
constexpr std::array kFanucStill = {"WAIT", "F[", "R[", "TIMER", "OVERRIDE", "MESSAGE", "COL ", "$WAITTMOUT"};
// Statements of this kind by which a tool may grip or release.
constexpr std::array kFanucGripping = {"DO[", "RO[", "GO[", "AO[", "PAYLOAD"};

bool beginsWithOneOf(const LineReader& line, std::span<const char* const> beginnings) {
  return std::ranges::any_of(beginnings, [&](const char* beginning) { return LineReader(line).take(beginning); });
}

constexpr std::string_view kOwnFanucComment = "\"HANDWHEEL\"";  // in the head of programs that we wrote

class FanucReading {
 public:
  explicit FanucReading(const RobotProgram& program)
      : m_program(program), m_closed(closedFormOfSphericalWrist(program.arm)) {}

  Status read(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    if (line.take("/")) {
      m_isInLines = line.takeWord("MN");
      m_isInPositions = !m_isInLines && line.takeWord("POS");
      return Done{};
    }
    if (m_isInPositions) readPosition(line);
    m_isInOwnHead = m_isInOwnHead || (!m_isInLines && statement.text.find(kOwnFanucComment) != std::string_view::npos);
    return m_isInLines ? readLine(statement) : Status(Done{});
  }

  // Returns the motions with their positions.
  Result<std::vector<ParsedMotion>> motions() {
    std::vector<ParsedMotion> all;
    std::optional<double> tool;
    ArmValues reference = ArmValues::Zero(m_program.arm.size());  // joint values, as far as the program defines them
    for (auto& [number, motion] : m_motions) {
      const FanucPosition& position = m_positions[number];
      if (const auto joints = valuesOf(position, {"J1", "J2", "J3", "J4", "J5", "J6"});
          joints && m_program.arm.size() == 6) {
        motion.joints = countedByModel(coupled(m_program.arm), radiansOf(*joints));
        if (const auto set = m_frames.find(frameNumber(position)); set != m_frames.end()) setFrame(*set, motion);
      } else if (const auto pose = valuesOf(position, {"X", "Y", "Z", "R", "P", "W"})) {
        // User frames except the world are on the controller, unless the program sets them.
        const double inFrame = frameNumber(position);
        const auto set = m_frames.find(inFrame);
        if (m_program.arm.size() != 6 || (inFrame != 0.0 && set == m_frames.end())) {
          return Error{
              ErrorCode::Unsupported, {"a place in another frame than UF : 0"}, InputPosition::line(motion.line), {}};
        }
        if (inFrame != 0.0) setFrame(*set, motion);
        // The data of tools are on the controller: 0 is the flange, the other one the tool of the cell.
        const auto named = valuesOf(position, {"UT"});
        const double used = named ? named->front() : 1.0;
        if (used != 0.0 && used != tool.value_or(used))
          return LineReader({}, motion.line).malformed("target", "it is of another tool than those before");
        if (used != 0.0) tool = used;
        Pose inWorld(Eigen::Translation3d((*pose)[0], (*pose)[1], (*pose)[2]));
        inWorld.linear() = fromZyx(Vec3((*pose)[3], (*pose)[4], (*pose)[5]) * kRadiansPerDegree);
        if (used == 0.0) motion.tool = Pose::Identity();
        motion.pose = poseInProgram(m_program, motion.frame.value_or(fanucWorld(m_program.arm)), inWorld,
                                    used == 0.0 ? Pose(Pose::Identity()) : m_program.tool);
        if (motion.kind == ProgramMotion::Kind::Joint && !takeConfiguration(number, reference, motion))
          return LineReader({}, motion.line)
              .malformed("target", "the robot reaches its place in no way with this configuration");
      } else {
        return LineReader({}, motion.line).malformed("target", "its place is not in /POS, or not all of it");
      }
      if (motion.joints) reference = *motion.joints;
      if (all.empty()) motion.before = std::move(m_before);
      all.push_back(std::move(motion));
    }
    return all;
  }

 private:
  // Sets the joint values of a joint motion to a pose from its CONFIG, if it has one. A line keeps the configuration in
  // which it begins. Returns false if no solution of the robot has the CONFIG.
  bool takeConfiguration(std::size_t position, const ArmValues& reference, ParsedMotion& motion) const {
    const auto wanted = m_configurations.find(position);
    if (wanted == m_configurations.end() || !m_closed) {
      motion.isConfigurationOpen = true;
      return true;
    }
    const Pose tip = m_program.frame * *motion.pose * m_program.tool.inverse(Eigen::Isometry);
    motion.joints = jointsWith(wanted->second, m_program.arm, *m_closed, tip, reference);
    if (motion.joints) motion.pose = std::nullopt;
    return motion.joints.has_value();
  }

  void setFrame(const std::pair<const double, Pose>& frame, ParsedMotion& motion) const {
    const auto named = m_frameNames.find(frame.first);
    motion.frame = frame.second;
    motion.frameName = named != m_frameNames.end() ? named->second : "UFRAME_" + fixedText(frame.first, 0);
  }

  // Reads "!Sets UFRAME[9], PR[9] to", and in the next line "!NAME".
  void readRemark(LineReader line, std::size_t number) {
    const std::string_view remark = line.rest();
    if (m_named) {
      line.take("!");
      if (const std::string_view name = line.name(); !name.empty()) m_frameNames[*m_named] = readName(name);
      m_named.reset();
    } else if (line.take(kSetsFrame)) {
      m_named = line.number();
    } else if (!m_isInOwnHead) {
      keep(ProgramLine::Kind::Comment, remark.substr(remark.starts_with("//") ? 2 : 1), number);
    }
  }

  void keep(ProgramLine::Kind kind, std::string_view text, std::size_t number, bool mayGrip = false) {
    (m_motions.empty() ? m_before : m_motions.back().second.lines).push_back(keptLine(kind, text, number, mayGrip));
  }

  void readPosition(LineReader& line) {
    if (const std::size_t number = positionNumber(line)) {
      m_open = number;
      m_isOwnGroup = true;
    }
    // Only the first of several motion groups is the robot.
    for (std::size_t at = line.rest().find("GP"); at != std::string_view::npos; at = line.rest().find("GP")) {
      takePosition(line.rest().substr(0, at));
      line.skip(at + 2);
      m_isOwnGroup = line.number().value_or(1.0) == 1.0 && line.take(":");
    }
    takePosition(line.rest());
  }

  void takePosition(std::string_view text) {
    if (m_open == 0 || !m_isOwnGroup) return;
    readAssignments(text, m_positions[m_open]);
    if (const auto configuration = fanucConfigurationFrom(text)) m_configurations[m_open] = *configuration;
  }

  Status readLine(const ProgramStatement& statement) {
    LineReader line(statement.text, statement.line);
    line.number();  // number of the line
    line.take(":");
    line.skipSpace();
    if (line.rest().empty()) return Done{};
    if (line.rest()[0] == '!' || line.rest().starts_with("//")) {
      readRemark(line, statement.line);
      return Done{};
    }
    m_named.reset();
    if (LineReader(line).take("UTOOL_NUM")) m_isInOwnHead = false;
    // Each position has the numbers of its frame and tool.
    if (LineReader(line).take("UFRAME_NUM") || LineReader(line).take("UTOOL_NUM")) return Done{};
    // A time-out jumps elsewhere: "WAIT DI[1]=ON TIMEOUT,LBL[2]".
    if (LineReader(line).take("WAIT") && lowerCase(std::string(line.rest())).find("timeout") != std::string::npos)
      return unread(line.rest(), statement.line);
    const bool mayGrip = beginsWithOneOf(line, kFanucGripping);
    if (mayGrip || beginsWithOneOf(line, kFanucStill)) {
      keep(ProgramLine::Kind::Statement, line.rest(), statement.line, mayGrip);
      return Done{};
    }
    const std::string_view whole = line.rest();
    if (LineReader(line).take("PR[") || LineReader(line).take("UFRAME["))
      return readsFrame(line) ? Status(Done{}) : unread(whole, statement.line);
    const bool isJoint = line.takeWord("J"), isLinear = !isJoint && line.takeWord("L");
    if (!isJoint && !isLinear) return unread(whole, statement.line);
    const std::string_view position = line.rest();
    const std::size_t number = positionNumber(line);
    if (number == 0) return line.malformed("target", "P[number] was expected");
    if (m_motions.size() >= PostProcessor::kMostMotions) return line.malformed("J", "there are too many motions");
    ParsedMotion motion{
        isJoint ? ProgramMotion::Kind::Joint : ProgramMotion::Kind::Linear, {}, {}, 0.0, statement.line};
    motion.name = readName(positionRemark(position));
    motion.speed = fanucSpeedFrom(line, isJoint, motion.seconds);
    if (const Status options = readOptions(line, statement.line, motion); !options) return options.error();
    m_motions.emplace_back(number, std::move(motion));
    return Done{};
  }

  // Returns the number of the frame of a position; below 0: not given.
  static double frameNumber(const FanucPosition& position) {
    const auto found = position.find("UF");
    return found == position.end() ? -1.0 : found->second;
  }

  // Reads "PR[9]=LPOS-LPOS", "PR[9,1]=(-12.5)", "UFRAME[9]=PR[9]" before all motions. Returns false for other
  // statements.
  bool readsFrame(LineReader line) {
    if (!m_motions.empty() || m_program.arm.size() != 6) return false;
    const bool isFrame = line.take("UFRAME[");
    if (!isFrame) line.take("PR[");
    const auto number = line.number();
    const auto element = !isFrame && line.take(",") ? line.number() : std::nullopt;
    if (!number || !line.take("]") || !line.take("=")) return false;
    const auto isOver = [&] {
      line.skipSpace();
      return line.rest().empty();
    };
    if (isFrame) {
      const auto from = line.take("PR[") ? line.number() : std::nullopt;
      const auto values = from ? m_registers.find(*from) : m_registers.end();
      if (*number < 1.0 || values == m_registers.end() || !line.take("]") || !isOver()) return false;
      const auto& [x, y, z, w, p, r] = values->second;
      Pose pose(Eigen::Translation3d(x, y, z));
      pose.linear() = fromZyx(Vec3(r, p, w) * kRadiansPerDegree);
      m_frames[*number] = fanucWorld(m_program.arm) * pose;
      return true;
    }
    if (!element) {
      if (!line.take("LPOS-LPOS") || !isOver()) return false;
      m_registers[*number] = {};
      return true;
    }
    const auto values = m_registers.find(*number);
    const bool isInBrackets = line.take("(");
    const auto value = line.number();
    const bool isWhole = value && (!isInBrackets || line.take(")")) && isOver();
    if (!isWhole || values == m_registers.end()) return false;
    for (std::size_t i = 0; i < values->second.size(); ++i) {
      if (*element != static_cast<double>(i + 1)) continue;
      values->second[i] = *value;
      return true;
    }
    return false;
  }

  // Reads the words after the speed: "FINE", "CNT50", "ACC80", "PTH"; others, as Offset, Tool_Offset or INC, change the
  // position, or, as Wjnt in lines, the configurations on the way.
  static Status readOptions(LineReader line, std::size_t number, ParsedMotion& motion) {
    line.number();
    line.skip(std::min(line.rest().find_first_of(" \t"), line.rest().size()));  // unit of the speed
    for (line.skipSpace(); !line.rest().empty(); line.skipSpace()) {
      const bool isJoint = motion.kind == ProgramMotion::Kind::Joint;
      if (line.takeWord("FINE") || (isJoint && line.takeWord("Wjnt")) || line.takeWord("PTH")) continue;
      LineReader valued = line;
      const bool isCorner = valued.take("CNT");
      const auto value = isCorner || valued.take("ACC") ? valued.number() : std::nullopt;
      if (!value || (isCorner && !(*value >= 0.0 && *value <= ProgramMotion::kLargestCorner)))
        return unread(line.rest(), number);
      if (isCorner) motion.corner = *value;
      line = valued;
    }
    return Done{};
  }

  const RobotProgram& m_program;
  std::map<double, std::array<double, 6>> m_registers;  // X, Y, Z, W, P, R in mm and degrees, by their numbers
  std::map<double, std::string> m_frameNames;
  std::optional<double> m_named;    // frame whose name is in the next remark
  std::map<double, Pose> m_frames;  // user frames in the base, by their numbers
  std::map<std::size_t, FanucPosition> m_positions;
  std::map<std::size_t, FanucConfiguration> m_configurations;  // by numbers of positions
  std::optional<ClosedFormIk> m_closed;
  std::vector<std::pair<std::size_t, ParsedMotion>> m_motions;  // by the numbers of their positions
  std::vector<ProgramLine> m_before;                            // lines before the first motion
  std::size_t m_open = 0;
  bool m_isInLines = true, m_isInPositions = false, m_isOwnGroup = true, m_isInOwnHead = false;
};

}  // namespace

std::string FanucPost::write(const RobotProgram& program) const {
  std::string name = identifierOf(program.name, kLongestFanucName);
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  const std::vector<std::string> head = headLines(program);
  std::string lines, positions;
  std::size_t count = 0;
  const auto addLine = [&](const std::string& line) {
    lines += "   " + std::to_string(++count) + ":  " + line + " ;\n";
  };
  const auto addKept = [&](const std::vector<ProgramLine>& kept) {
    for (const ProgramLine& each : kept) {
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
    positions +=
        "P[" + number + (remark.empty() ? "" : ":\"" + remark + "\"") + "]{\n" + positionText(program, motion) + "};\n";
  }
  return "/PROG  " + name + "\n/ATTR\nOWNER\t\t= MNEDITOR;\nCOMMENT\t\t= \"HANDWHEEL\";\nPROTECT\t\t= READ_WRITE;\n" +
         "LINE_COUNT\t= " + std::to_string(count) + ";\nDEFAULT_GROUP\t= 1,*,*,*,*;\n/MN\n" + lines + "/POS\n" +
         positions + "/END\n";
}

Result<std::vector<ParsedMotion>> FanucPost::read(std::string_view text, const RobotProgram& frame) const {
  const Result<std::vector<std::string_view>> lines =
      programLines(text, {});  // "!" begins remarks at the begin of lines only
  if (!lines) return lines.error();
  FanucReading reading(frame);
  for (const ProgramStatement& each : statementsOf(*lines)) {
    if (const Status read = reading.read(each); !read) return read.error();
  }
  return reading.motions();
}

}  // namespace handwheel
