// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FileSaver.h"

#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "window/CommandText.h"
#include "window/DocumentTabs.h"
#include "window/JobRunner.h"
#include "window/OpenDocument.h"
#include "window/RecentFiles.h"

#include <QFile>
#include <QFileInfo>

namespace handwheel {

namespace {

// What another program will find in the file.
QString state(const MeshReport& report) {
  if (report.isSound()) return FileSaver::tr("it is closed, manifold and oriented");
  QStringList open;
  if (!report.closed) open << FileSaver::tr("%n open edge(s)", nullptr, static_cast<int>(report.boundaryEdges));
  if (!report.manifold) {
    open << FileSaver::tr("%n edge(s) with more than two faces", nullptr, static_cast<int>(report.nonManifoldEdges));
  }
  if (!report.oriented) {
    open << FileSaver::tr("%n edge(s) at which faces disagree", nullptr, static_cast<int>(report.inconsistentEdges));
  }
  return FileSaver::tr("it has %1").arg(open.join(QStringLiteral(", ")));
}

}  // namespace

FileSaver::FileSaver(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent)
    : QObject(parent), m_tabs(tabs), m_jobs(jobs), m_recent(recent), m_log(log) {}

void FileSaver::save(OpenDocument* document, const QString& path, std::function<void()> then) {
  const std::uint64_t revision = document->document.revision();
  Job job;
  job.name = tr("Saving %1").arg(QFileInfo(path).fileName());
  job.work = [this, document, path, revision, then, mesh = document->document.mesh(),
              numbers = document->document.numbers()](Progress progress) -> Job::Finish {
    const Result<ExportReport> written = exportMesh(mesh, numbers, QFile::encodeName(path).toStdString(), progress);
    if (!written) return [this, path, error = written.error()] { failed(path, error); };
    return [this, document, path, revision, then, report = written.value()] {
      if (!m_tabs.contains(document)) return;
      saved(document, path, revision, report);
      if (then && !document->document.isModified()) then();
    };
  };
  job.failed = [this, path](const Error& error) { failed(path, error); };
  m_jobs.start(std::move(job));
}

void FileSaver::saved(OpenDocument* document, const QString& path, std::uint64_t revision, const ExportReport& report) {
  const QString name = QFileInfo(path).fileName();
  m_log.add(tr("Saved %1: %2 bytes, read back, compared and welded; %3")
                .arg(name)
                .arg(report.bytes)
                .arg(state(report.inFile)),
            convertCommand(document->document.path(), path));
  if (!report.parted.empty()) {
    m_log.add(tr("%1 vertices were moved by the smallest possible amount, so that the file does not weld them")
                  .arg(report.parted.size()),
              {}, LogEntry::Weight::Warning);
  }
  m_recent.add(path);
  if (document->document.revision() == revision) {
    const std::string plain = QFile::encodeName(path).toStdString();
    document->written = true;
    document->document.markSaved(path, formatForName(plain).value_or(document->document.format()));
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
