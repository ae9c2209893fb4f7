// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PathExport.h"

#include "base/JsonText.h"
#include "base/NumberText.h"
#include "document/AtomicFile.h"
#include "document/DocumentErrors.h"
#include "document/FileBytes.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellFrames.h"
#include "document/scene/BodyChanges.h"
#include "planning/CartesianLine.h"
#include "robot/ControllerBaseFrame.h"
#include "robot/arm/NumericalIk.h"
#include "robot/dh/DhTable.h"
#include "robot/posts/ControllerConfiguration.h"
#include "robot/posts/PostErrors.h"
#include "robot/posts/PostText.h"
#include "robot/program/PathFile.h"
#include "tools/cell/path/ProgramFrames.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr double kMostOff = 1e-3;  // mm, degrees

std::optional<Error> problemOf(const CellScene& scene, const RobotPath& path, const CheckedPath& checked) {
  if (checked.isProvenAsWritten()) return std::nullopt;
  if (checked.resolved.stopsAt) {
    const std::string waypoint = std::to_string(*checked.resolved.stopsAt + 1);
    return Error{CellError::LineUnreachable, {waypoint, roundedText(100.0 * checked.resolved.reached, 3)}, {}, {}};
  }
  if (checked.verification.isCertified()) {
    const auto open = std::ranges::find(checked.missing, MissingShape::State::Open, &MissingShape::state);
    if (open != checked.missing.end())
      return Error{CellError::ShapeMissing, {path.name, open->name, open->what}, {}, {}};
  }
  const auto& collisions = checked.verification.collisions;
  if (collisions.empty() && !checked.gaps.empty()) {  // those of zones come last
    const ProofGap& gap = checked.gaps.front();
    const std::string number = std::to_string(gap.waypoint + 1);
    return gap.kind == ProofGap::Kind::Corner ? Error{CellError::CornerNotProven, {path.name, number}, {}, {}}
                                              : Error{CellError::CarriedUnknown, {path.name, number, gap.text}, {}, {}};
  }
  const auto [link, other] =
      collisions.empty() ? std::pair<std::string, std::string>() : scene.namesOf(collisions.front().deepest);
  return Error{CellError::PathCollides, {path.name, std::to_string(collisions.size()), link, other}, {}, {}};
}

std::optional<Error> outdatedProblem(const RobotPath& path, const OutdatedReasons& outdated) {
  if (!outdated.part.empty()) return Error{CellError::PathOutdated, {path.name, outdated.part}, {}, {}};
  if (outdated.isBaseOther) return Error{CellError::PathBaseMoved, {path.name}, {}, {}};
  if (outdated.isToolOther) return Error{CellError::PathToolChanged, {path.name}, {}, {}};
  if (!outdated.targets.empty())
    return Error{CellError::PathTargetMoved, {path.name, *outdated.targets.begin()}, {}, {}};
  if (!outdated.frames.empty()) return Error{CellError::PathFrameMoved, {path.name, *outdated.frames.begin()}, {}, {}};
  if (outdated.configurations.empty()) return std::nullopt;
  return Error{CellError::PathWaypointChanged, {path.name, *outdated.configurations.begin()}, {}, {}};
}

std::string otherRobot(const CellScene& scene, const PostProcessor& post) {
  const LibraryRobot* const robot = libraryRobot(scene.plannedArm().title);
  return robot && !std::string_view(robot->title).starts_with(post.maker()) ? robot->title : "";
}

// Returns how long a joint motion takes at the largest speeds, s.
double fastestOf(const SerialArm& arm, const ArmValues& from, const ArmValues& to) {
  double fastest = 0.0;
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    const ArmJoint& joint = arm.joints()[static_cast<std::size_t>(i)];
    const double usual = joint.isPrismatic ? 1e3 : M_PI;  // mm/s, rad/s
    fastest = std::max(fastest, std::abs(to[i] - from[i]) / joint.velocity.value_or(usual));
  }
  return fastest;
}

// The share of the largest joint speeds at which the tool's centre point takes a joint motion with this speed (mm/s) on
// average. None: it stays where it is.
std::optional<double> shareFor(const SerialArm& arm, const Pose& tool, const ArmValues& from, const ArmValues& to,
                               double toolSpeed) {
  constexpr int kParts = 32;
  double length = 0.0;  // mm
  Vec3 before = (arm.tipPose(from) * tool).translation();
  for (int i = 1; i <= kParts; ++i) {
    const ArmValues at = from + (static_cast<double>(i) / kParts) * (to - from);
    const Vec3 now = (arm.tipPose(at) * tool).translation();
    length += (now - before).norm();
    before = now;
  }
  constexpr double kLeastLength = 1e-3;  // mm
  if (length < kLeastLength) return std::nullopt;
  return fastestOf(arm, from, to) * toolSpeed / length;
}

// Sets the speed at which a motion takes the duration of its waypoint on average, for languages that have no durations.
void setAverageSpeed(const RobotProgram& program, const ArmValues& from, const ArmValues& to, Waypoint& waypoint) {
  const auto toolAt = [&](const ArmValues& values) {
    return Vec3((program.arm.tipPose(values) * program.tool).translation());
  };
  const double length = (toolAt(to) - toolAt(from)).norm();
  constexpr double kLeastLength = 1e-3;  // mm
  if (waypoint.motion == ProgramMotion::Kind::Linear && length > kLeastLength)
    waypoint.speed = std::clamp(length / waypoint.seconds, 1e-3, 1e5);
  if (waypoint.motion == ProgramMotion::Kind::Joint)
    waypoint.speed = std::clamp(fastestOf(program.arm, from, to) / waypoint.seconds, 1e-3, 1.0);
}

// Returns the speed in the range of paths: of a joint motion 0.001 to 1, of a line up to 100 m/s.
double speedOf(const ParsedMotion& motion, ProgramMotion::Kind kind, std::optional<double> share) {
  if (kind == ProgramMotion::Kind::Linear) return std::clamp(motion.speed.value_or(250.0), 1e-3, 1e5);
  const std::optional<double> own = motion.kind == kind ? motion.speed : std::nullopt;
  return std::clamp(own ? *own : share.value_or(Waypoint().speed), 1e-3, 1.0);
}

// Returns true if the arm ends a line, with its tip there, in the configuration that the controller demands: with these
// joint values, which are the nearest ones, or, if these are of another configuration, with others, which replace them.
// The first motion of a program is no line here, and may end in any configuration.
bool endsInItsConfiguration(const ParsedMotion& motion, const Pose& tip, const RobotProgram& program,
                            const ArmValues& from, bool isFirst, ArmValues& joints) {
  if (hasConfiguration(*motion.endsIn, program.arm, joints)) return true;
  const auto closed = closedFormOfSphericalWrist(program.arm);
  const auto other = closed ? jointsWith(*motion.endsIn, program.arm, *closed, tip, from) : std::nullopt;
  const bool isReached = other && (isFirst || followLine(program.arm, program.tool, from, *other).reached >= 1.0);
  if (isReached) joints = *other;
  return isReached;
}

// The error of a place at which the axis that the controller counts from the level is beyond its limits.
Error coupledProblem(const CellScene& scene, const AxisCoupling& coupling, const ArmValues& at) {
  const auto name = [&](std::size_t joint) { return scene.robot->model.jointOfDof(scene.dofs[joint]).name; };
  const auto degrees = [](double angle) { return roundedText(angle / kRadiansPerDegree, 5); };
  return {CellError::CoupledBeyondLimits,
          {name(2), coupling.factor < 0.0 ? "-" : "+", name(1), degrees(coupling.third(at)), degrees(coupling.lower),
           degrees(coupling.upper)},
          {},
          {}};
}

// Compares with the precision of programs: hundredths of mm and degrees.
bool isSameTool(const Pose& a, const Pose& b) {
  constexpr double kSameTool = 0.02;  // mm, degrees
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(a.linear().transpose() * b.linear()));
  return (a.translation() - b.translation()).norm() <= kSameTool &&
         std::abs(turn.angle()) <= kSameTool * kRadiansPerDegree;
}

// The frames of the cell that the robot does not move.
std::vector<ProgramFrame> framesBeside(const CellScene& scene, const RobotCellSnapshot& cell) {
  const RobotModel& robot = cell.robot->model;
  const Pose toBase = basePose(robot, scene.plannedArm()).inverse(Eigen::Isometry);
  std::vector<ProgramFrame> frames;
  for (const NamedFrame& frame : cell.plans->frames) {
    const Result<Pose> pose = poseOfFrame(frame, {*cell.plans, cell.bodies, robot, cell.joints});
    if (pose && !movesWith(frame, cell.bodies, robot, scene.dofs)) frames.push_back({frame.name, toBase * *pose});
  }
  return frames;
}

// Returns the results of the check with the blends that a program has in a language.
Result<CheckedPath> withBlendsOf(const PostProcessor& post, const RobotProgram& program, const CheckedPath& checked) {
  CheckedPath written = checked;
  if (std::ranges::all_of(checked.blends, [](double blend) { return blend == 0.0; })) return written;
  const Result<std::vector<ParsedMotion>> motions = post.read(post.write(program), program);
  if (!motions) return motions.error();
  for (std::size_t i = 0; i < std::min(motions->size(), written.blends.size()); ++i)
    written.blends[i] = std::min(written.blends[i], std::max(0.0, (*motions)[i].blend));
  return written;
}

void addBlendRemarks(RobotProgram& program, std::size_t stopped, std::size_t stopsOfLanguage,
                     std::span<const SmallerBlend> smaller, const std::string& language) {
  if (const std::string blends = smallerBlendsText(smaller); !blends.empty()) program.remarks.push_back(blends);
  if (stopped > 0)
    program.remarks.push_back("Exact stops in place of blends: " + std::to_string(stopped) +
                              ". Not every way within their zones is proven free.");
  if (stopsOfLanguage > 0)
    program.remarks.push_back("Exact stops in place of blends: " + std::to_string(stopsOfLanguage) + ". In " +
                              language + " they have no blend.");
}

std::string leftOutText(std::span<const std::size_t> lines) {
  constexpr std::size_t kMostListed = 20;
  std::string list;
  for (const std::size_t line : lines.first(std::min(lines.size(), kMostListed)))
    list += (list.empty() ? "" : ", ") + std::to_string(line);
  if (lines.size() > kMostListed) list += " and " + std::to_string(lines.size() - kMostListed) + " more";
  return "Lines of the opened program that are left out here, as outputs and waiting: " + list + ".";
}

// Returns true if a text in JSON is a program (of the post "json") and no path file, whatever the name of the file.
bool isProgramTable(std::string_view text) {
  if (text.find("\"motions\"") == text.npos) return false;
  const Result<nlohmann::json> json = parseJson(text, "program");
  return json && json->is_object() && json->contains("motions") && !json->contains("places") &&
         !json->contains("waypoints");
}

// Drops the declarations of the lines of a program, which other languages do not need.
void dropDeclarations(RobotProgram& program) {
  const auto isDeclaration = [](const ProgramLine& line) { return line.kind == ProgramLine::Kind::Declaration; };
  std::erase_if(program.head, isDeclaration);
  for (ProgramMotion& motion : program.motions) std::erase_if(motion.lines, isDeclaration);
}

// Returns an arm that is counted from another base. base: pose of that in the present base.
SerialArm countedFrom(const Pose& base, const SerialArm& arm) {
  std::vector<ArmJoint> joints(arm.joints().begin(), arm.joints().end());
  if (!joints.empty()) joints.front().before = base.inverse(Eigen::Isometry) * joints.front().before;
  return SerialArm(std::move(joints), arm.tip()).withCoupling(arm.coupling());
}

// Returns the first joint without limits that a motion turns by more than half a turn, and the turn in degrees. Paths
// of such joints take the shorter way.
std::optional<std::pair<std::string, double>> longTurn(const CellScene& scene, const ArmValues& from,
                                                       const ArmValues& to) {
  const ArmValues shortest = byShortestTurn(scene.scene, from, to);
  for (Eigen::Index i = 0; i < to.size(); ++i) {
    if (shortest[i] != to[i])
      return std::pair(scene.robot->model.jointOfDof(scene.dofs[static_cast<std::size_t>(i)]).name,
                       std::abs(to[i] - from[i]) / kRadiansPerDegree);
  }
  return std::nullopt;
}

// Reads the file of this name in a folder, whatever the case of its letters; empty if there is none.
std::string dataIn(const std::filesystem::path& folder, const std::string& name) {
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    if (lowerCase(entry.path().filename().string()) != lowerCase(name)) continue;
    const Result<std::string> bytes = readFileHead(entry.path(), PostProcessor::kLargestText);
    const Result<std::string> text = bytes ? programText(*bytes) : bytes;
    if (text) return *text + "\n";
  }
  return {};
}

}  // namespace

Result<Pose> programFrame(const CellScene& scene, const CellPlans& plans) {
  if (plans.workFrame.empty()) return Pose(Pose::Identity());
  const RobotModel& robot = scene.robot->model;
  const Result<Pose> pose = poseOfFrame(plans.workFrame, {plans, scene.bodies, robot, scene.others});
  if (!pose) return pose;
  if (movesWith(*plans.frame(plans.workFrame), scene.bodies, robot, scene.dofs))
    return Error{CellError::FrameMoves, {plans.workFrame}, {}, {}};
  return Pose(basePose(robot, scene.plannedArm()).inverse(Eigen::Isometry) * *pose);
}

// Descriptions name the model only, as "ur5_robot".
const PostProcessor& usualPost(const RobotArm& arm) {
  std::string plain;
  for (const char letter : arm.title) {
    const bool isPlain = (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z');
    const bool isCapital = letter >= 'A' && letter <= 'Z';
    if (isPlain || isCapital) plain += isCapital ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  const auto isOf = [&](const LibraryRobot& robot) {
    return arm.title == robot.title || plain.find(robot.id) != std::string::npos;
  };
  const auto known = std::find_if(robotLibrary().begin(), robotLibrary().end(), isOf);
  const std::string_view title = known == robotLibrary().end() ? std::string_view(arm.title) : known->title;
  const auto suits = [&](const auto& post) {
    const std::string_view maker = post->maker();
    return !maker.empty() && title.starts_with(maker);
  };
  const auto own = std::find_if(posts().begin(), posts().end(), suits);
  if (own != posts().end()) return **own;
  const auto any =
      std::find_if(posts().begin(), posts().end(), [](const auto& post) { return *post->maker() == '\0'; });
  return any == posts().end() ? *posts().front() : **any;
}

Status canBeWritten(const CellScene& scene, const PostProcessor& post) {
  RobotProgram program;
  program.robot = scene.plannedArm().title;
  program.arm = scene.armFromBase();
  const std::vector<Error> refusals = post.refusals(program);
  return refusals.empty() ? Status(Done{}) : Status(refusals.front());
}

Result<WrittenProgram> writeProgram(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const CheckedPath& checked, const PostProcessor& post,
                                    const std::filesystem::path& output, const WriteChoices& choices) {
  if (const auto problem = problemOf(scene, path, checked)) return *problem;
  if (choices.outdated == OutdatedPath::Refuse) {
    if (const auto problem = outdatedProblem(path, checked.outdated)) return *problem;
  }
  const Result<Pose> frame = programFrame(scene, plans);
  if (!frame) return frame.error();
  RobotProgram program = programOf(scene, plans, path, checked);
  program.frame = *frame;
  if (const auto base = controllerBaseFrame(scene.robot->model, scene.plannedArm())) {
    program.arm = countedFrom(*base, program.arm);
    program.frame = base->inverse(Eigen::Isometry) * program.frame;
    program.isBaseOfController = true;
  }
  if (program.language != post.id()) dropDeclarations(program);
  program.frameName = plans.workFrame;
  for (const NamedFrame& other : plans.frames) {
    if (other.name != plans.workFrame) program.otherFrames.push_back(other.name);
  }
  for (const RobotPath& other : plans.paths) {
    if (other.name != path.name) program.otherPaths.push_back(other.name);
  }
  program.declaresFrame = choices.frameData == FrameData::InProgram;
  const std::string other = otherRobot(scene, post);
  constexpr std::size_t kLongestName = 60;
  if (!other.empty())
    program.remarks.push_back("Warning: this is not the language of the controller of the robot " +
                              identifierOf(other, kLongestName) + ".");
  if (!choices.leftOut.empty()) program.remarks.push_back(leftOutText(choices.leftOut));
  if (const std::vector<Error> refusals = post.refusals(program); !refusals.empty()) return refusals.front();
  // The language decides which of the proven blends it has.
  const Result<CheckedPath> written = withBlendsOf(post, program, checked);
  if (!written) return written.error();
  const std::size_t stopped = stoppedBlends(path, checked);
  const std::size_t stopsOfLanguage = stoppedBlends(path, *written) - stopped;
  const std::vector<SmallerBlend> smaller = smallerBlends(path, *written);
  addBlendRemarks(program, stopped, stopsOfLanguage, smaller, post.title());
  const std::string text = post.write(program);
  const Result<PostCheck> check = checkWritten(post, program, text);
  if (!check) return check.error();
  if (check->distance > kMostOff || check->angle > kMostOff)
    return Error{DocumentError::CheckFailed, {std::string("the ") + post.title() + " program"}, {}, output.string()};
  if (const Status stored = writeFileAtomically(output, text, {}); !stored) return stored.error();
  // Joint motions do not depend on the frame, but tables have the pose of each waypoint.
  const bool isInFrame = check->isInFrame && (post.maker()[0] == '\0' || hasLines(program));
  const double seconds =
      timed(scene, plans, path, written->resolved, written->blends).duration() + waitingTimeOf(path).seconds;
  return WrittenProgram{*check, stopped, stopsOfLanguage, smaller, seconds, other, isInFrame ? plans.workFrame : ""};
}

Result<ProgramPath> pathFromProgram(const CellScene& scene, const RobotCellSnapshot& cell, const PostProcessor& post,
                                    std::string_view text, Progress progress, std::string data) {
  RobotProgram frame;
  const std::optional<Pose> controllers = controllerBaseFrame(cell.robot->model, scene.plannedArm());
  const Pose counted = controllers.value_or(Pose(Pose::Identity()));  // base of the program
  frame.robot = scene.plannedArm().title;
  frame.arm = countedFrom(counted, scene.armFromBase());
  frame.tool = cell.plans->tool;
  frame.knownFrames = framesBeside(scene, cell);
  for (ProgramFrame& each : frame.knownFrames) each.pose = counted.inverse(Eigen::Isometry) * each.pose;
  frame.data = std::move(data);
  const auto home = std::ranges::find_if(cell.plans->configurations, [&](const NamedConfiguration& each) {
    return lowerCase(each.name) == "home" && armNumber(*cell.robot, each.arm) == scene.armNumber;
  });
  if (home != cell.plans->configurations.end()) frame.home = scene.planned(home->joints);
  for (const NamedFrame& each : cell.plans->frames) frame.otherFrames.push_back(each.name);
  // Readers of controllers with six joints count on six.
  if (const std::vector<Error> refusals = post.refusals(frame); !refusals.empty()) return refusals.front();
  Result<std::vector<ParsedMotion>> motions = post.read(text, frame);
  if (!motions) return motions.error();
  RobotPath path{"program", {}, cell.plans->arm};
  path.clearance = keptClearance(text);
  std::vector<std::size_t> openConfigurations;
  std::optional<Pose> otherTool, firstTool;
  bool isOnlyTool = true;
  ArmValues before = scene.planned(cell.joints);
  std::vector<std::size_t> leftOut;
  if (!motions->empty()) leftOut = std::move(motions->front().leftOut);
  for (ParsedMotion& motion : *motions) {
    if (motion.isConfigurationOpen) openConfigurations.push_back(motion.line);
    if (!otherTool && motion.tool && !isSameTool(*motion.tool, frame.tool)) otherTool = motion.tool;
    if (!firstTool) firstTool = motion.tool;
    if (motion.tool && !isSameTool(*motion.tool, *firstTool)) isOnlyTool = false;
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    progress.set(static_cast<double>(path.waypoints.size()) / static_cast<double>(motions->size()));
    const ArmValues from = before;
    const auto located = [&](Error error) {
      error.position = InputPosition::line(motion.line);
      return error;
    };
    if (motion.isInControllersBase && !controllers)
      return located({PostError::BaseUnknown, {scene.plannedArm().title}, {}, {}});
    const bool isSound = motion.joints ? motion.joints->size() == scene.arm.size() && motion.joints->allFinite()
                                       : motion.pose && motion.pose->matrix().allFinite();
    if (!isSound)
      return located({ErrorCode::ElementMalformed, {"motion", "a number for each joint was expected"}, {}, {}});
    if (motion.joints) {
      before = *motion.joints;
      if (const auto turned = longTurn(scene, from, before); turned && !path.waypoints.empty())
        return located({PostError::TurnsTooFar, {turned->first, roundedText(turned->second, 4)}, {}, {}});
    } else {
      const Pose tip = *motion.pose * frame.tool.inverse(Eigen::Isometry);
      const NumericalIkResult found = solvedNumerically(frame.arm, tip, before, {.tolerance = 1e-8, .seconds = 0.05});
      if (!found.isSolved)
        return located({CellError::PoseUnreachable, {std::to_string(path.waypoints.size() + 1)}, {}, {}});
      before = found.values;
      if (motion.endsIn && !endsInItsConfiguration(motion, tip, frame, from, path.waypoints.empty(), before))
        return located({PostError::ConfigurationDiffers, {motion.endsIn->text()}, {}, {}});
    }
    Result<JointValues> within = valuesWithinLimits(cell.robot->model, scene.whole(before));
    if (!within) return located(within.error());
    constexpr double kRounding = 1e-6;  // rad: of files
    if (const auto& coupling = scene.arm.coupling(); coupling && !coupling->isWithin(before, kRounding))
      return located(coupledProblem(scene, *coupling, before));
    Waypoint waypoint{.joints = std::move(within).value()};
    if (isBodyName(motion.name)) waypoint.name = std::move(motion.name);
    waypoint.motion = path.waypoints.empty() ? ProgramMotion::Kind::Joint : motion.kind;
    const bool hasShare = motion.toolSpeed && !path.waypoints.empty();
    waypoint.speed =
        speedOf(motion, waypoint.motion,
                hasShare ? shareFor(frame.arm, frame.tool, from, before, *motion.toolSpeed) : std::nullopt);
    waypoint.blend = std::max(0.0, motion.blend);
    waypoint.corner = motion.corner;
    waypoint.seconds = path.waypoints.empty() ? 0.0 : motion.seconds;
    if (waypoint.seconds > 0.0) setAverageSpeed(frame, from, before, waypoint);
    if (path.waypoints.empty()) path.head = std::move(motion.before);
    waypoint.lines = std::move(motion.lines);
    path.waypoints.push_back(std::move(waypoint));
  }
  if (*post.maker()) path.language = post.id();
  std::sort(openConfigurations.begin(), openConfigurations.end());
  openConfigurations.erase(std::unique(openConfigurations.begin(), openConfigurations.end()), openConfigurations.end());
  const Pose base = basePose(cell.robot->model, scene.plannedArm()) * counted;
  ProgramPath read{std::move(path), framesOf(*motions, base), std::move(openConfigurations), otherTool,
                   isOnlyTool,      std::move(leftOut)};
  // Joint values are in no frame, but tables have the pose of each waypoint.
  for (const ParsedMotion& motion : *motions) {
    const bool isInFrame = motion.pose || motion.isAtPose || *post.maker() == '\0';
    read.frameOf.push_back(isInFrame ? frameNumber(read.frames, motion, base) : read.frames.size());
  }
  return read;
}

Result<ProgramPath> pathFromFile(const CellScene& scene, const RobotCellSnapshot& cell,
                                 const std::filesystem::path& file, Progress progress) {
  const auto read = [&]() -> Result<ProgramPath> {
    const Result<std::string> bytes = readFileHead(file, PostProcessor::kLargestText + 1);  // Larger ones are refused
    if (!bytes) return bytes.error();
    const PostProcessor* const ofName = postForEnding(file.string());
    if (const PostProcessor* const post = ofName || !isProgramTable(*bytes) ? ofName : postCalled("json")) {
      std::string data;
      const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
      if (post->id() == std::string_view("krl"))
        data = dataIn(folder, file.stem().string() + ".dat") + dataIn(folder, "$config.dat");
      Result<ProgramPath> program = pathFromProgram(scene, cell, *post, *bytes, progress, std::move(data));
      if (program) program->path.name = file.stem().string();
      return program;
    }
    Result<RobotPath> path = readPath(*bytes, cell.robot->model, cell.joints, dofsOfArm(*cell.robot, scene.armNumber));
    if (!path) return path.error();
    return ProgramPath{std::move(path).value()};
  };
  Result<ProgramPath> made = read();
  if (!made) {
    Error error = made.error();
    error.subject = file.string();
    return error;
  }
  made->path.arm = cell.plans->arm;  // a file may have been made for a robot of another name
  return made;
}

}  // namespace handwheel
