// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/KindUi.h"

namespace handwheel {

class MeshKind;
class MeshUi;
class RepairJobs;
struct MeshSnapshot;
struct MeshTab;

// The actions that split a mesh into shells or add other meshes. Each shell becomes a document of its own.
class ShellActions : public QObject {
  Q_OBJECT

 public:
  ShellActions(const WindowContext& parts, MeshKind& kind, MeshUi& ui, RepairJobs& jobs);

  void setDocument(MeshTab* document);  // null: no mesh is in view
  QList<QAction*> all() { return {&m_split, &m_add}; }

 signals:
  void message(const handwheel::Message& message);

 private:
  void split();
  void open(const std::vector<std::shared_ptr<MeshSnapshot>>& shells, const QString& command);
  void reportCount(const MeshTab* document, std::size_t shells);
  void reportFailed(const MeshTab* document, const QString& title, const Error& error);
  void askForMesh();
  void add(MeshTab* document, const QString& path);

  WindowContext m_parts;
  MeshKind& m_kind;
  MeshUi& m_ui;
  RepairJobs& m_jobs;
  MeshTab* m_document = nullptr;
  QAction m_split;
  QAction m_add;
};

}  // namespace handwheel
