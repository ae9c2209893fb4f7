// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/AssignedTask.h"

#include "base/JsonText.h"

#include <nlohmann/json.hpp>

namespace handwheel {

std::shared_ptr<const TurningTask> assignedTask(const AssignedExercise& assigned) {
  if (!assigned || !assigned.description->is_object()) return nullptr;
  const auto task = assigned.description->find("task");
  if (task == assigned.description->end() || stringAt(*assigned.description, "subject") != "turning") return nullptr;
  std::vector<Error> damage;  // who reads the exercise itself says so
  return std::make_shared<const TurningTask>(turningTaskFrom(*task, damage));
}

}  // namespace handwheel
