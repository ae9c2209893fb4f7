// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/Recordings.h"

#include "document/Document.h"
#include "document/RecordingExport.h"
#include "document/RecordingsEdit.h"
#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "theme/Icons.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/documents/FileSaver.h"
#include "window/haptics/HapticSession.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

const StoredRecording* withKey(const std::vector<StoredRecording>& all, const std::string& key) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.key == key; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

Recordings::Recordings(const Parts& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_playback(parts.clock),
      m_record(tr("&Record the device"), this),
      m_play(tr("&Play the recording"), this),
      m_leave(tr("&Leave the recording"), this),
      m_export(tr("&Export as CSV…"), this),
      m_rename(tr("Re&name the recording"), this),
      m_remove(tr("&Delete the recording"), this) {
  prepareActions();
  connect(&m_record, &QAction::triggered, this, [this](bool isOn) {
    isOn ? m_parts.session.startRecording() : m_parts.session.stopRecording();
    enableActions();  // if it could not begin
  });
  connect(&m_play, &QAction::triggered, this, &Recordings::togglePlaying);
  connect(&m_leave, &QAction::triggered, &m_playback, &Playback::leave);
  connect(&m_export, &QAction::triggered, this, &Recordings::askForFile);
  connect(&m_rename, &QAction::triggered, this, [this] { emit nameRequested(QString::fromStdString(m_chosen)); });
  connect(&m_remove, &QAction::triggered, this, &Recordings::removeChosen);
  connect(&m_playback, &Playback::moved, this, &Recordings::enableActions);
  HapticSession& session = m_parts.session;
  connect(&session, &HapticSession::recordingStarted, this, [this] {
    m_playback.leave();
    m_recorded = m_document;
    markTool();
    enableActions();
  });
  connect(&session, &HapticSession::recorded, this, &Recordings::keep);
  connect(&session, &HapticSession::chosenChanged, this, &Recordings::enableActions);
  connect(&session, &HapticSession::forceOnChanged, this,
          [this](bool isOn) { m_parts.session.mark(isOn ? QStringLiteral("force on") : QStringLiteral("force off")); });
  connect(&session, &HapticSession::mappingChanged, this, [this] { m_parts.session.mark(QStringLiteral("mapping")); });
  connect(&session, &HapticSession::touchChanged, this, [this] { m_parts.session.mark(QStringLiteral("touch")); });
  enableActions();
}

void Recordings::prepareActions() {
  m_record.setCheckable(true);
  m_record.setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R));
  prepare(m_record, "recordDevice", "record",
          tr("Record the position and the force of the device until pressed again"));
  m_play.setCheckable(true);
  m_play.setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P));
  prepare(m_play, "playRecording", "play", tr("Let the cursor follow the recording, or pause it"));
  prepare(m_leave, "leaveRecording", "close", tr("Show the device again"));
  prepare(m_export, "exportRecording", "save-as", tr("Write the recording as a table"));
  prepare(m_rename, "renameRecording", "rename", tr("Give the recording another name"));
  prepare(m_remove, "removeRecording", "clear", tr("Delete the recording from the document"));
}

void Recordings::setDocument(Document* document) {
  if (document == m_document) return;
  finish();
  m_playback.leave();
  if (m_document) m_document->disconnect(this);
  m_document = document;
  m_chosen.clear();
  if (document) {
    if (!document->file().recordings.empty()) m_chosen = document->file().recordings.back().key;
    connect(document, &Document::fileChanged, this, &Recordings::follow);
  }
  follow();
}

void Recordings::finish() {
  m_parts.session.stopRecording();
}

void Recordings::noteTool(const std::string& name) {
  if (name == m_tool) return;
  m_tool = name;
  markTool();
}

void Recordings::markTool() {
  m_parts.session.mark(m_tool.empty() ? QStringLiteral("no tool")
                                      : QStringLiteral("tool %1").arg(QString::fromStdString(m_tool)));
}

std::vector<StoredRecording> Recordings::all() const {
  return m_document ? m_document->file().recordings : std::vector<StoredRecording>();
}

const StoredRecording* Recordings::chosen() const {
  return m_document ? withKey(m_document->file().recordings, m_chosen) : nullptr;
}

void Recordings::choose(const std::string& key) {
  if (key == m_chosen) return;
  m_playback.leave();
  m_chosen = key;
  follow();
}

void Recordings::rename(const std::string& key, const QString& name) {
  std::vector<StoredRecording> after = all();
  for (StoredRecording& each : after) {
    if (each.key == key) each.name = name.toStdString();
  }
  commit(tr("Rename a recording"), std::move(after));
}

// A document that was closed meanwhile has taken its leave of this, too.
void Recordings::keep(const Recording& ticks, const QString& device, double forceLimit) {
  if (m_recorded && ticks.size() > 0) {
    std::vector<StoredRecording> after = m_recorded->file().recordings;
    const std::string key = freeKey(after);
    const QString name = tr("Recording %1").arg(QString::fromStdString(key).toUInt());
    after.push_back({key, name.toStdString(), device.toStdString(), forceLimit, ticks});
    if (m_recorded == m_document) m_chosen = key;
    m_recorded->commit(tr("Record the device"), std::make_unique<RecordingsEdit>(std::move(after)));
    m_parts.log.add(tr("%1: %Ln sample(s)", nullptr, static_cast<int>(ticks.size())).arg(name));
  }
  m_recorded = nullptr;
  enableActions();
}

void Recordings::commit(const QString& text, std::vector<StoredRecording> recordings) {
  if (m_document) m_document->commit(text, std::make_unique<RecordingsEdit>(std::move(recordings)));
}

void Recordings::togglePlaying() {
  const StoredRecording* const recording = chosen();
  if (!recording) return enableActions();
  if (m_playback.isPlaying()) return m_playback.pause();
  if (m_playback.key() != recording->key) m_playback.takeUp(*recording);
  m_playback.play();
}

void Recordings::removeChosen() {
  std::vector<StoredRecording> after = all();
  const auto at = std::find_if(after.begin(), after.end(), [this](const auto& each) { return each.key == m_chosen; });
  if (at == after.end()) return;
  const auto next = after.erase(at);
  m_playback.leave();
  m_chosen = after.empty() ? std::string() : (next == after.end() ? after.back() : *next).key;
  commit(tr("Delete a recording"), std::move(after));
}

void Recordings::askForFile() {
  const StoredRecording* const recording = chosen();
  if (!recording) return;
  auto* dialog = new QFileDialog(m_parts.window, tr("Export the recording"));
  dialog->setObjectName(QStringLiteral("exportRecordingDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("Tables (*.csv)")});
  dialog->setDefaultSuffix(QStringLiteral("csv"));
  const QString folder = QFileInfo(m_document->path()).path();
  if (!m_document->file().path.empty() && QFileInfo(folder).isWritable()) dialog->setDirectory(folder);
  dialog->selectFile(QString::fromStdString(recording->name).replace(QLatin1Char('/'), QLatin1Char('-')) +
                     QStringLiteral(".csv"));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, copy = *recording](const QString& path) { writeCsv(copy, path); });
  dialog->open();
}

void Recordings::writeCsv(const StoredRecording& recording, const QString& path) {
  const auto failed = [this, path](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return emit message(FileSaver::cancelledMessage(path));
    emit message({Message::Weight::Error,
                  tr("%1 could not be saved").arg(QFileInfo(path).fileName()),
                  errorSentence(error),
                  errorAdvice(error),
                  {},
                  {}});
  };
  Job job;
  job.name = tr("Writing %1").arg(QFileInfo(path).fileName());
  job.document = m_document;
  job.lane = Job::Lane::Saving;
  job.resource = path;
  job.failed = failed;
  job.work = [this, failed, path, ticks = recording.ticks](Progress progress) -> Job::Finish {
    const Status written = exportRecording(ticks, QFile::encodeName(path).toStdString(), progress);
    if (!written) return [failed, error = written.error()] { failed(error); };
    return [this, path] { m_parts.log.add(tr("Saved %1").arg(QFileInfo(path).fileName())); };
  };
  m_parts.jobs.start(std::move(job));
}

// Undo may have taken the chosen one away, or brought another.
void Recordings::follow() {
  if (m_document && !chosen()) {
    const auto& all = m_document->file().recordings;
    m_chosen = all.empty() ? std::string() : all.back().key;
  }
  if (m_playback.isRecordingLoaded() && (!chosen() || m_playback.key() != m_chosen)) m_playback.leave();
  enableActions();
  emit changed();
}

void Recordings::enableActions() {
  const bool isRecording = m_parts.session.recorder() != nullptr;
  const bool isChosen = chosen() != nullptr;
  m_record.setEnabled(m_document && m_parts.session.isOpen());
  m_record.setChecked(isRecording);
  m_play.setEnabled(isChosen && !isRecording);
  m_play.setChecked(m_playback.isPlaying());
  nameActions(isRecording, m_playback.isPlaying());
  m_leave.setEnabled(m_playback.isRecordingLoaded());
  for (QAction* action : {&m_export, &m_rename, &m_remove}) action->setEnabled(isChosen);
}

// Called with each frame that is played: a new icon is drawn only when it is another.
void Recordings::nameActions(bool isRecording, bool isPlaying) {
  if (isRecording != std::exchange(m_isNamedStop, isRecording)) {
    m_record.setText(isRecording ? tr("Stop &recording") : tr("&Record the device"));
    m_record.setIcon(icon(isRecording ? QStringLiteral("stop") : QStringLiteral("record")));
  }
  if (isPlaying != std::exchange(m_isNamedPause, isPlaying)) {
    m_play.setText(isPlaying ? tr("&Pause the recording") : tr("&Play the recording"));
    m_play.setIcon(icon(isPlaying ? QStringLiteral("pause") : QStringLiteral("play")));
  }
}

}  // namespace handwheel
