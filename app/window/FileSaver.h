// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "panels/MessageBar.h"

#include <QObject>
#include <functional>

namespace handwheel {

class DocumentTabs;
class JobRunner;
class LogModel;
class RecentFiles;
struct OpenDocument;

// Writes documents on a worker. The file is complete and checked, or the old one is untouched.
class FileSaver : public QObject {
  Q_OBJECT

 public:
  FileSaver(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent = nullptr);

  // then: called when the file is written and the document has not been changed meanwhile.
  void save(OpenDocument* document, const QString& path, std::function<void()> then = {});

 signals:
  void message(const handwheel::Message& message);

 private:
  void saved(OpenDocument* document, const QString& path, std::uint64_t revision, const WrittenFile& written);
  void failed(const QString& path, const Error& error);

  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  RecentFiles& m_recent;
  LogModel& m_log;
};

}  // namespace handwheel
