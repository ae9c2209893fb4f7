// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/ProximityCommand.h"

#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/ReportJson.h"
#include "cli/cell/CellFile.h"
#include "cli/cell/PathReport.h"
#include "document/cell/CellScene.h"
#include "planning/ProximityScenarios.h"
#include "robot/program/PathFile.h"

#include <cstdio>

namespace handwheel {

namespace {

constexpr int kMostSteps = 100'000;

constexpr std::array<const char*, ProximityCosts::kQueries> kQueries{"C1 closest points", "C2 nearer than tolerance",
                                                                     "C3 colliding", "C4 all contacts"};

struct ProximityOptions {
  ProximityRequest request;
  std::vector<std::optional<ProximityScenario>> wanted;  // Nothing: the cell as it stands
};

std::string stateOf(ProximityScenario scenario) {
  switch (scenario) {
    case ProximityScenario::Apart:
      return "apart";
    case ProximityScenario::Near:
      return "near";
    case ProximityScenario::Colliding:
      break;
  }
  return "colliding";
}

std::vector<MeasuredScenario> measured(const CellScene& scene, const RobotCellSnapshot& cell,
                                       const ProximityOptions& options, Progress progress) {
  std::vector<MeasuredScenario> all;
  const auto count = static_cast<double>(options.wanted.size());
  for (std::size_t i = 0; i < options.wanted.size(); ++i) {
    const Progress part = progress.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    all.push_back(measuredScenario(scene.scene, scene.planned(cell.joints), options.wanted[i], options.request, part));
  }
  return all;
}

nlohmann::ordered_json scenarioJson(const CellScene& scene, const RobotCellSnapshot& cell,
                                    const MeasuredScenario& one) {
  nlohmann::ordered_json json = {{"scenario", nullptr}, {"reached", one.costs.has_value()}};
  if (one.wanted) json["scenario"] = static_cast<int>(*one.wanted);
  if (!one.costs) return json;
  const ProximityCosts& costs = *one.costs;
  json["state"] = stateOf(costs.scenario);
  json["distance_mm"] = std::isfinite(costs.distance) ? nlohmann::ordered_json(costs.distance) : nullptr;
  json["near"] = costs.isNear;
  json["colliding"] = costs.isColliding;
  json["contacts"] = costs.contacts;
  json["joints"] = toJson(cell.robot->model, scene.whole(*one.values));
  for (std::size_t i = 0; i < ProximityCosts::kQueries; ++i) {
    const ProximityCost& cost = costs.queries[i];
    json["queries"].push_back({{"query", kQueries[i]},
                               {"median_us", cost.median},
                               {"slowest_us", cost.slowest},
                               {"bounding_volume_pairs", cost.volumes},
                               {"pairs", cost.pairs}});
  }
  return json;
}

std::string scenarioText(const MeasuredScenario& one, double tolerance) {
  char line[200];
  std::string text =
      one.wanted ? "Scenario " + std::to_string(static_cast<int>(*one.wanted)) + ", " + stateOf(*one.wanted) + ": "
                 : "The cell as it stands: ";
  if (!one.costs) return text + "the robot does not get there.\n";
  const ProximityCosts& costs = *one.costs;
  if (!std::isfinite(costs.distance))
    text += "there is no obstacle.\n";
  else if (costs.distance > 0.0)
    std::snprintf(line, sizeof line, "%.4g mm from the nearest obstacle, which is %s than %g mm.\n", costs.distance,
                  costs.isNear ? "less" : "not less", tolerance);
  else
    std::snprintf(line, sizeof line, "colliding, with %zu pairs of triangles or solids.\n", costs.contacts);
  if (std::isfinite(costs.distance)) text += line;
  for (std::size_t i = 0; i < ProximityCosts::kQueries; ++i) {
    const ProximityCost& cost = costs.queries[i];
    std::snprintf(line, sizeof line, "  %-26s %8.1f us, at most %8.1f us; %8.1f bounding volumes, %8.1f pairs\n",
                  kQueries[i], cost.median, cost.slowest, cost.volumes, cost.pairs);
    text += line;
  }
  return text;
}

std::string problemOf(const Arguments& arguments, ProximityOptions& options) {
  int scenario = 0;
  if (arguments.has("tolerance") &&
      (!readNumber(arguments.valueOf("tolerance"), options.request.tolerance) || !(options.request.tolerance > 0.0)))
    return "The option --tolerance takes a length in mm above 0.";
  if (arguments.has("steps") && (!readNumber(arguments.valueOf("steps"), options.request.steps) ||
                                 options.request.steps < 1 || options.request.steps > kMostSteps))
    return "The option --steps takes a number from 1 to 100000.";
  if (arguments.has("scenario") &&
      (!readNumber(arguments.valueOf("scenario"), scenario) || scenario < 1 || scenario > 3))
    return "The option --scenario takes 1 (apart), 2 (near) or 3 (colliding).";
  if (scenario > 0)
    options.wanted = {static_cast<ProximityScenario>(scenario)};
  else
    options.wanted = {std::nullopt, ProximityScenario::Apart, ProximityScenario::Near, ProximityScenario::Colliding};
  return {};
}

int runProximity(const Arguments& arguments, const DocumentKinds& kinds) {
  ProximityOptions options;
  if (const std::string problem = problemOf(arguments, options); !problem.empty())
    return failUsage(problem, "proximity");
  const Result<CellFile> file = openCellForArm(arguments, kinds);
  if (!file) return fail(file.error());
  CollisionMeshes meshes;
  Result<CellScene> scene = Error{};
  std::vector<MeasuredScenario> all;
  runInterruptible("Measuring", [&](CommandJob& job) {
    scene = sceneOf(*file->cell, meshes);
    if (scene) all = measured(*scene, *file->cell, options, job.progress());
  });
  if (!scene) return fail(scene.error());
  warnOfShapes(*scene);
  nlohmann::ordered_json json = {
      {"tolerance_mm", options.request.tolerance}, {"steps", options.request.steps}, {"scenarios", {}}};
  std::string text;
  bool isAll = true;
  for (const MeasuredScenario& one : all) {
    isAll = isAll && one.costs;
    json["scenarios"].push_back(scenarioJson(*scene, *file->cell, one));
    text += scenarioText(one, options.request.tolerance);
  }
  const int code = print(arguments.has("json") ? textOf(json) : text);
  return code == kExitDone && !isAll ? kExitSomethingLeft : code;
}

}  // namespace

Command proximityCommand() {
  CommandSpec spec = {"proximity",
                      "CELL",
                      "Measures the distance queries between a robot and its obstacles: the closest points, whether\n"
                      "anything is nearer than a tolerance, whether anything collides, and all contacts. It does so\n"
                      "where the robot stands, and in three scenarios: apart, near and colliding. Exit code 2: the\n"
                      "robot does not get into one of them.",
                      {}};
  spec.options.push_back(armOption());
  spec.options.push_back({"scenario", 0, "N", "Only this scenario: 1 apart, 2 near, 3 colliding"});
  spec.options.push_back({"tolerance", 0, "MM", "Distance below which the robot is near (default 20)"});
  spec.options.push_back({"steps", 0, "N", "Steps of the motion that is measured (default 200)"});
  spec.options.push_back({"json", 0, "", "Report as JSON"});
  spec.options.push_back({"help", 'h', "", "Show this help"});
  return {std::move(spec), runProximity};
}

}  // namespace handwheel
