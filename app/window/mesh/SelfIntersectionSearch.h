// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "window/JobRunner.h"

#include <QTimer>

namespace handwheel {

class WindowServices;
struct MeshTab;

// Searches for self-intersections of the current mesh on a worker thread. The search starts when the mesh has not
// changed for a while. It applies to the mesh as the file stores it: if coordinates were rounded in saving, to the
// rounded mesh.
class SelfIntersectionSearch : public QObject {
  Q_OBJECT

 public:
  SelfIntersectionSearch(QThreadPool& pool, WindowServices& services, QObject* parent = nullptr);

  void setDocument(MeshTab* document);
  bool isIdle() const { return !m_rest.isActive() && m_runner.isIdle(); }

 private:
  void schedule();
  void start();

  WindowServices& m_services;
  ServiceHandle m_need;  // held while a mesh is shown
  JobRunner m_runner;
  QTimer m_rest;
  MeshTab* m_document = nullptr;
};

}  // namespace handwheel
