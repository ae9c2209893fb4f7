// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/documents/FileLoader.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <QObject>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

namespace handwheel {

class DocumentTabs;
class JobRunner;
struct DocumentTab;
struct Message;

// The actions that open the surface of the current document as another kind. One of them opens a mesh as a volume.
// Kinds may ask for the parameters (KindUi::askToCopy()).
class CopyActions : public QObject {
  Q_OBJECT

 public:
  using Open = std::function<DocumentTab*(OpenedFile opened)>;

  CopyActions(QWidget* window, const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs, JobRunner& jobs,
              Open open);

  // Returns one action for each kind that can be made from a surface.
  QList<QAction*> actions() const;

 signals:
  void message(const handwheel::Message& message);

 private:
  void follow();
  void ask(const DocumentKind& kind);
  void start(const DocumentKind& kind, DocumentTab* from, const MakeOfSurface& make);

  const KindUis& m_uis;
  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  Open m_open;
  std::vector<std::pair<const DocumentKind*, QAction*>> m_actions;
};

}  // namespace handwheel
