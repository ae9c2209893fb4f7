// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ContactSurface.h"
#include "mesh/HalfEdgeMesh.h"
#include "tools/Tool.h"
#include "window/JobRunner.h"

#include <optional>

namespace handwheel {

class FidelityChoice;
class HapticSession;
class ToolHost;
class TouchScene;
struct OpenMesh;
struct WindowParts;

// What the device feels of the mesh in view: its surface, made on a worker when a device is opened or another mesh
// comes into view, and brought up to date with each edit in time proportional to that; and what draws the tip for the
// tool in use, of which only that near the tip is looked at. Without a device there is nothing of it.
class MeshTouch : public QObject {
  Q_OBJECT

 public:
  explicit MeshTouch(const WindowParts& parts, QObject* parent = nullptr);

  void setDocument(OpenMesh* document);
  // A mesh that is hidden is not felt.
  void refreshVisibility() { rebuild(false); }
  bool isSettled() const { return m_making.isIdle() && m_gathering.isIdle(); }

 private:
  void followSession();
  void rebuild(bool isEdit);
  void followTool();
  void followTouch();
  void followTip();
  void dropMagnets();
  void gather(bool isEdit);
  void gatherNear(bool isEdit);
  bool isFelt() const;
  void edited(const std::vector<Face>& touched);
  void update(const std::vector<Face>& touched);

  HapticSession& m_session;
  TouchScene& m_scene;
  ToolHost& m_tools;
  FidelityChoice& m_fidelity;
  JobRunner m_making;     // the surface
  JobRunner m_gathering;  // what draws the tip
  OpenMesh* m_document = nullptr;
  std::optional<ContactSurface> m_surface;  // of the present mesh; none while it is made
  bool m_isOpen = false;                    // the session was, when it last told
  double m_side = 0.0;                      // mm, the mean length of an edge of the mesh
  Magnets m_magnets;                        // that are in the scene, or on their way
  bool m_asCurves;                          // rims draw as curves (TouchSettings)

  // Around where what draws the tip was gathered, and how far it may go from there (mm).
  struct Near {
    Vec3 place;
    double mayMove;
  };
  std::optional<Near> m_near;
};

}  // namespace handwheel
