// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FileSaver.h"

#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "text/NoteText.h"
#include "window/CommandText.h"
#include "window/DocumentTabs.h"
#include "window/JobRunner.h"
#include "window/OpenDocument.h"
#include "window/RecentFiles.h"

#include <QFile>
#include <QFileInfo>

namespace handwheel {

FileSaver::FileSaver(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent)
    : QObject(parent), m_tabs(tabs), m_jobs(jobs), m_recent(recent), m_log(log) {}

void FileSaver::save(OpenDocument* document, const QString& path, std::function<void()> then) {
  const std::uint64_t revision = document->document.revision();
  Job job;
  job.name = tr("Saving %1").arg(QFileInfo(path).fileName());
  job.work = [this, document, path, revision, then, &kind = document->document.kind(), file = document->document.file(),
              content = document->document.snapshot()](Progress progress) -> Job::Finish {
    const auto written = saveDocument(kind, file, *content, QFile::encodeName(path).toStdString(), progress);
    if (!written) return [this, path, error = written.error()] { failed(path, error); };
    return [this, document, path, revision, then, written = written.value()] {
      if (!m_tabs.contains(document)) return;
      saved(document, path, revision, written);
      if (then && !document->document.isModified()) then();
    };
  };
  job.failed = [this, path](const Error& error) { failed(path, error); };
  m_jobs.start(std::move(job));
}

void FileSaver::saved(OpenDocument* document, const QString& path, std::uint64_t revision, const WrittenFile& written) {
  const QString name = QFileInfo(path).fileName();
  m_log.add(tr("Saved %1: %2 bytes, read back and compared").arg(name).arg(written.bytes),
            convertCommand(document->document.path(), path));
  for (const Note& note : written.notes) m_log.add(name + QStringLiteral(": ") + noteText(note));
  m_recent.add(path);
  if (document->document.revision() == revision) {
    document->written = true;
    document->document.markSaved(path, isContainerName(QFile::encodeName(path).toStdString()));
  } else {
    m_log.add(tr("%1 holds the state before your last change").arg(name), {}, LogEntry::Weight::Warning);
  }
}

void FileSaver::failed(const QString& path, const Error& error) {
  const QString name = QFileInfo(path).fileName();
  if (error.code == ErrorCode::Cancelled)
    return m_log.add(tr("Saving %1 was cancelled; the old file is untouched").arg(name));
  const QString title = tr("%1 could not be saved").arg(name);
  m_log.add(title + QStringLiteral(". ") + errorSentence(error), {}, LogEntry::Weight::Error);
  emit message({Message::Weight::Error, title, errorSentence(error), errorAdvice(error), {}, {}});
}

}  // namespace handwheel
