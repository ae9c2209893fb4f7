// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FileLoader.h"

#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "text/RepairText.h"
#include "window/CommandText.h"
#include "window/DocumentTabs.h"
#include "window/JobRunner.h"
#include "window/OpenDocument.h"
#include "window/RecentFiles.h"

#include <QFile>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kDamageShown = 2;

// A second, forgiving attempt only helps against damage in the content.
bool mayBePartlyReadable(ErrorCode code) {
  switch (code) {
    case ErrorCode::HeaderMalformed:
    case ErrorCode::TokenUnexpected:
    case ErrorCode::NumberMalformed:
    case ErrorCode::NumberNotFinite:
    case ErrorCode::IndexOutOfRange:
    case ErrorCode::PolygonTooSmall:
    case ErrorCode::DataTruncated:
    case ErrorCode::CountMismatch:
      return true;
    default:
      return false;
  }
}

// The title of the message names the file already.
Error withoutFile(Error error) {
  error.subject.clear();
  return error;
}

}  // namespace

FileLoader::FileLoader(DocumentTabs& tabs, JobRunner& jobs, RecentFiles& recent, LogModel& log, QObject* parent)
    : QObject(parent), m_tabs(tabs), m_jobs(jobs), m_recent(recent), m_log(log) {}

void FileLoader::load(const QString& path, const ReadOptions& options) {
  if (const OpenDocument* open = m_tabs.withPath(path)) return m_tabs.setCurrent(open);
  Job job;
  job.name = tr("Opening %1").arg(QFileInfo(path).fileName());
  job.work = [this, path, options](Progress progress) -> Job::Finish {
    Result<MeshFile> read = readMeshFile(QFile::encodeName(path).toStdString(), options, progress.part(0.0, 0.6));
    if (!read) return [this, path, options, error = read.error()] { failed(path, error, options); };
    auto file = std::make_shared<MeshFile>(std::move(read.value()));
    BuiltMesh built = buildMesh(file->soup);
    file->soup = {};  // the mesh holds it all; the memory is better used elsewhere
    return [this, path, file, build = std::move(built.report), mesh = inspected(std::move(built.mesh))] {
      loaded(path, *file, mesh, build);
    };
  };
  job.failed = [this, path, options](const Error& error) { failed(path, error, options); };
  m_jobs.start(std::move(job));
}

void FileLoader::loaded(const QString& path, const MeshFile& file, const InspectedMesh& mesh,
                        const BuildReport& build) {
  if (const OpenDocument* open = m_tabs.withPath(path)) return m_tabs.setCurrent(open);
  auto opened = std::make_unique<OpenDocument>(path, file, mesh, build);
  const Inspection& inspection = opened->inspection;
  m_log.add(tr("Opened %1: %2 triangles, %3 holes, %4 triangles turned over")
                .arg(opened->document.name())
                .arg(opened->document.mesh().liveFaceCount())
                .arg(inspection.holes().size())
                .arg(inspection.count(DefectKind::Flipped)),
            inspectCommand(path));
  m_tabs.add(std::move(opened));
  m_recent.add(path);
  tellLosses(path, file);
}

void FileLoader::failed(const QString& path, const Error& error, const ReadOptions& options) {
  const QString name = QFileInfo(path).fileName();
  const QString sentence = errorSentence(withoutFile(error));
  if (error.code == ErrorCode::Cancelled) return m_log.add(tr("Opening %1 was cancelled").arg(name));
  if (error.code == ErrorCode::FileMissing) m_recent.remove(path);
  Message message{Message::Weight::Error, tr("%1 could not be opened").arg(name), sentence, errorAdvice(error), {}, {}};
  if (!options.partial && mayBePartlyReadable(error.code)) {
    message.actionText = tr("Open what is readable");
    message.action = [this, path] { load(path, ReadOptions{.partial = true}); };
  }
  m_log.add(message.title + QStringLiteral(". ") + message.detail, {}, LogEntry::Weight::Error);
  emit this->message(message);
}

void FileLoader::tellLosses(const QString& path, const MeshFile& file) {
  if (file.damage.empty() && file.lost.empty()) return;
  const QString name = QFileInfo(path).fileName();
  QStringList lines;
  for (std::size_t i = 0; i < file.damage.size(); ++i) {
    const QString sentence = errorSentence(withoutFile(file.damage[i]));
    m_log.add(name + QStringLiteral(": ") + sentence, {}, LogEntry::Weight::Warning);
    if (i < kDamageShown) lines << sentence;
  }
  if (file.damage.size() > kDamageShown) {
    lines << tr("…and %1 more, listed in the Log.").arg(file.damage.size() - kDamageShown);
  }
  if (!file.lost.empty()) {
    QStringList names;
    for (LostAttribute attribute : file.lost) names << lostAttributeName(attribute);
    lines << tr("Not kept by Handwheel: %1.").arg(names.join(QStringLiteral(", ")));
    m_log.add(lines.last(), {}, LogEntry::Weight::Warning);
  }
  const bool damaged = !file.damage.empty();
  emit message({damaged ? Message::Weight::Warning : Message::Weight::Info,
                damaged ? tr("%1 is damaged").arg(name) : tr("%1 holds more than its surface").arg(name),
                lines.join(QLatin1Char(' ')),
                tr("“Save” will ask for a new name, so the original stays as it is."),
                {},
                {}});
}

}  // namespace handwheel
