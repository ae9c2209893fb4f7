// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/exercise/ExerciseSubject.h"
#include "document/volume/VolumeSnapshot.h"
#include "document/volume/exercise/DrillingStock.h"
#include "volume/drilling/DrillMonitor.h"

namespace handwheel {

// The penalty for undone holes in the forbidden region. All other criteria mark only the final work.
enum class FailedTries {
  CostTheMark,  // the mark for the forbidden region is lost
  FailTheWork,  // the holes count as if they still existed
  AreListed,    // the holes are only listed
};

// The data of an exercise of drilling: the stock, the drill, and its planned path.
struct DrillingTask : ExerciseTask {
  static constexpr std::size_t kMostForbidden = 100;

  std::shared_ptr<const DrillingStock> stock;  // null: the built-in skull
  DrillPlan plan;
  DrillBit tool;
  std::string material = "cortical-bone";  // id of a DrillMaterial
  double spindle = 1000.0;                 // r/min
  double feed = 1.0;                       // mm/s, for drilling with the mouse
  FailedTries failedTries = FailedTries::CostTheMark;

  // Returns a task at the site of the skull, where the brain is the forbidden region.
  static DrillingTask ofSkull();

  const SparseVolume& volume() const;
  DrillSetup setup() const;
};

// Converts a task to and from JSON, for containers and descriptions; docs/format.md lists the keys.
nlohmann::json toJson(const DrillingTask& task);
DrillingTask drillingTaskFrom(const nlohmann::json& json, std::vector<Error>& damage);

// Returns the properties that teachers can change.
std::vector<Property> propertiesOf(const DrillingTask& task);
// Returns the task with a changed property. Errors: ReferenceMissing {property}, ElementMalformed, ValueOutOfRange.
Result<DrillingTask> withTaskProperty(DrillingTask task, const std::string& id, const PropertyValue& value);

// Returns the task of an assigned exercise, without the stock. Returns null if the exercise has no task, or is not
// about drilling.
std::shared_ptr<const DrillingTask> assignedDrilling(const AssignedExercise& assigned);

}  // namespace handwheel
