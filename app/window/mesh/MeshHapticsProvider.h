// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSurface.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "tools/Tool.h"
#include "window/JobRunner.h"
#include "window/haptics/ClayTouch.h"
#include "window/mesh/OperationsOrigin.h"

#include <QJsonObject>
#include <optional>

namespace handwheel {

class FidelityChoice;
class HapticSession;
class ToolHost;
class HapticSceneBuilder;
struct MeshTab;
struct WindowContext;

// Provides the contact surface and the snap features of the current mesh. The surface is built on a worker thread when
// a device is opened or another mesh is shown, and updated after each edit in time proportional to the edit. The snap
// features are those of the active tool, and only those near the tip are considered. Nothing is kept without a device.
// For a tool that works on voxels, the voxels are felt instead of the surface.
class MeshHapticsProvider : public QObject {
  Q_OBJECT

 public:
  explicit MeshHapticsProvider(const WindowContext& parts, QObject* parent = nullptr);

  void setDocument(MeshTab* document);
  // Must be called after the mesh was shown or hidden; a hidden mesh cannot be felt.
  void refreshVisibility() { rebuild(false); }
  bool isSettled() const { return m_making.isIdle() && m_gathering.isIdle(); }

 private:
  void followSession();
  void rebuild(bool isEdit);
  void followTool();
  void followVoxels();
  void followTouch();
  void followTip();
  void dropSnapTargets();
  void gather(bool isEdit);
  void gatherNear(bool isEdit);
  bool isFelt() const;
  void edited(const std::vector<Face>& touched);
  void setSurface(bool isEdit);
  void noteSteps();
  QJsonObject describe();

  HapticSession& m_session;
  HapticSceneBuilder& m_scene;
  ToolHost& m_tools;
  FidelityChoice& m_fidelity;
  ClayTouch m_voxels;
  bool m_isOfVoxels = false;  // the voxels of a tool are felt
  JobRunner m_making;         // makes the surface
  JobRunner m_gathering;      // gathers the snap features
  MeshTab* m_document = nullptr;
  std::optional<ContactSurface> m_surface;  // surface of the present mesh; none while it is being built
  bool m_isOpen = false;                    // state of the session at its last signal
  double m_side = 0.0;                      // mm, the mean length of an edge of the mesh
  SnapTargets m_snapTargets;                // snap features in the scene, or being gathered
  bool m_asCurves;                          // boundary loops attract as curves (TouchSettings)

  // Position at which the snap features were gathered, and distance that the tip may move from there (mm).
  struct Near {
    Vec3 position;
    double mayMove;
  };
  std::optional<Near> m_near;

  // State of the mesh as noted in a running recording: a file, and the editing steps since it.
  struct Noted {
    OperationsOrigin base;
    std::optional<std::vector<std::string>> steps;      // steps to the present surface; none: some edit has no step
    std::optional<std::vector<std::string>> lastNoted;  // steps in the last note
  };
  std::optional<Noted> m_noted;
};

}  // namespace handwheel
