// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/SessionRecordingsPage.h"

#include "haptics/recording/ForceRecorder.h"
#include "window/haptics/HapticSession.h"
#include "window/haptics/Recordings.h"

namespace handwheel {

SessionRecordingsPage::SessionRecordingsPage(Recordings& recordings, HapticSession& session, QWidget* parent)
    : RecordingsPage({recordings.recordAction(), recordings.playAction(), recordings.leaveAction(),
                      recordings.exportAction(), recordings.renameAction(), recordings.removeAction()},
                     parent),
      m_recordings(recordings),
      m_session(session) {
  connect(this, &RecordingsPage::chosen, &recordings,
          [&recordings](const QString& key) { recordings.choose(key.toStdString()); });
  connect(this, &RecordingsPage::renamed, &recordings,
          [&recordings](const QString& key, const QString& name) { recordings.rename(key.toStdString(), name); });
  connect(this, &RecordingsPage::seekRequested, &recordings.playback(), &Playback::seek);
  connect(&recordings, &Recordings::nameRequested, this, &RecordingsPage::editName);
  connect(&recordings, &Recordings::changed, this, &SessionRecordingsPage::showAll);
  connect(&recordings.playback(), &Playback::moved, this, &SessionRecordingsPage::showPlayed);
  connect(&session, &HapticSession::sampled, this, &SessionRecordingsPage::showRecorder);
  connect(&session, &HapticSession::recorded, this, &RecordingsPage::showNotRecording);
  showAll();
}

void SessionRecordingsPage::showAll() {
  std::vector<Row> rows;
  for (const StoredRecording& each : m_recordings.all()) {
    rows.push_back({QString::fromStdString(each.key), QString::fromStdString(each.name), each.ticks.duration(),
                    each.ticks.size(), each.ticks.missing()});
  }
  const StoredRecording* const chosen = m_recordings.chosen();
  showRecordings(rows, chosen ? QString::fromStdString(chosen->key) : QString());
}

void SessionRecordingsPage::showRecorder() {
  const ForceRecorder* const recorder = m_session.recorder();
  if (recorder && isVisible()) showRecorded(recorder->duration(), recorder->ticks());
}

void SessionRecordingsPage::showPlayed() {
  showPosition(m_recordings.playback().position(), m_recordings.playback().duration());
}

}  // namespace handwheel
