// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/AssignedExercise.h"
#include "document/exercise/ExerciseSubject.h"
#include "document/volume/VolumeSnapshot.h"
#include "document/volume/exercise/DrillingStock.h"
#include "volume/drilling/DrillMonitor.h"

namespace handwheel {

// What holes in the forbidden region cost that were taken back by undo. The work is marked as it is in the end.
enum class FailedTries {
  CostTheMark,  // the mark for that region, and no others
  FailTheWork,  // as if they were still there
  AreListed,    // nothing
};

// The data of an exercise of drilling: the stock, the drill, and its planned path.
struct DrillingTask : ExerciseTask {
  static constexpr std::size_t kMostForbidden = 100;

  std::shared_ptr<const DrillingStock> stock;  // null: the skull that ships
  DrillPlan plan;
  DrillBit tool;
  std::string material = "cortical-bone";  // id of a DrillMaterial
  double spindle = 1000.0;                 // r/min
  double feed = 1.0;                       // mm/s, with the mouse
  FailedTries failedTries = FailedTries::CostTheMark;

  // At the site of the skull, with its brain forbidden.
  static DrillingTask ofSkull();

  const SparseVolume& volume() const;
  DrillSetup setup() const;
};

// As containers and descriptions have it; docs/format.md lists the keys.
nlohmann::json toJson(const DrillingTask& task);
DrillingTask drillingTaskFrom(const nlohmann::json& json, std::vector<Error>& damage);

// The properties that teachers change.
std::vector<Property> propertiesOf(const DrillingTask& task);
// Errors: ReferenceMissing {property}, ElementMalformed, ValueOutOfRange.
Result<DrillingTask> withTaskProperty(DrillingTask task, const std::string& id, const PropertyValue& value);

// What is prepared for the exercise that a volume is work on, without the stock; null: it is none, or of other work.
std::shared_ptr<const DrillingTask> assignedDrilling(const AssignedExercise& assigned);

}  // namespace handwheel
