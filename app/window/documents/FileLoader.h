// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentFile.h"
#include "panels/MessageBar.h"

#include <QObject>
#include <filesystem>
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
struct AutosaveInfo;
struct DocumentTab;

using KindUis = std::map<std::string, std::unique_ptr<KindUi>>;  // by the id of the kind

// The topic of messages about the file that a document was opened from. The messages are removed when the document is
// saved as another file.
inline const QString kOpeningTopic = QStringLiteral("opening");

// Opens files on a worker thread and reports losses and damage.
class FileLoader : public QObject {
  Q_OBJECT

 public:
  FileLoader(const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent,
             LogModel& log, QObject* parent = nullptr);

  // Opens a file, or shows its document if it is already open.
  void load(const QString& path, const ReadOptions& options = {});
  // Shows an opened file as a document, and makes it current.
  DocumentTab* open(OpenedFile opened);
  // Shows a document that has not been saved to a file. The document keeps its unit.
  DocumentTab* openUnsaved(OpenedFile opened);
  // Creates a document of default size. The kind must support new documents.
  void create(const std::string& kind);
  // Opens the autosave of a document. info: the description of the autosave. then: the function that is called with the
  // document when it is open.
  void recover(const std::filesystem::path& file, const AutosaveInfo& info, std::function<void(DocumentTab*)> then);

  // Adds the findings of reading a file to the log: damage, losses and notes.
  static void logFindings(const DocumentFile& file, LogModel& log);

 signals:
  void message(const handwheel::Message& message);

 private:
  DocumentTab* add(OpenedFile opened);
  void loaded(const QString& path, const ReadOptions& options, OpenedFile opened);
  void failed(const QString& path, const Error& error, const ReadOptions& options);
  void reportRecovered(const Document& document);
  void notRecovered(const QString& path, const Error& error);
  void reportDamagedChanges(const Document& document, const std::filesystem::path& autosave);
  void reportNotes(const Document& document);
  void reportLosses(const Document& document);

  const DocumentKinds& m_kinds;
  const KindUis& m_uis;
  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  RecentFiles& m_recent;
  LogModel& m_log;
};

}  // namespace handwheel
