// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSubject.h"
#include "machining/measure/TurningReview.h"
#include "machining/target/TargetProfile.h"
#include "nurbs/StockCylinder.h"

namespace handwheel {

// A tool that a student may use.
struct AllowedTool {
  std::string name;         // "right-hand turning tool"
  double noseRadius = 0.8;  // mm
  std::string tool = {};    // id of a tool of the manual lathe; empty: described in words only
  std::string others = {};  // unknown keys of the file: a JSON object; empty: none
  bool operator==(const AllowedTool&) const = default;
};

// The data of a turning exercise: bar, lathe, tools and target shape.
struct TurningTask : ExerciseTask {
  static constexpr std::size_t kMostTools = 50;
  static constexpr double kLargestSpeed = 10'000.0;  // r/min
  static constexpr double kLargestFeed = 100.0;      // mm per revolution

  StockCylinder stock{40.0, 100.0, 0.0};
  std::string material = "medium-carbon-steel";  // id of a WorkMaterial
  ReviewedLathe lathe{800.0, 25.0, 100.0, 2.0};
  double forceLimit = 2000.0;       // N, limit of the lathe, shown to the student; 0: no limit
  double powerLimit = 3.0;          // kW; 0: no limit
  bool areProgramsAllowed = true;   // for students
  bool areCommandsAllowed = false;  // for students: commands that cut without a tool, such as Thread
  std::vector<AllowedTool> tools;
  std::optional<TargetProfile> target;

  // Returns Z of the zero point of the drawing and of programs, mm, as programZero() does: the finished face, or the
  // free end of the bar if there is no target.
  double zero() const { return target ? target->upperEnd() : stock.position + stock.length; }
};

// Convert a task to and from the JSON of containers and descriptions; docs/format.md lists the keys.
nlohmann::json toJson(const TurningTask& task);
TurningTask turningTaskFrom(const nlohmann::json& json, std::vector<Error>& damage);

// Returns the properties that teachers change.
std::vector<Property> propertiesOf(const TurningTask& task);
// Returns the task with another value of a property. Errors: ReferenceMissing {property}, ElementMalformed,
// ValueOutOfRange.
Result<TurningTask> withTaskProperty(TurningTask task, const std::string& id, const PropertyValue& value);

}  // namespace handwheel
