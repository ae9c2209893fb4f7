// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseKind.h"
#include "document/workpiece/exercise/TurningSubject.h"

#include <nlohmann/json.hpp>

namespace handwheel::test {

inline std::vector<std::unique_ptr<ExerciseSubject>> turningOnly() {
  std::vector<std::unique_ptr<ExerciseSubject>> subjects;
  subjects.push_back(std::make_unique<TurningSubject>());
  return subjects;
}

// Returns the description of an exercise: to turn a shoulder. A bar of ⌀40 × 100 mm is turned to ⌀30 h10 over the upper
// 40 mm. The speed is 600 r/min, and the chuck holds 25 mm.
inline nlohmann::json shoulderDescription() {
  return nlohmann::json::parse(R"({
    "subject": "turning", "title": "Shoulder", "author": "Ada", "text": "Turn the shoulder.", "allowed_seconds": 600,
    "task": {"diameter": 40, "length": 100, "spindle_speed": 600, "chuck_height": 25, "chuck_diameter": 80,
             "largest_feed": 1, "force_limit": 1500, "power_limit": 3, "material": "medium-carbon-steel",
             "tools": [{"name": "turning tool", "nose_radius": 0.8}],
             "target": {"outer": [[20, 0], [20, 60], [15, 60], [15, 100]], "inner": []}},
    "criteria": [
      {"id": "d", "name": "⌀30 h10", "figure": "diameter", "arguments": [62, 99], "nominal": 30, "tolerance": "h10",
       "points": 10, "slack": 0.1},
      {"id": "l", "name": "40 ±0.2", "figure": "length", "arguments": [17, 60, 5, 100], "nominal": 40, "lower": 39.8,
       "upper": 40.2, "points": 5},
      {"id": "ra", "name": "N8", "figure": "roughness", "arguments": [62, 99], "tolerance": "N8", "points": 3},
      {"id": "crash", "name": "No collision", "figure": "crashes", "upper": 0, "points": 4, "slack": 2},
      {"id": "force", "name": "Force", "figure": "force", "upper": 1500, "points": 2, "hidden": true},
      {"id": "time", "name": "Time", "figure": "time", "upper": 600, "points": 1, "slack": 600}],
    "steps": [{"title": "Rough", "text": "Take 4 mm off.", "hints": ["Two passes of 2 mm.", "Leave 0.5 mm."]},
              {"title": "Finish", "text": "Turn to size.", "hints": [], "criteria": ["d", "force"]}]})");
}

// Returns passes along the upper 40 mm. The tool's nose radius of 0.8 mm leaves a fillet at the shoulder.
inline nlohmann::json shoulderWork(double finalDiameter = 29.95, double feed = 0.2, double to = 60.0,
                                   int roughing = 3) {
  nlohmann::json passes = nlohmann::json::array();
  const auto pass = [&](double diameter, double f) {
    const double r = diameter / 2 + 0.8;
    passes.push_back({{"nose_radius", 0.8}, {"feed", f}, {"points", {{r, 103}, {r, to + 0.8}, {22.0, to + 0.8}}}});
  };
  for (int i = 1; i <= roughing; ++i) pass(40.0 - 9.0 * i / roughing, 0.3);
  pass(finalDiameter, feed);
  return {{"passes", passes}};
}

inline std::shared_ptr<const ExerciseSnapshot> exerciseFrom(const ExerciseKind& kind,
                                                            const nlohmann::json& description) {
  const Result<SnapshotPointer> made = kind.fromDescription(description, {});
  if (!made) qFatal("the description of an exercise is not taken");
  return std::static_pointer_cast<const ExerciseSnapshot>(made.value());
}

inline SnapshotPointer workFrom(const ExerciseSnapshot& exercise, const nlohmann::json& description) {
  const Result<SnapshotPointer> made = exercise.subject->makeWork(*exercise.task, description, {});
  if (!made) qFatal("the description of work is not taken");
  return made.value();
}

}  // namespace handwheel::test
