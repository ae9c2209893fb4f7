// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/PlanningBenchmark.h"

#include "base/NumberText.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/OperationOptions.h"
#include "cli/ReportJson.h"
#include "cli/cell/PlanningFiles.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "planning/PathShortcuts.h"
#include "planning/planners/Planners.h"
#include "robot/UrdfReader.h"

#include <QtGlobal>
#include <algorithm>
#include <chrono>
#include <numeric>

namespace handwheel {

namespace {

Parameter fileParameter(const char* id, const char* value, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = ""},
          .meaning = std::move(meaning),
          .word = value,
          .hasDefault = false};
}

Parameter numberParameter(const char* id, const char* value, double standard, double largest, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = standard, .least = 0.0, .largest = largest},
          .meaning = std::move(meaning),
          .word = value};
}

Parameter switchParameter(const char* id, std::string meaning) {
  return {.property = {.id = id, .group = {}, .label = {}, .value = false}, .meaning = std::move(meaning)};
}

Parameter plannerParameter() {
  Parameter parameter = {.property = {.id = "planner", .group = {}, .label = {}, .value = 0.0},
                         .meaning = "Planner of the paths",
                         .word = "PLANNER"};
  for (const PlannerName& planner : planners()) {
    parameter.property.choices.emplace_back(planner.title);
    parameter.words.emplace_back(planner.id);
  }
  return parameter;
}

const Operation& benchmarkOperation() {
  static const Operation kOperation = [] {
    Operation made = {
        .id = "benchmark-planning",
        .title = QT_TRANSLATE_NOOP("Tool", "Planning benchmark"),
        .meaning = "Plans the paths of a set of problems and measures them",
        .parameters = {fileParameter("robot", "URDF", "The robot; its collision shapes count"),
                       fileParameter("srdf", "FILE", "The pairs of its links that may touch"),
                       fileParameter("paths", "DIR", "A folder to write each path to, as JSON"), plannerParameter(),
                       numberParameter("time", "S", 2.0, 3600.0, "Time after which a problem is given up, in seconds"),
                       numberParameter("clearance", "MM", 0.0, 1e4, "Clearance from all obstacles"),
                       switchParameter("own-overlaps",
                                       "In each problem, links of the robot that overlap at the start or the goal may "
                                       "overlap on the whole path; the report names them"),
                       numberParameter("seed", "N", 1.0, 1e9, "Seed of the random numbers")}};
    made.parameters.back().isWhole = true;
    return made;
  }();
  return kOperation;
}

// Two links of the robot that overlap where a path begins or ends.
struct OwnOverlap {
  bool isAtGoal;
  LinkPair links;
  double depth;  // mm
};

struct PlannedProblem {
  std::string name;
  PlanResult result;
  JointPath path;            // made shorter
  double planning = 0.0;     // s, until there was a path
  double seconds = 0.0;      // until it was made shorter, too
  double length = 0.0;       // rad
  bool isCertified = false;  // but for the overlaps, if they are allowed
  std::vector<OwnOverlap> overlaps = {};
  bool areAllowed = false;  // the overlaps
};

const char* wordFor(PlanResult::Outcome outcome) {
  switch (outcome) {
    case PlanResult::Outcome::Solved:
      return "solved";
    case PlanResult::Outcome::StartBlocked:
      return "start_in_collision";
    case PlanResult::Outcome::GoalBlocked:
      return "goal_in_collision";
    case PlanResult::Outcome::OutOfLimits:
      return "out_of_limits";
    case PlanResult::Outcome::TimeOut:
      return "time_out";
    case PlanResult::Outcome::Cancelled:
      return "cancelled";
  }
  return "";
}

// A robot that plans, without obstacles.
struct BenchmarkRobot {
  RobotModel model;
  std::set<LinkPair> allowed;
  std::vector<std::uint32_t> dofs;
  std::set<LinkPair> alwaysMeeting;

  RobotScene scene() const {
    RobotScene made(model, Pose::Identity(), collisionBodies(model), dofs, restValues(model), allowed);
    made.allowPairs(alwaysMeeting);
    return made;
  }
};

Result<BenchmarkRobot> readRobot(const OperationValues& values, const PlanningSet& set) {
  const auto subject = [](Error error, const std::string& file) {
    error.subject = file;
    return error;
  };
  const std::string file = values.text("robot");
  const Result<std::string> bytes = readFileBytes(file);
  if (!bytes) return subject(bytes.error(), file);
  Result<ImportedRobot> read = readUrdf(*bytes);
  if (!read) return subject(read.error(), file);
  BenchmarkRobot robot{std::move(read->robot), {}, {}, {}};
  robot.allowed = neighbours(robot.model);
  if (values.isSet("srdf")) {
    const std::string semantics = values.text("srdf");
    const Result<std::string> text = readFileBytes(semantics);
    if (!text) return subject(text.error(), semantics);
    Result<RobotSemantics> found = readSrdf(*text, robot.model);
    if (!found) return subject(found.error(), semantics);
    robot.allowed.merge(found->allowed);
  }
  for (const std::string& joint : set.joints) {
    const auto& dofs = robot.model.dofs;
    const auto found =
        std::find_if(dofs.begin(), dofs.end(), [&](std::uint32_t j) { return robot.model.joints[j].name == joint; });
    if (found == dofs.end()) return Error{ErrorCode::ReferenceMissing, {"joint", joint, {}}, {}, file};
    robot.dofs.push_back(static_cast<std::uint32_t>(found - dofs.begin()));
  }
  const RobotScene scene = robot.scene();
  if (const Status sound = scene.isSound(); !sound) return subject(sound.error(), file);
  robot.alwaysMeeting = scene.alwaysMeeting();
  return robot;
}

ArmValues valuesOf(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

// Leaves out what a scene of MoveIt allows to touch. What is not in the robot, as its gripper, counts for nothing.
void allowNamed(RobotScene& scene, const RobotModel& model, const PlanningProblem& problem) {
  std::set<LinkPair> pairs;
  for (const auto& [first, second] : problem.allowed) {
    const std::uint32_t a = linkNamed(model, first), b = linkNamed(model, second);
    if (a != kNone && b != kNone) pairs.insert(std::minmax(a, b));
    if ((a == kNone) == (b == kNone)) continue;
    for (std::size_t i = 0; i < problem.names.size(); ++i) {
      if (problem.names[i] == (a == kNone ? first : second))
        scene.allow(a == kNone ? b : a, static_cast<std::uint32_t>(i));
    }
  }
  scene.allowPairs(pairs);
}

std::vector<OwnOverlap> ownOverlaps(const RobotScene& scene, const PlanningProblem& problem) {
  std::vector<OwnOverlap> all;
  for (const bool isGoal : {false, true}) {
    for (const RobotScene::Nearest& each : scene.overlappingLinks(valuesOf(isGoal ? problem.goal : problem.start)))
      all.push_back({isGoal, std::minmax(each.link, each.otherLink), 0.0 - each.distance});
  }
  return all;
}

bool isCertified(const RobotScene& scene, const JointPath& path, const MotionCheckSettings& check,
                 const Progress& progress) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (MotionCheck(scene, path[i - 1], path[i], check).run(progress) != MotionCheck::State::Free) return false;
  }
  return path.size() > 1;
}

PlannedProblem planned(const PlanningProblem& problem, const BenchmarkRobot& robot, const OperationValues& values,
                       Progress progress) {
  RobotScene scene = robot.scene();
  for (std::size_t i = 0; i < problem.obstacles.size(); ++i)
    scene.addObstacle(CollisionBody({problem.obstacles[i]}), Pose::Identity(), static_cast<std::uint32_t>(i));
  allowNamed(scene, robot.model, problem);
  PlannedProblem made{problem.name, {}, {}};
  made.overlaps = ownOverlaps(scene, problem);
  made.areAllowed = values.flag("own-overlaps") && !made.overlaps.empty();
  if (made.areAllowed) {
    std::set<LinkPair> pairs;
    for (const OwnOverlap& each : made.overlaps) pairs.insert(each.links);
    scene.allowPairs(pairs);
  }
  PlanSettings settings;
  settings.seconds = values.number("time");
  settings.seed = values.whole("seed");
  settings.check.clearance = values.number("clearance");
  constexpr int kRounds = 50;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  const auto since = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  made.result = planPath(scene, valuesOf(problem.start), valuesOf(problem.goal), settings,
                         planners()[values.whole("planner")].id, progress);
  made.planning = since();
  made.path = shortened(scene, made.result.path, settings.check, kRounds, settings.seconds, settings.seed, progress);
  made.seconds = since();
  made.isCertified = isCertified(scene, made.path, settings.check, progress);
  made.length = lengthOf(scene, made.path);
  return made;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

nlohmann::ordered_json toJson(const BenchmarkRobot& robot, const PlannedProblem& problem) {
  nlohmann::ordered_json json = {{"name", problem.name},
                                 {"outcome", wordFor(problem.result.outcome)},
                                 {"certified", problem.isCertified && !problem.areAllowed},
                                 {"planning_seconds", problem.planning},
                                 {"seconds", problem.seconds},
                                 {"length_rad", problem.length},
                                 {"waypoints", problem.path.size()},
                                 {"milestones", problem.result.milestones},
                                 {"checks", problem.result.steps},
                                 {"distances", problem.result.queries.exact}};
  const auto nameOf = [&](std::uint32_t link) { return robot.model.links[link].name; };
  for (const OwnOverlap& each : problem.overlaps) {
    json["own_overlaps"].push_back({{"links", {nameOf(each.links.first), nameOf(each.links.second)}},
                                    {"at", each.isAtGoal ? "goal" : "start"},
                                    {"depth_mm", each.depth},
                                    {"allowed", problem.areAllowed}});
  }
  if (problem.areAllowed) json["certified_but_for_overlaps"] = problem.isCertified;
  return json;
}

nlohmann::ordered_json toJson(const PlanningSet& set, const BenchmarkRobot& robot,
                              const std::vector<PlannedProblem>& all, const std::string& planner) {
  std::vector<double> seconds, planning, checks, distances, lengths;
  std::size_t certified = 0, overlapping = 0, allowed = 0;
  nlohmann::ordered_json problems = nlohmann::ordered_json::array(), touching = nlohmann::ordered_json::array();
  for (const PlannedProblem& each : all) {
    const bool isSolved = each.result.outcome == PlanResult::Outcome::Solved;
    if (isSolved) {
      seconds.push_back(each.seconds);
      planning.push_back(each.planning);
      checks.push_back(static_cast<double>(each.result.steps));
      distances.push_back(static_cast<double>(each.result.queries.exact));
      lengths.push_back(each.length);
    }
    certified += each.isCertified && !each.areAllowed ? 1 : 0;
    overlapping += each.overlaps.empty() ? 0 : 1;
    allowed += isSolved && each.areAllowed ? 1 : 0;
    problems.push_back(toJson(robot, each));
  }
  for (const auto& [a, b] : robot.alwaysMeeting)
    touching.push_back({robot.model.links[a].name, robot.model.links[b].name});
  const double count = std::max<double>(1.0, static_cast<double>(seconds.size()));
  const auto mean = [&](const std::vector<double>& of) { return std::accumulate(of.begin(), of.end(), 0.0) / count; };
  return {{"set", set.name},
          {"planner", planner},
          {"problems", all.size()},
          {"solved", seconds.size()},
          {"certified", certified},
          {"with_own_overlaps", overlapping},
          {"solved_with_overlaps_allowed", allowed},
          {"seconds_median", quantile(seconds, 0.5)},
          {"seconds_mean", mean(seconds)},
          {"seconds_p95", quantile(seconds, 0.95)},
          {"planning_seconds_median", quantile(planning, 0.5)},
          {"planning_seconds_mean", mean(planning)},
          {"checks_median", quantile(checks, 0.5)},
          {"checks_mean", mean(checks)},
          {"distances_mean", mean(distances)},
          {"length_rad_mean", mean(lengths)},
          {"length_rad_min", quantile(lengths, 0.0)},
          {"length_rad_max", quantile(lengths, 1.0)},
          {"always_touching", touching},
          {"results", problems}};
}

// Returns a remark on a problem that is not as expected: its result, and the links that overlap.
std::string remarkOn(const nlohmann::ordered_json& problem) {
  const bool hasOverlaps = problem.contains("own_overlaps");
  if (problem["outcome"] == "solved" && !hasOverlaps) return {};
  std::string text = problem["name"].get<std::string>() + ": " + problem["outcome"].get<std::string>();
  if (!hasOverlaps) return text + "\n";
  for (const auto& each : problem["own_overlaps"]) {
    text += "; " + each["links"][0].get<std::string>() + " overlaps " + each["links"][1].get<std::string>() + " by " +
            roundedText(each["depth_mm"].get<double>(), 3) + " mm at the " + each["at"].get<std::string>();
  }
  if (!problem.contains("certified_but_for_overlaps")) return text + "\n";
  return text + (problem["certified_but_for_overlaps"].get<bool>()
                     ? "; certified but for these pairs, which are allowed\n"
                     : "; these pairs are allowed\n");
}

std::string planningText(const nlohmann::ordered_json& report) {
  const auto ms = [&](const char* key) { return roundedText(1e3 * report[key].get<double>(), 3) + " ms"; };
  const auto rad = [&](const char* key) { return roundedText(report[key].get<double>(), 3) + " rad"; };
  const auto count = [&](const char* key) { return std::to_string(report[key].get<int>()); };
  std::string text = report["set"].get<std::string>() + ", " + report["planner"].get<std::string>() + ": " +
                     count("solved") + " of " + count("problems") + " solved";
  if (report["solved_with_overlaps_allowed"] != 0)
    text += " (" + count("solved_with_overlaps_allowed") + " with overlapping links allowed)";
  text += ", " + count("certified") + " certified; median " + ms("seconds_median") + ", 95 % within " +
          ms("seconds_p95") + "; mean length " + rad("length_rad_mean") + " (" + rad("length_rad_min") + " to " +
          rad("length_rad_max") + "); " + roundedText(report["checks_mean"].get<double>(), 4) + " points checked\n";
  for (const auto& each : report["results"]) text += remarkOn(each);
  return text;
}

Status writePath(const BenchmarkRobot& robot, const PlannedProblem& problem, const std::filesystem::path& folder) {
  std::error_code ignored;  // Any fault shows when the file is written
  std::filesystem::create_directories(folder, ignored);
  nlohmann::json waypoints = nlohmann::json::array();
  for (const ArmValues& values : problem.path) waypoints.push_back(std::vector<double>(values.begin(), values.end()));
  const nlohmann::ordered_json report = toJson(robot, problem);
  nlohmann::ordered_json json = {{"waypoints", waypoints}, {"certified", report["certified"]}};
  for (const char* key : {"own_overlaps", "certified_but_for_overlaps"}) {
    if (report.contains(key)) json[key] = report[key];
  }
  // A set from elsewhere does not say where files are written.
  std::string name = problem.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == '\\'; }, '_');
  return writeFileAtomically(folder / (name + ".json"), json.dump(), {});
}

int runBenchmark(const Arguments& arguments, const DocumentKinds&) {
  OperationValues values(benchmarkOperation());
  const std::string& id = benchmarkOperation().id;
  if (const std::string problem = readOptions(arguments, values); !problem.empty()) return failUsage(problem, id);
  if (!values.isSet("robot")) return failUsage("The option --robot URDF is missing.", id);
  const Result<PlanningSet> set = readPlanningFiles(arguments.operands[0]);
  if (!set) return fail(set.error());
  const Result<BenchmarkRobot> robot = readRobot(values, *set);
  if (!robot) return fail(robot.error());
  std::vector<PlannedProblem> all;
  Status written = Done{};
  runInterruptible("Planning", [&](CommandJob& job) {
    const double share = 1.0 / std::max<double>(1.0, static_cast<double>(set->problems.size()));
    for (std::size_t i = 0; i < set->problems.size() && written && !job.progress().cancelled(); ++i) {
      const double done = share * static_cast<double>(i);
      all.push_back(planned(set->problems[i], *robot, values, job.progress().part(done, done + share)));
      if (values.isSet("paths") && !all.back().path.empty())
        written = writePath(*robot, all.back(), values.text("paths"));
    }
  });
  if (!written) return fail(written.error());
  const nlohmann::ordered_json report = toJson(*set, *robot, all, planners()[values.whole("planner")].id);
  return print(arguments.has("json") ? textOf(report) : planningText(report));
}

}  // namespace

Command planningBenchmarkCommand() {
  CommandSpec spec = {
      benchmarkOperation().id,
      "SET",
      "Plans the paths of a set of problems, proves them free of collisions, and measures them.\n"
      "The set is one of MotionBenchMaker: in JSON (docs/robots.md has its keys), a scene or a request\n"
      "in YAML with the other one beside it, or a folder of such pairs.",
      {}};
  spec.options = optionsOf(benchmarkOperation());
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runBenchmark};
}

}  // namespace handwheel
