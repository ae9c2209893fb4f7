// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/JsonText.h"
#include "robot/posts/ControllerPosts.h"
#include "robot/posts/PostText.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

std::vector<double> jointNumbers(const RobotProgram& program, const ProgramMotion& motion) {
  std::vector<double> numbers;
  for (Eigen::Index i = 0; i < motion.joints.size(); ++i) {
    const bool isSlide = program.arm.joints()[static_cast<std::size_t>(i)].isPrismatic;
    numbers.push_back(isSlide ? motion.joints[i] : motion.joints[i] / kRadiansPerDegree);
  }
  return numbers;
}

std::vector<double> poseNumbers(const Pose& pose) {
  const Vec3 at = pose.translation();
  const Eigen::Quaterniond turn = Eigen::Quaterniond(pose.linear()).normalized();
  return {at.x(), at.y(), at.z(), turn.w(), turn.x(), turn.y(), turn.z()};
}

// Returns none if these are not seven numbers, or the quaternion has no direction.
std::optional<Pose> poseOfNumbers(std::span<const double> n) {
  if (n.size() != 7) return std::nullopt;
  const Eigen::Quaterniond turn(n[3], n[4], n[5], n[6]);
  if (!(turn.norm() > 1e-3) || !(turn.norm() < 1e3)) return std::nullopt;
  Pose pose(Eigen::Translation3d(n[0], n[1], n[2]));
  pose.linear() = turn.normalized().toRotationMatrix();
  return pose;
}

constexpr std::string_view kCsvFrame = "# frame,";

struct CsvFrame {
  std::string name;
  std::optional<Pose> pose;
};

// Reads "# frame,NAME,x,y,z,qw,qx,qy,qz" before the motions: the frame; no pose: there is no such line.
CsvFrame csvFrame(const std::vector<std::string_view>& lines) {
  const auto found =
      std::find_if(lines.begin(), lines.end(), [](std::string_view line) { return line.starts_with(kCsvFrame); });
  if (found == lines.end()) return {};
  LineReader line(found->substr(kCsvFrame.size()), 0);
  const std::string name = readName(line.name());
  std::vector<double> numbers;
  while (line.take(",") && numbers.size() < 7) {
    const auto value = line.number();
    if (!value) return {};
    numbers.push_back(*value);
  }
  return {name, poseOfNumbers(numbers)};
}

constexpr const char* kCsvUnnamed = "place";

std::vector<std::string> textsOf(const std::vector<ProgramLine>& lines) {
  std::vector<std::string> texts;
  for (const ProgramLine& line : lines) texts.push_back(line.text);
  return texts;
}

const char* wordFor(ProgramMotion::Kind kind) {
  return kind == ProgramMotion::Kind::Joint ? "joint" : "linear";
}

// A line per motion: its end by joints in degrees (slides in mm), by the pose of the tool's centre point, and its speed
// and blend. The frame of the poses, if it is one of the cell, is in a line of its own.
class CsvPost : public PostProcessor {
 public:
  const char* id() const override { return "csv"; }
  const char* title() const override { return "CSV"; }
  const char* ending() const override { return ".csv"; }

  std::string write(const RobotProgram& program) const override {
    std::string text = "motion,name,kind,speed,blend_mm";
    for (Eigen::Index i = 0; i < program.arm.size(); ++i) {
      const bool isSlide = program.arm.joints()[static_cast<std::size_t>(i)].isPrismatic;
      text += ",q" + std::to_string(i + 1) + (isSlide ? "_mm" : "_deg");
    }
    text += ",x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
    for (const std::string& remark : program.remarks) text += "# " + remark + "\n";
    if (!program.frameName.empty())
      text += std::string(kCsvFrame) + identifierOf(program.frameName, 60) + "," +
              fixedList(poseNumbers(program.frame), 9) + "\n";
    text += keptTexts(program.head, "", "# ", "");
    for (std::size_t i = 0; i < program.motions.size(); ++i) {
      const ProgramMotion& motion = program.motions[i];
      const Pose pose = program.frame.inverse(Eigen::Isometry) * program.tipOf(motion);
      text += std::to_string(i + 1) + "," + identifierOf(motion.name.empty() ? kCsvUnnamed : motion.name, 60) + "," +
              wordFor(motion.kind) + "," + fixedText(motion.speed, 6) + "," + fixedText(motion.blend, 3) + "," +
              fixedList(jointNumbers(program, motion), 9) + "," + fixedList(poseNumbers(pose), 9) + "\n" +
              keptTexts(motion.lines, "", "# ", "");
    }
    return text;
  }

  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override {
    const Result<std::vector<std::string_view>> lines = programLines(text, "#");
    if (!lines) return lines.error();
    const CsvFrame inFrame = csvFrame(*programLines(text, {}));
    std::vector<ParsedMotion> motions;
    for (std::size_t i = 1; i < lines->size(); ++i) {  // after the heading
      LineReader line((*lines)[i], i + 1);
      line.skipSpace();
      if (line.rest().empty()) continue;
      if (motions.size() >= kMostMotions) return line.malformed("motion", "there are too many motions");
      const bool hasNumber = line.number() && line.take(",");
      const std::string_view name = line.name();
      if (!hasNumber || !line.take(",")) return line.malformed("motion", "a number and a name were expected");
      ParsedMotion motion{.line = i + 1, .frame = inFrame.pose, .frameName = inFrame.name};
      if (name != kCsvUnnamed) motion.name = readName(name);
      if (line.takeWord("linear"))
        motion.kind = ProgramMotion::Kind::Linear;
      else if (!line.takeWord("joint"))
        return line.malformed("motion", "joint or linear was expected");
      std::vector<double> numbers;
      while (line.take(",")) {
        const auto value = line.number();
        if (!value) return line.malformed("motion", "a number was expected");
        numbers.push_back(*value);
      }
      const auto count = static_cast<std::size_t>(frame.arm.size());
      if (numbers.size() != count + 9) return line.malformed("motion", "a number for each joint was expected");
      ArmValues joints(frame.arm.size());
      for (std::size_t k = 0; k < count; ++k)
        joints[static_cast<Eigen::Index>(k)] =
            numbers[k + 2] * (frame.arm.joints()[k].isPrismatic ? 1.0 : kRadiansPerDegree);
      motion.joints = joints;
      motion.blend = numbers[1];
      if (numbers[0] > 0.0) motion.speed = numbers[0];
      motions.push_back(std::move(motion));
    }
    return motions;
  }
};

class JsonPost : public PostProcessor {
 public:
  const char* id() const override { return "json"; }
  const char* title() const override { return "JSON"; }
  const char* ending() const override { return ".program.json"; }

  // One line per motion: with each number on a line of its own, long programs would be too large to be read.
  std::string write(const RobotProgram& program) const override {
    constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
    nlohmann::ordered_json json = {{"version", 1},
                                   {"name", program.name},
                                   {"robot", program.robot},
                                   {"tool", poseNumbers(program.tool)},
                                   {"frame", poseNumbers(program.frame)},
                                   {"frame_name", program.frameName},
                                   {"collision_shapes", program.hasPlainShapes ? "simplified" : "of the robot"}};
    if (program.clearance) json["clearance_mm"] = *program.clearance;
    if (!program.remarks.empty()) json["remarks"] = program.remarks;
    if (!program.head.empty()) json["comments"] = textsOf(program.head);
    // The numbers of an arm with slides are not all degrees.
    std::vector<std::string> units;
    for (const ArmJoint& joint : program.arm.joints()) units.emplace_back(joint.isPrismatic ? "mm" : "deg");
    const bool hasSlides = std::ranges::find(units, "mm") != units.end();
    if (hasSlides) json["q_units"] = units;
    const char* const shown = hasSlides ? "q_mm_deg" : "q_deg";
    std::string motions;
    for (const ProgramMotion& motion : program.motions) {
      const Pose pose = program.frame.inverse(Eigen::Isometry) * program.tipOf(motion);
      nlohmann::ordered_json one = {{"kind", wordFor(motion.kind)},
                                    {"name", motion.name},
                                    {"q", std::vector<double>(motion.joints.begin(), motion.joints.end())},
                                    {shown, jointNumbers(program, motion)},
                                    {"pose", poseNumbers(pose)},
                                    {"speed", motion.speed},
                                    {"blend_mm", motion.blend}};
      if (!motion.lines.empty()) one["comments"] = textsOf(motion.lines);
      motions += (motions.empty() ? "\n  " : ",\n  ") + one.dump(-1, ' ', false, kReplace);
    }
    std::string text = json.dump(1, ' ', false, kReplace);
    text.resize(text.size() - 2);  // without the closing brace
    return text + ",\n \"motions\": [" + motions + "\n ]\n}\n";
  }

  Result<std::vector<ParsedMotion>> read(std::string_view text, const RobotProgram& frame) const override {
    if (const Status fits = checkTextSize(text); !fits) return fits.error();
    const Result<nlohmann::json> json = parseJson(text, "program");
    if (!json) return json.error();
    const auto wrong = [](const char* reason) {
      return Error{ErrorCode::ElementMalformed, {"motions", reason}, {}, {}};
    };
    const auto list = json->is_object() ? json->find("motions") : json->end();
    if (!json->is_object() || list == json->end() || !list->is_array() || list->size() > kMostMotions)
      return wrong("a list was expected");
    const std::optional<Pose> inFrame = poseOfNumbers(numbersAt(*json, "frame", 7));
    const std::string name = readName(stringAt(*json, "frame_name"));
    std::vector<ParsedMotion> motions;
    for (const nlohmann::json& each : *list) {
      const std::vector<double> q = numbersAt(each, "q", static_cast<std::size_t>(frame.arm.size()));
      if (static_cast<Eigen::Index>(q.size()) != frame.arm.size()) return wrong("a number for each joint was expected");
      ParsedMotion motion{.frame = inFrame, .frameName = name};
      motion.name = readName(stringAt(each, "name"));
      motion.kind = stringAt(each, "kind") == "linear" ? ProgramMotion::Kind::Linear : ProgramMotion::Kind::Joint;
      motion.joints = Eigen::Map<const Eigen::VectorXd>(q.data(), frame.arm.size());
      if (const auto blend = each.find("blend_mm"); blend != each.end() && blend->is_number())
        motion.blend = blend->get<double>();
      if (const auto speed = each.find("speed");
          speed != each.end() && speed->is_number() && speed->get<double>() > 0.0)
        motion.speed = speed->get<double>();
      motions.push_back(std::move(motion));
    }
    return motions;
  }
};

}  // namespace

std::unique_ptr<PostProcessor> makeCsvPost() {
  return std::make_unique<CsvPost>();
}

std::unique_ptr<PostProcessor> makeJsonPost() {
  return std::make_unique<JsonPost>();
}

}  // namespace handwheel
