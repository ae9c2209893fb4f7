// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/volume/ReshapeTool.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <array>

namespace handwheel {

class VolumeDocument;

// The entries of the Volume menu that change a volume as a whole. They provide their tool with services of the window:
// jobs with progress, the other documents, and files. All functions must be called on the window thread.
class ReshapeActions : public QObject {
  Q_OBJECT

 public:
  ReshapeActions(const WindowContext& parts, QObject* parent);

  QList<QAction*> all();
  // Sets the current document. null: no volume is current. reason: translated reason why the volume must not be
  // changed; empty: the volume may be changed.
  void setDocument(DocumentTab* document, const QString& reason);
  // Updates the actions after a possible change of the running tool.
  void followTool();
  ToolDescriptor tool();

 signals:
  void message(const handwheel::Message& message);

 private:
  void start(ReshapeTool::Change change);
  ReshapeServices services();
  std::vector<OtherBody> bodies() const;
  void addFile();

  WindowContext m_parts;
  std::array<QAction, ReshapeTool::kChanges> m_actions;
  ReshapeTool::Change m_change = ReshapeTool::Change::Shell;  // initial change of the tool
  DocumentTab* m_document = nullptr;
  QStringList m_files;  // files chosen for the current document
};

}  // namespace handwheel
