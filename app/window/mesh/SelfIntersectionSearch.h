// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "window/JobRunner.h"

#include <QTimer>

namespace handwheel {

class WindowServices;
struct OpenMesh;

// Looks for self-intersections of the document in view on a worker, once the document has come to rest.
class SelfIntersectionSearch : public QObject {
  Q_OBJECT

 public:
  SelfIntersectionSearch(QThreadPool& pool, WindowServices& services, QObject* parent = nullptr);

  void setDocument(OpenMesh* document);
  bool isIdle() const { return !m_rest.isActive() && m_runner.isIdle(); }

 private:
  void schedule();
  void start();

  WindowServices& m_services;
  Need m_need;  // as long as a mesh is in view
  JobRunner m_runner;
  QTimer m_rest;
  OpenMesh* m_document = nullptr;
};

}  // namespace handwheel
