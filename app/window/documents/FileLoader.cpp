// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/FileLoader.h"

#include "controls/Preferences.h"
#include "document/DocumentKind.h"
#include "document/recovery/AutosaveChanges.h"
#include "document/recovery/RecoveryFiles.h"
#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "text/LossText.h"
#include "text/NoteText.h"
#include "window/CommandLines.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/RecentFiles.h"
#include "window/kinds/KindUi.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kDamageShown = 2;

// The title of the message names the file already.
Error withoutFile(Error error) {
  error.subject.clear();
  return error;
}

// Returns true if the only damage of a file is that other files which it names are missing.
bool isIncomplete(const DocumentFile& file) {
  return !file.damage.empty() && file.unlistedDamage == 0 &&
         std::all_of(file.damage.begin(), file.damage.end(),
                     [](const Error& error) { return error.code == ErrorCode::ReferenceMissing; });
}

QString notKept(const DocumentFile& file) {
  return FileLoader::tr("Not kept by Handwheel: %1.").arg(lostText(file));
}

}  // namespace

FileLoader::FileLoader(const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs, JobRunner& jobs,
                       RecentFiles& recent, LogModel& log, QObject* parent)
    : QObject(parent), m_kinds(kinds), m_uis(uis), m_tabs(tabs), m_jobs(jobs), m_recent(recent), m_log(log) {}

void FileLoader::load(const QString& path, const ReadOptions& options) {
  if (const DocumentTab* open = m_tabs.withPath(path)) return m_tabs.setCurrent(open);
  Job job;
  job.name = tr("Opening %1").arg(QFileInfo(path).fileName());
  job.owner = this;  // files are read one after another: each takes a multiple of its size in memory
  job.work = [this, path, options](Progress progress) -> Job::Finish {
    Result<OpenedFile> opened = m_kinds.open(QFile::encodeName(path).toStdString(), options, progress);
    if (!opened) return [this, path, options, error = opened.error()] { failed(path, error, options); };
    return [this, path, options, opened = std::move(opened.value())] { loaded(path, options, opened); };
  };
  job.failed = [this, path, options](const Error& error) { failed(path, error, options); };
  m_jobs.start(std::move(job));
}

DocumentTab* FileLoader::open(OpenedFile opened) {
  if (!opened.file.isContainer) opened.file.displayUnit = loadPreferences().lengthUnit;
  return add(std::move(opened));
}

DocumentTab* FileLoader::openUnsaved(OpenedFile opened) {
  DocumentTab* added = add(std::move(opened));
  added->document.markRecovered({});
  return added;
}

void FileLoader::create(const std::string& kind) {
  const DocumentKind& of = *m_kinds.withId(kind);
  DocumentTab* added = open(DocumentKinds::blank(of));
  added->inFile = of.make(DocumentKinds::blank(of))->properties();  // from which the command line starts
}

void FileLoader::recover(const std::filesystem::path& file, const AutosaveInfo& info,
                         std::function<void(DocumentTab*)> then) {
  const QString path = QFile::decodeName(QByteArray::fromStdString(info.path));
  Job job;
  job.name = path.isEmpty() ? tr("Recovering") : tr("Recovering %1").arg(QFileInfo(path).fileName());
  job.owner = this;
  job.work = [this, file, info, path, then](Progress progress) -> Job::Finish {
    const Result<JoinedChanges> joined = joinChanges(file, progress.part(0.0, 0.4));
    if (!joined) return [this, path, error = joined.error()] { notRecovered(path, error); };
    Result<OpenedFile> opened = m_kinds.open(file, {}, progress.part(0.4, 1.0));
    if (!opened) return [this, path, error = opened.error()] { failed(path, error, ReadOptions{.partial = true}); };
    // Containers do not keep it: saved, they are called by a file.
    const QFileInfo from(path);
    if (path.isEmpty() || from.isDir() || info.name != from.fileName().toStdString()) opened->file.title = info.name;
    opened->file.hasPrivateName = info.hasPrivateName;
    return [this, file, info, path, then, joined = *joined, opened = std::move(opened.value())] {
      DocumentTab* recovered = open(opened);
      recovered->document.markRecovered(path, info.stamp, info.isPartial);
      then(recovered);
      reportRecovered(recovered->document);
      reportLosses(recovered->document);
      if (joined == JoinedChanges::Damaged) reportDamagedChanges(recovered->document, file);
    };
  };
  job.failed = [this, path](const Error& error) { notRecovered(path, error); };
  m_jobs.start(std::move(job));
}

DocumentTab* FileLoader::add(OpenedFile opened) {
  const DocumentKind& kind = *opened.kind;
  auto open = m_uis.at(kind.id())->open(kind.make(std::move(opened)));
  DocumentTab* added = open.get();
  m_tabs.add(std::move(open));
  return added;
}

void FileLoader::loaded(const QString& path, const ReadOptions& options, OpenedFile opened) {
  if (const DocumentTab* open = m_tabs.withPath(path)) return m_tabs.setCurrent(open);
  DocumentTab* added = this->open(std::move(opened));
  added->inFile = added->document.properties();
  m_log.add(added->ui.openedText(*added), inspectCommand(path, options));
  m_recent.add(path);
  reportNotes(added->document);
  reportLosses(added->document);
  added->ui.opened(*added);
}

void FileLoader::failed(const QString& path, const Error& error, const ReadOptions& options) {
  const QString name = QFileInfo(path).fileName();
  const QString sentence = errorSentence(withoutFile(error));
  if (error.code == ErrorCode::Cancelled) return;  // the window reports it
  if (error.code == ErrorCode::FileMissing) m_recent.remove(path);
  const QString title = options.partial ? tr("Nothing of %1 can be read") : tr("%1 could not be opened");
  Message message{Message::Weight::Error, title.arg(name), sentence, errorAdvice(error), {}, {}};
  if (!options.partial && error.code->mayBePartlyReadable) {
    message.actionText = tr("Open what is readable");
    message.action = [this, path] { load(path, ReadOptions{.partial = true}); };
  }
  m_log.add(message.title + QStringLiteral(". ") + message.detail, {}, LogEntry::Weight::Error);
  emit this->message(message);
}

// The autosave is as it was, and is offered again at the next start.
void FileLoader::notRecovered(const QString& path, const Error& error) {
  if (error.code == ErrorCode::Cancelled) return failed(path, error, {});
  const QString title = path.isEmpty() ? tr("A document could not be recovered")
                                       : tr("%1 could not be recovered").arg(QFileInfo(path).fileName());
  m_log.add(title + QStringLiteral(". ") + errorSentence(error), {}, LogEntry::Weight::Error);
  emit message({Message::Weight::Error,
                title,
                errorSentence(error),
                tr("Its autosave is kept, and offered again at the next start."),
                {},
                {}});
}

void FileLoader::reportRecovered(const Document& document) {
  const QString title = tr("Recovered %1 as it was last autosaved").arg(document.name());
  m_log.add(title);
  Message notice{Message::Weight::Info, title, tr("Save it to keep it."), {}, {}, {}};
  notice.about = &document;
  notice.isOver = [&document] { return !document.isModified(); };
  emit message(notice);
}

void FileLoader::reportDamagedChanges(const Document& document, const std::filesystem::path& autosave) {
  const QString title = tr("The last changes of %1 cannot be read").arg(document.name());
  m_log.add(title + QStringLiteral(": ") + QFile::decodeName(recovery::damagedFile(autosave).c_str()), {},
            LogEntry::Weight::Warning);
  Message notice{Message::Weight::Warning,
                 title,
                 tr("It is recovered as it was autosaved before them."),
                 tr("Their file is kept and listed in the Log; it can be discarded at the next start."),
                 {},
                 {}};
  notice.about = &document;
  notice.comesFirst = true;
  emit message(notice);
}

void FileLoader::reportNotes(const Document& document) {
  const std::vector<Note>& notes = document.file().notes;
  if (notes.empty() || document.file().wouldLoseDataOnOverwrite()) return;  // else they are reported with the losses
  QStringList lines;
  for (std::size_t i = 0; i < notes.size(); ++i) {
    m_log.add(noteText(notes[i]), {}, LogEntry::Weight::Warning);
    if (i < kDamageShown) lines << noteText(notes[i]);
  }
  if (notes.size() > kDamageShown) lines << tr("…and %1 more, listed in the Log.").arg(notes.size() - kDamageShown);
  emit message({Message::Weight::Info,
                tr("Notes on %1").arg(document.name()),
                lines.join(QLatin1Char(' ')),
                {},
                {},
                {},
                {},
                {},
                &document,
                kOpeningTopic});
}

void FileLoader::logFindings(const DocumentFile& file, LogModel& log) {
  const QString name = QFileInfo(QFile::decodeName(QByteArray::fromStdString(file.path))).fileName();
  for (const Error& error : file.damage)
    log.add(name + QStringLiteral(": ") + errorSentence(withoutFile(error)), {}, LogEntry::Weight::Warning);
  if (file.unlistedDamage > 0)
    log.add(name + QStringLiteral(": ") +
                tr("%Ln more place(s) are damaged", nullptr, static_cast<int>(file.unlistedDamage)),
            {}, LogEntry::Weight::Warning);
  if (!file.lost.empty()) log.add(name + QStringLiteral(": ") + notKept(file), {}, LogEntry::Weight::Warning);
  for (const Note& note : file.notes) log.add(name + QStringLiteral(": ") + noteText(note));
}

void FileLoader::reportLosses(const Document& document) {
  const DocumentFile& file = document.file();
  if (!file.wouldLoseDataOnOverwrite()) return;
  logFindings(file, m_log);
  const QString name = document.name();
  QStringList lines;
  if (file.isNewer)
    lines << tr(
        "It was written by a newer version of Handwheel; contents that this version does not know are not shown.");
  for (std::size_t i = 0; i < std::min(file.damage.size(), kDamageShown); ++i)
    lines << errorSentence(withoutFile(file.damage[i]));
  if (file.damage.size() > kDamageShown)
    lines << tr("…and %1 more, listed in the Log.").arg(file.damage.size() - kDamageShown);
  if (isIncomplete(file)) lines << errorAdvice(file.damage.front());
  if (!file.lost.empty()) lines << notKept(file);
  for (const Note& note : file.notes) lines << noteText(note);
  if (lines.isEmpty())
    lines << tr(
        "When it was opened, its file had contents that were damaged or that Handwheel does not keep. They are "
        "still in that file.");
  const bool isTriangulated =
      std::find(file.lost.begin(), file.lost.end(), LostAttribute::ExactSurfaces) != file.lost.end();
  const bool damaged = !file.damage.empty();
  emit message({damaged ? Message::Weight::Warning : Message::Weight::Info,
                isIncomplete(file) ? tr("%1 is incomplete").arg(name)
                : damaged          ? tr("%1 is damaged").arg(name)
                : file.isNewer     ? tr("%1 is opened for reading only").arg(name)
                : isTriangulated   ? tr("%1 is opened as a mesh").arg(name)
                                   : tr("Not all of %1 is kept").arg(name),
                lines.join(QLatin1Char(' ')),
                tr("“Save” will ask for a new name, so the original stays as it is."),
                {},
                {},
                {},
                {},
                &document,
                kOpeningTopic,
                true});
}

}  // namespace handwheel
