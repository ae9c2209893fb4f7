// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/JobRunner.h"

#include <QTimer>

namespace handwheel {

struct OpenDocument;

// Looks for self-intersections of the document in view on a worker, once the document has come to rest.
class SelfIntersectionSearch : public QObject {
  Q_OBJECT

 public:
  SelfIntersectionSearch(QThreadPool& pool, QObject* parent = nullptr);

  void setDocument(OpenDocument* document);
  bool isIdle() const { return !m_rest.isActive() && m_runner.isIdle(); }

 private:
  void schedule();
  void start();

  JobRunner m_runner;
  QTimer m_rest;
  OpenDocument* m_document = nullptr;
};

}  // namespace handwheel
