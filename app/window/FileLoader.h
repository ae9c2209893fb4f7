// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"
#include "mesh/Defects.h"
#include "mesh/MeshBuilder.h"
#include "panels/MessageBar.h"

#include <QObject>
#include <memory>

namespace handwheel {

class DocumentTabs;
class JobRunner;
class LogModel;
class RecentFiles;

// Opens files: reads and builds on a worker, and tells what the file lacked or lost.
class FileLoader : public QObject {
  Q_OBJECT

 public:
  FileLoader(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent = nullptr);

  // A file that is already open is shown instead.
  void load(const QString& path, const ReadOptions& options = {});

 signals:
  void message(const handwheel::Message& message);

 private:
  void loaded(const QString& path, const MeshFile& file, const InspectedMesh& mesh, const BuildReport& build);
  void failed(const QString& path, const Error& error, const ReadOptions& options);
  void tellLosses(const QString& path, const MeshFile& file);

  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  RecentFiles& m_recent;
  LogModel& m_log;
};

}  // namespace handwheel
