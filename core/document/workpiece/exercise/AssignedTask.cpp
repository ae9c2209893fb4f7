// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/AssignedTask.h"

#include "base/JsonText.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

std::shared_ptr<const TurningTask> assignedTask(const AssignedExercise& assigned) {
  if (!assigned || !assigned.description->is_object()) return nullptr;
  const auto task = assigned.description->find("task");
  if (task == assigned.description->end() || stringAt(*assigned.description, "subject") != "turning") return nullptr;
  std::vector<Error> damage;  // ignored: the reader of the exercise itself reports it
  return std::make_shared<const TurningTask>(turningTaskFrom(*task, damage));
}

WorkLimits workLimits(const AssignedExercise& assigned) {
  const auto task = assignedTask(assigned);
  if (!task) return {};
  WorkLimits limits{task->forceLimit, task->powerLimit, task->lathe.largestFeed};
  const auto criteria = assigned.description->find("criteria");
  if (criteria == assigned.description->end() || !criteria->is_array()) return limits;
  const auto narrow = [](double& limit, double upper) { limit = limit > 0.0 ? std::min(limit, upper) : upper; };
  for (const nlohmann::json& criterion : *criteria) {
    if (!criterion.is_object()) continue;
    const auto upper = criterion.find("upper");
    if (upper == criterion.end() || !upper->is_number() || !(upper->get<double>() > 0.0)) continue;
    const std::string figure = stringAt(criterion, "figure");
    if (figure == "force") narrow(limits.force, upper->get<double>());
    if (figure == "power") narrow(limits.power, upper->get<double>());
  }
  return limits;
}

bool isMarked(const AssignedExercise& assigned, std::string_view figure) {
  if (!assigned || !assigned.description->is_object()) return false;
  const auto criteria = assigned.description->find("criteria");
  if (criteria == assigned.description->end() || !criteria->is_array()) return false;
  return std::any_of(criteria->begin(), criteria->end(), [&](const nlohmann::json& criterion) {
    return criterion.is_object() && stringAt(criterion, "figure") == figure;
  });
}

}  // namespace handwheel
