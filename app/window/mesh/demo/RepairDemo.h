// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/SuggestionCard.h"
#include "window/haptics/ScriptedDeviceDemo.h"
#include "window/kinds/KindUi.h"
#include "window/mesh/demo/DemoHole.h"

#include <optional>

namespace handwheel {

inline const auto kScanSample = QStringLiteral("scan-with-holes.stl");

class MeshTools;
class RepairJobs;
struct MeshTab;

// A demonstration in which the simulated device repairs a hole of the sample scan. It uses the tools in the same order
// as a designer with a haptic device: choose, smooth, stitch, fill, sculpt (He 2008, section 4.1). Its edits can be
// undone like those of the user.
class RepairDemo : public QObject {
  Q_OBJECT

 public:
  RepairDemo(const WindowContext& parts, const RepairJobs& jobs, QObject* parent = nullptr);

  void setDocument(MeshTab* document);
  QAction* action() { return &m_action; }
  bool isRunning() const { return m_hand.isRunning(); }
  // Returns the present step with its instructions. The result is empty if no demonstration runs.
  Suggestion step();

 signals:
  void changed();  // the result of step() has changed

 private:
  void start();
  void ended();
  std::vector<DemoStep> steps();
  DemoStep opening();
  void addChoosing(std::vector<DemoStep>& steps);
  void addSmoothing(std::vector<DemoStep>& steps);
  void addStitching(std::vector<DemoStep>& steps);
  void addFilling(std::vector<DemoStep>& steps);
  void addSculpting(std::vector<DemoStep>& steps);

  bool isSettled() const;
  Vec3 middleOf(const FaceSelection& faces) const;
  std::optional<Vec3> cornerNear(const Vec3& position) const;
  bool takeHole();
  const BoundaryLoop* nextPart() const;
  std::optional<Vec3> firstPoint(const BoundaryLoop* loop) const;
  void lookFrom(const Vec3& direction);
  void useTool(const char* action);
  void perform(const char* action);
  void choose(const char* tool, const char* setting, const PropertyValue& value);
  bool shows(const char* tool, const char* setting) const;

  WindowContext m_parts;
  const RepairJobs& m_jobs;
  MeshTab* m_document = nullptr;
  ScriptedDeviceDemo m_hand;
  QAction m_action;
  QAction m_stop;
  DemoHole m_hole;
  // A tool setting that was changed, with its former value.
  struct Setting {
    std::string tool, id;
    PropertyValue value;
  };
  std::vector<Setting> m_changed;
};

}  // namespace handwheel
