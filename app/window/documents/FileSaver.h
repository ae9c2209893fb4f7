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

// The topic of messages about saving. They are removed when the document is next saved successfully.
inline const QString kSavingTopic = QStringLiteral("saving");

// Writes documents to files on a worker thread. Either the new file is complete and checked, or the old one is
// unchanged. The file of another open document is never overwritten, because that document would no longer match its
// file. An export (WrittenFile::isExport) leaves the document its own file and its unsaved changes.
class FileSaver : public QObject {
  Q_OBJECT

 public:
  FileSaver(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent = nullptr);

  // Treatment of a file that another program wrote since the document was opened or saved.
  enum class Changed { Refuse, Replace };

  // Writes a document to a file. ended: the function that is always called at the end. Its argument is true if the file
  // contains the present state of the document and the user already knows what the file lacks.
  void save(DocumentTab* document, const QString& path, std::function<void(bool)> ended = {},
            Changed changed = Changed::Refuse);
  // Returns the message that the user has cancelled the writing of a file.
  static Message cancelledMessage(const QString& path);

 signals:
  void message(const handwheel::Message& message);
  // Emitted when saving failed; the document is still open and unsaved. message: describes the failure, without an
  // action.
  void failed(handwheel::DocumentTab* document, const handwheel::Message& message);
  // Emitted when the document was saved. Messages about it with this topic are to be removed.
  void succeeded(const handwheel::Document* document, const QString& topic);
  // Emitted when the file was written, but its format cannot store all of the document. message: describes the losses,
  // without an action.
  void incomplete(handwheel::DocumentTab* document, const handwheel::Message& message);

 private:
  struct Written {
    QString path;
    QString command;  // the equivalent command line
    std::uint64_t revision;
    std::vector<Property> properties;
    LengthUnit displayUnit;
    std::optional<FileTimestamp> stamp;  // timestamp of the file after writing
  };
  void saved(DocumentTab* document, const Written& state, const WrittenFile& written);
  void markOverwritten(DocumentTab& document, const Written& state);
  bool reportLosses(DocumentTab* document, const Written& state, const WrittenFile& written);
  void reportExport(DocumentTab& document, const QString& name, QStringList losses);
  // Reports that saving was cancelled. document: null if it has been closed.
  void reportCancelled(DocumentTab* document, const QString& path);
  void reportFailure(DocumentTab* document, const QString& path, const Error& error);

  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  RecentFiles& m_recent;
  LogModel& m_log;
};

}  // namespace handwheel
