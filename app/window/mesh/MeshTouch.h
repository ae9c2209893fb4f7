// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ContactSurface.h"
#include "mesh/HalfEdgeMesh.h"
#include "window/JobRunner.h"

#include <optional>

namespace handwheel {

class HapticSession;
class TouchScene;
struct OpenMesh;

// What the device feels of the mesh in view: its surface, made on a worker when a device is opened or another mesh
// comes into view, and brought up to date with each edit in time proportional to that. Without a device there is none.
class MeshTouch : public QObject {
  Q_OBJECT

 public:
  MeshTouch(HapticSession& session, TouchScene& scene, QThreadPool& pool, QObject* parent = nullptr);

  void setDocument(OpenMesh* document);
  // A mesh that is hidden is not felt.
  void refreshVisibility() { rebuild(); }
  bool isSettled() const { return m_making.isIdle(); }

 private:
  void followSession();
  void rebuild();
  void edited(const std::vector<Face>& touched);
  void update(const std::vector<Face>& touched);

  HapticSession& m_session;
  TouchScene& m_scene;
  JobRunner m_making;
  OpenMesh* m_document = nullptr;
  std::optional<ContactSurface> m_surface;  // of the present mesh; none while it is made
  bool m_isOpen = false;                    // the session was, when it last told
};

}  // namespace handwheel
