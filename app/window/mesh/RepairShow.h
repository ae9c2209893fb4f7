// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/NextStepCard.h"
#include "window/KindUi.h"
#include "window/haptics/HandShow.h"
#include "window/mesh/ShownHole.h"

#include <optional>

namespace handwheel {

inline const auto kScanSample = QStringLiteral("scan-with-holes.stl");

class MeshTools;
class RepairJobs;
struct OpenMesh;

// The simulated hand repairs a hole of the sample scan before the user's eyes, by the tools and in the order in which a
// designer with a haptic device does it: choose, smooth, stitch, fill, sculpt (He 2008, section 4.1). What it does can
// be undone like what a user does.
class RepairShow : public QObject {
  Q_OBJECT

 public:
  RepairShow(const WindowParts& parts, const RepairJobs& jobs, QObject* parent = nullptr);

  void setDocument(OpenMesh* document);
  QAction* action() { return &m_action; }
  bool isRunning() const { return m_hand.isRunning(); }
  // What is being done, and how to do it; empty when nothing is shown.
  NextStep step();

 signals:
  void changed();  // what step() says

 private:
  void start();
  void ended();
  std::vector<HandStep> steps();
  HandStep opening();
  void addChoosing(std::vector<HandStep>& steps);
  void addSmoothing(std::vector<HandStep>& steps);
  void addStitching(std::vector<HandStep>& steps);
  void addFilling(std::vector<HandStep>& steps);
  void addSculpting(std::vector<HandStep>& steps);

  bool isSettled() const;
  Vec3 middleOf(const FaceSelection& faces) const;
  std::optional<Vec3> cornerNear(const Vec3& place) const;
  bool takeHole();
  const BoundaryLoop* nextPart() const;
  std::optional<Vec3> firstPoint(const BoundaryLoop* loop) const;
  void lookFrom(const Vec3& direction);
  void useTool(const char* action);
  void perform(const char* action);
  void choose(const char* tool, const char* setting, const PropertyValue& value);
  bool shows(const char* tool, const char* setting) const;

  WindowParts m_parts;
  const RepairJobs& m_jobs;
  OpenMesh* m_document = nullptr;
  HandShow m_hand;
  QAction m_action;
  QAction m_stop;
  ShownHole m_hole;
  // Settings of tools that were changed, as they were.
  struct Setting {
    std::string tool, id;
    PropertyValue value;
  };
  std::vector<Setting> m_changed;
};

}  // namespace handwheel
