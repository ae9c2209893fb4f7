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
struct DocumentTab;

// The topic of messages about saving; the next success removes them.
inline const QString kSavingTopic = QStringLiteral("saving");

// Writes documents to files on a worker thread. Afterwards the new file is complete and checked, or the old one is
// unchanged. The file of another open document is never written: that document would no longer match its file. Writing
// a format from which the document cannot be read back is an export: the document stays unsaved.
class FileSaver : public QObject {
  Q_OBJECT

 public:
  FileSaver(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent = nullptr);

  // Treatment of a file that another program wrote since the document was opened or saved.
  enum class Changed { Refuse, Replace };

  // ended: always called at the end; true if the file holds the present state of the document, and the user already
  // knows what the file lacks.
  void save(DocumentTab* document, const QString& path, std::function<void(bool)> ended = {},
            Changed changed = Changed::Refuse);

 signals:
  void message(const handwheel::Message& message);
  // Saving failed; the document is still open and unsaved. message: describes it, without an action.
  void failed(handwheel::DocumentTab* document, const handwheel::Message& message);
  // The document was saved: messages about it with this topic are over.
  void succeeded(const handwheel::Document* document, const QString& topic);
  // The file was written, but its format cannot hold all of the document. message: describes it, without an action.
  void incomplete(handwheel::DocumentTab* document, const handwheel::Message& message);

 private:
  struct Written {
    QString path;
    QString command;  // the equivalent command line
    std::uint64_t revision;
    std::vector<Property> properties;
    LengthUnit displayUnit;
    std::optional<FileTimestamp> stamp;  // timestamp of the file afterwards
  };
  void saved(DocumentTab* document, const Written& state, const WrittenFile& written);
  bool reportLosses(DocumentTab* document, const Written& state, const WrittenFile& written);
  void reportExport(const DocumentTab& document, const QString& name, QStringList losses);
  // document: null if it is closed by now.
  void reportCancelled(DocumentTab* document, const QString& path);
  void reportFailure(DocumentTab* document, const QString& path, const Error& error);

  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  RecentFiles& m_recent;
  LogModel& m_log;
};

}  // namespace handwheel
