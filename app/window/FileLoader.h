// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentFile.h"
#include "panels/MessageBar.h"

#include <QObject>
#include <functional>
#include <map>
#include <memory>

namespace handwheel {

class Document;
class DocumentTabs;
class JobRunner;
class LogModel;
class DocumentKinds;
class KindUi;
class RecentFiles;
struct OpenDocument;

using KindUis = std::map<std::string, std::unique_ptr<KindUi>>;  // by the id of the kind

// Opens files: reads and builds on a worker, and tells what the file lacked or lost.
class FileLoader : public QObject {
  Q_OBJECT

 public:
  FileLoader(const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent,
             LogModel& log, QObject* parent = nullptr);

  // A file that is already open is shown instead.
  void load(const QString& path, const ReadOptions& options = {});
  // A new document of default size of a kind that has such.
  void create(const std::string& kind);
  // What an autosave kept of a document; it belongs to that path, which may be empty.
  // then: called with it when it is open.
  void recover(const QString& autosave, const QString& path, std::function<void(OpenDocument*)> then);

 signals:
  void message(const handwheel::Message& message);

 private:
  OpenDocument* add(OpenedFile opened);
  void loaded(const QString& path, const ReadOptions& options, OpenedFile opened);
  void failed(const QString& path, const Error& error, const ReadOptions& options);
  void tellLosses(const Document& document);

  const DocumentKinds& m_kinds;
  const KindUis& m_uis;
  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  RecentFiles& m_recent;
  LogModel& m_log;
};

}  // namespace handwheel
