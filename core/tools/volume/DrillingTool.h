// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeDocument.h"
#include "document/volume/exercise/DrillingTask.h"
#include "tools/carving/HandDrill.h"

namespace handwheel {

// Tool that drills a volume by hand. A hole is one undo step, and its record is stored with it. In an exercise, the
// drill is specified by the task, and the hole is compared with the planned path.
class DrillingTool : public HandDrill {
 public:
  DrillingTool(VolumeDocument& document, const SimulationServices& services);

  void documentChanged() override;
  // Completes the hole that is being drilled, so that it counts as a try of an exercise.
  void settle() override;
  std::vector<Property> settings() const override;
  DrillSetup setup() const override;
  bool isWorkOnExercise() const override { return m_task != nullptr; }

 private:
  double voxelOfPart() const override { return m_document.volume()->volume.voxel(); }
  std::optional<SurfaceHit> hitAt(const Ray& ray) const override;
  bool isMaterialAlong(const Vec3& from, const Vec3& displacement) const override;
  double slack() const override { return 2.0 * voxelOfPart(); }
  const DrillRecord* holeBefore() const override;
  std::unique_ptr<DrillSimulation> simulation(const std::optional<DrillFeed>& feed) const override;
  std::shared_ptr<const KindPreview> previewOf(const std::shared_ptr<const DrillState>& state) const override;
  void take(const DrillSimulation& drilled, std::shared_ptr<const DrillRecord> record) override;
  void drop(const DrillState& hole) override;

  VolumeDocument& m_document;
  std::shared_ptr<const DrillingTask> m_task;  // null: the document is not an exercise
  std::size_t m_lastCount = 0;                 // number of the document's holes after the last one was added
};

}  // namespace handwheel
