// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/DrillOperation.h"

#include "base/NumberText.h"
#include "tools/ToolProperty.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeMemory.h"
#include "volume/drilling/DrillBits.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {
namespace {

std::vector<std::string> materialIds() {
  std::vector<std::string> ids;
  for (const DrillMaterial& material : drillMaterials()) ids.push_back(material.id);
  return ids;
}

Parameter numberOf(const char* id, const char* label, double value, Limits limits, const char* meaning,
                   const char* word) {
  Parameter parameter;
  parameter.property.id = id;
  parameter.property.label = label;
  parameter.property.value = value;
  parameter.property.least = limits.least;
  parameter.property.largest = limits.largest;
  parameter.meaning = meaning;
  parameter.word = word;
  return parameter;
}

Operation makeOperation() {
  Operation operation{.id = "drill",
                      .title = QT_TRANSLATE_NOOP("Tool", "Drill"),
                      .meaning = "Drills along a path, with thrust and torque"};
  Parameter tool;
  tool.property.id = "tool";
  tool.property.label = QT_TRANSLATE_NOOP("Property", "Drill");
  tool.property.value = std::string("ball:6");
  tool.meaning = "Head and diameter in mm: ball:6, twist:6, burr:4 or saw:30; saw:30:0.8 with its width";
  tool.word = "HEAD";
  Parameter material = tool;
  material.property.id = "material";
  material.property.label = QT_TRANSLATE_NOOP("Property", "Material");
  material.property.value = drillMaterials().front().id;
  material.meaning = "Material to be drilled:";
  for (const std::string& id : materialIds()) material.meaning += " " + id;
  material.word = "NAME";
  Parameter voxel = numberOf("voxel", QT_TRANSLATE_NOOP("Property", "Voxel"), 0.0, {1e-9, 1e9},
                             "Edge of a voxel, for a part that is not a volume yet; default: from feed and rate", "MM");
  voxel.property.quantity = Quantity::Length;
  voxel.hasDefault = false;
  operation.parameters = {
      tool,
      material,
      voxel,
      numberOf("rpm", QT_TRANSLATE_NOOP("Property", "Spindle (r/min)"), 1000.0, {0.0, 1e6}, "Speed of the spindle",
               "N"),
      numberOf("rate", QT_TRANSLATE_NOOP("Property", "Cycles a second"), 1000.0, {1.0, 1e5},
               "Cycles of the calculation per second", "HZ"),
      numberOf("erosion", QT_TRANSLATE_NOOP("Property", "Erosion"), 0.0, {0.0, 1e6},
               "Largest loss of a voxel in a cycle, as a multiple of the path in it; 0: all that is in the head", "N")};
  return operation;
}

// Implements drillAlong(), without the remaining volume. goesOn: decides about the next cycle, or returns an error.
template <class GoesOn>
Result<Drilled> drillCycles(DrillRun run, const DrillSetup& setup, const PoseTrajectory& path, double rate,
                            GoesOn goesOn, Progress progress) {
  Drilled done;
  const double cycles = std::ceil(path.duration() * rate);
  constexpr auto most = static_cast<double>(DrillRecord::kMostPoses - 1);
  if (!(cycles <= most))
    return Error{VolumeErrors::PathTooLong, {roundedText(path.duration()), roundedText(most / rate)}, {}, {}};
  auto hole = std::make_shared<DrillRecord>();
  hole->setup = setup;
  for (double i = 0.0; i <= cycles && !path.isEmpty(); ++i) {
    const Result<bool> isNext = goesOn();
    if (!isNext) return isNext.error();
    if (!*isNext) break;
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const HandPose at = path.at(i / rate);
    const DrillPose pose = DrillPose::of(at.position, at.orientation * Vec3::UnitZ(), i / rate);
    const DrillTick tick = move(run, pose);
    hole->poses.push_back(pose);
    if (tick.removed > 0.0 || (!done.ticks.empty() && done.ticks.back().removed > 0.0)) done.ticks.push_back(tick);
    progress.set(i / std::max(1.0, cycles));
  }
  done.hole = std::move(hole);
  done.removed = run.removed();
  done.maxThrust = run.maxThrust();
  done.maxTorque = run.maxTorque();
  done.energy = run.energy();
  done.breakthrough = run.breakthrough();
  done.seconds = path.duration();
  return done;
}

}  // namespace

const Operation& drillOperation() {
  static const Operation operation = makeOperation();
  return operation;
}

Result<DrillSetup> drillSetupOf(const OperationValues& values) {
  const std::optional<DrillBit> tool = drillBitOf(values.text("tool"));
  if (!tool) return Error{VolumeErrors::NoSuchDrill, {values.text("tool")}, {}, {}};
  const DrillMaterial* material = drillMaterial(values.text("material"));
  if (!material) return Error{VolumeErrors::NoSuchDrillMaterial, {values.text("material")}, {}, {}};
  DrillSetup setup{*tool, *material, values.number("rpm") * 2.0 * M_PI / 60.0};
  if (const double erosion = values.number("erosion"); erosion > 0.0) setup.erosion = erosion;
  return setup;
}

Result<Drilled> drillAlong(SparseVolume volume, const DrillSetup& setup, const PoseTrajectory& path, double rate,
                           Progress progress) {
  Result<Drilled> done = drillCycles(
      DrillRun(volume, setup), setup, path, rate, [] { return Result<bool>(true); }, progress);
  if (done) done->volume = std::move(volume);
  return done;
}

Result<Drilled> drillAlong(HybridPart& part, const DrillSetup& setup, const PoseTrajectory& path, double rate,
                           Progress progress) {
  VolumeGrowth growth(part.left().voxel(), static_cast<double>(part.bytes()));
  const auto goesOn = [&]() -> Result<bool> {
    if (const auto refusal = growth.refusalAt(static_cast<double>(part.bytes()))) return *refusal;
    return part.isExact();
  };
  return drillCycles(DrillRun(part, setup), setup, path, rate, goesOn, progress);
}

}  // namespace handwheel
