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

bool isMarked(const AssignedExercise& assigned, std::string_view figure) {
  if (!assigned || !assigned.description->is_object()) return false;
  const auto criteria = assigned.description->find("criteria");
  if (criteria == assigned.description->end() || !criteria->is_array()) return false;
  return std::any_of(criteria->begin(), criteria->end(), [&](const nlohmann::json& criterion) {
    return criterion.is_object() && stringAt(criterion, "figure") == figure;
  });
}

}  // namespace handwheel
