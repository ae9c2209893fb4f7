// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"

namespace handwheel {

struct MeshTab;

// The action "Save steps", which writes the editing steps of a mesh to a file. The command "handwheel edit" executes
// them.
class ScriptExport : public QObject {
  Q_OBJECT

 public:
  ScriptExport(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_save; }
  void setDocument(MeshTab* document);  // null: no mesh is in view
  void follow();                        // to be called after the document has changed

 signals:
  void message(const handwheel::Message& message);

 private:
  void ask();
  void write(const MeshTab& document, const QString& path);

  WindowContext m_parts;
  MeshTab* m_document = nullptr;
  QAction m_save;
};

}  // namespace handwheel
