// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/FileSaver.h"

#include "controls/Preferences.h"
#include "document/DocumentErrors.h"
#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "text/NoteText.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileFilters.h"
#include "window/documents/FileLoader.h"
#include "window/documents/RecentFiles.h"
#include "window/kinds/KindUi.h"

#include <QFile>
#include <QFileInfo>
#include <QPointer>
#include <utility>

namespace handwheel {

namespace {

// Returns true if another program may have written the document's own file since it was read or saved: it differs from
// the file from which the document was read, or a recovered document does not know that file. A missing file is no
// loss.
bool wasChanged(const DocumentFile& file, const std::filesystem::path& target) {
  if (target.string() != file.path) return false;
  const std::optional<FileTimestamp> now = timestampOf(target);
  return now && now != file.stamp;
}

QStringList lossesOf(const WrittenFile& written) {
  QStringList losses;
  for (const Note& note : written.notes) {
    if (note.isLoss) losses << noteText(note);
  }
  return losses;
}

// Keeps what the file of the document looked like when its saving began, unless it was closed before, and whether
// another document has the path.
std::function<void()> lookedAtStart(QPointer<const Document> open, std::shared_ptr<std::optional<FileTimestamp>> stamp,
                                    const DocumentTabs& tabs, QString path, std::shared_ptr<bool> isOpenElsewhere) {
  return [open = std::move(open), stamp = std::move(stamp), &tabs, path = std::move(path),
          isOpenElsewhere = std::move(isOpenElsewhere)] {
    if (open) *stamp = open->file().stamp;
    *isOpenElsewhere = tabs.isOpenBeside(open, path);
  };
}

}  // namespace

FileSaver::FileSaver(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent)
    : QObject(parent), m_tabs(tabs), m_jobs(jobs), m_recent(recent), m_log(log) {}

void FileSaver::save(DocumentTab* document, const QString& path, std::function<void(bool)> ended, Changed changed) {
  document->document.settle();
  Written state{path,
                document->ui.saveCommand(*document, path),
                document->document.revision(),
                document->document.properties(),
                document->document.displayUnit(),
                {}};
  // Null once it is closed: another document may have the address of its tab then.
  const QPointer<const Document> open = &document->document;
  // Files written by the saves before this one are no change by another program.
  const auto stamp = std::make_shared<std::optional<FileTimestamp>>(document->document.file().stamp);
  Job job;
  job.name = tr("Saving %1").arg(QFileInfo(path).fileName());
  // The saves before this one may have given the file to another document.
  const auto isOpenElsewhere = std::make_shared<bool>(false);
  job.starting = lookedAtStart(open, stamp, m_tabs, path, isOpenElsewhere);
  const auto failed = [this, document, open, path, ended](const Error& error) {
    reportFailure(open ? document : nullptr, path, error);
    if (ended) ended(false);
  };
  job.failed = failed;
  job.document = &document->document;
  job.lane = Job::Lane::Saving;
  job.resource = path;
  job.work = [this, document, open, stamp, isOpenElsewhere, state, ended, failed, changed,
              &kind = document->document.kind(), file = document->document.file(),
              content = document->document.snapshot()](Progress progress) mutable -> Job::Finish {
    const std::filesystem::path target = QFile::encodeName(state.path).toStdString();
    file.stamp = *stamp;
    if (*isOpenElsewhere) return [failed, target] { failed({DocumentError::OpenElsewhere, {}, {}, target.string()}); };
    if (changed == Changed::Refuse && wasChanged(file, target))
      return [failed, target] { failed({DocumentError::ChangedOnDisk, {}, {}, target.string()}); };
    const auto written = saveDocument(kind, file, *content, target, progress);
    if (!written) return [failed, error = written.error()] { failed(error); };
    state.stamp = timestampOf(target);
    return [this, document, open, state, ended, written = written.value()] {
      const bool isOpen = !open.isNull();
      if (isOpen) saved(document, state, written);
      const bool isNewLoss = isOpen && reportLosses(document, state, written);
      if (ended) ended(isOpen && !isNewLoss && !document->document.isModified());
    };
  };
  m_jobs.start(std::move(job));
}

void FileSaver::saved(DocumentTab* document, const Written& state, const WrittenFile& written) {
  Document& saved = document->document;
  emit succeeded(&saved, kSavingTopic);
  const QString name = QFileInfo(state.path).fileName();
  m_log.add(tr("Saved %1: %2 bytes, read back and compared").arg(name).arg(written.bytes), state.command);
  for (const Note& note : written.notes) m_log.add(name + QStringLiteral(": ") + noteText(note));
  if (written.isExport) {
    if (state.path == saved.path()) markOverwritten(*document, state);
    return reportExport(*document, name, lossesOf(written));
  }
  m_recent.add(state.path);
  if (saved.revision() == state.revision) {
    document->written = true;
    document->inFile = state.properties;
    saved.markSaved(state.path, !formatOf(saved.kind(), state.path), state.stamp);
    emit succeeded(&saved, kOpeningTopic);  // ends the messages about the file that it was opened from
  } else {
    if (state.path == saved.path()) markOverwritten(*document, state);
    m_log.add(tr("%1 contains the state before your last change").arg(name), {}, LogEntry::Weight::Warning);
  }
}

// The document's own file now lacks something of it.
void FileSaver::markOverwritten(DocumentTab& document, const Written& state) {
  document.autosaved = 0;  // it is described with the stamp of the file before
  document.document.markOverwritten(state.stamp);
}

// Once for each list of them: who saves often has read it. Whether it was reported. A foreign file that is opened again
// has the usual unit.
bool FileSaver::reportLosses(DocumentTab* document, const Written& state, const WrittenFile& written) {
  if (written.isExport) return false;  // it was reported
  const auto foreign = formatOf(document->document.kind(), state.path);
  QStringList losses = lossesOf(written);
  if (foreign && state.displayUnit != loadPreferences().lengthUnit)
    losses << tr("The display unit is not in this file.");
  const QString all = losses.join(QLatin1Char(' '));
  if (std::exchange(document->reportedLosses, all) == all || losses.isEmpty()) return false;
  emit incomplete(document,
                  {Message::Weight::Info,
                   tr("%1 does not contain the whole document").arg(QFileInfo(state.path).fileName()),
                   all,
                   tr("The document stays open. Save it as *%1, too, to keep all of it.").arg(containerEnding()),
                   {},
                   {},
                   {},
                   {},
                   &document->document,
                   kSavingTopic});
  return true;
}

void FileSaver::reportExport(DocumentTab& document, const QString& name, QStringList losses) {
  const bool isModified = document.document.isModified();
  if (!isModified && losses.isEmpty()) return;
  Message report{Message::Weight::Info, tr("%1 was written").arg(name), {}, {}, {}, {}};
  report.about = &document.document;
  report.topic = kSavingTopic;
  if (!isModified) {
    report.detail = losses.join(QLatin1Char(' '));
    emit message(report);
    return;
  }
  losses << tr("The file does not contain the whole document, which is not saved yet.");
  report.detail = losses.join(QLatin1Char(' '));
  report.advice = tr("Save the document as *%1 to continue with it later.").arg(containerEnding());
  emit incomplete(&document, report);
}

Message FileSaver::cancelledMessage(const QString& path) {
  return {Message::Weight::Warning, tr("Saving %1 was cancelled").arg(QFileInfo(path).fileName()),
          tr("Nothing was written: the file is unchanged.")};
}

void FileSaver::reportCancelled(DocumentTab* document, const QString& path) {
  Message report = cancelledMessage(path);
  m_log.add(report.title, {}, LogEntry::Weight::Warning);
  if (m_tabs.contains(document)) {
    report.about = &document->document;
    report.topic = kSavingTopic;
    report.advice = tr("The document is still open, with all its changes.");
    report.actionText = tr("Save again");
    report.action = [this, document, path] {
      if (m_tabs.contains(document)) save(document, path);
    };
  }
  emit message(report);
}

void FileSaver::reportFailure(DocumentTab* document, const QString& path, const Error& error) {
  if (error.code == ErrorCode::Cancelled) return reportCancelled(document, path);
  const QString name = QFileInfo(path).fileName();
  const QString title = tr("%1 could not be saved").arg(name);
  m_log.add(title + QStringLiteral(". ") + errorSentence(error), {}, LogEntry::Weight::Error);
  Message report{Message::Weight::Error, title, errorSentence(error), errorAdvice(error), {}, {}};
  if (m_tabs.contains(document)) {
    report.about = &document->document;
    report.topic = kSavingTopic;
    // An export that failed is made anew after changes. The document's own file is owed.
    if (path != document->document.path())
      report.isOver = [open = &document->document, then = document->document.revision()] {
        return open->revision() != then;
      };
    if (error.code == DocumentError::ChangedOnDisk) {
      report.otherText = tr("Replace");
      report.other = [this, document, path] {
        if (m_tabs.contains(document)) save(document, path, {}, Changed::Replace);
      };
    }
    emit failed(document, report);
  } else {
    emit message(report);
  }
}

}  // namespace handwheel
