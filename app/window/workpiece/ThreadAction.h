// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "machining/TurningPass.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"

#include <QAction>

namespace handwheel {

// The command that cuts a thread into the workpiece.
class ThreadAction : public QObject {
  Q_OBJECT

 public:
  ThreadAction(const WindowContext& parts, QObject* parent);

  void setDocument(DocumentTab* document);
  QAction* action() { return &m_cut; }

 signals:
  void message(const handwheel::Message& message);

 private:
  void ask();
  // Cuts the thread in a job, as one undo step.
  void cut(DocumentTab* document, const TurningPass& pass);

  WindowContext m_parts;
  QAction m_cut;
  DocumentTab* m_document = nullptr;
};

}  // namespace handwheel
