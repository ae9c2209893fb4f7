// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/RecordingIndicator.h"

#include "haptics/recording/ForceRecorder.h"
#include "theme/Icons.h"
#include "window/haptics/HapticSession.h"

namespace handwheel {

RecordingIndicator::RecordingIndicator(HapticSession& session, QWidget* parent)
    : QToolButton(parent), m_session(session) {
  setObjectName(QStringLiteral("recordingSign"));
  setAutoRaise(true);
  setIcon(handwheel::icon(QStringLiteral("record")));
  setIconSize({16, 16});
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setToolTip(tr("The device is being recorded. Click to show the recordings"));
  hide();
  connect(&session, &HapticSession::recordingStarted, this, &RecordingIndicator::refresh);
  connect(&session, &HapticSession::recorded, this, &RecordingIndicator::refresh);
  connect(&session, &HapticSession::sampled, this, &RecordingIndicator::refresh);
}

// Sixty times a second: the text changes once in that time.
void RecordingIndicator::refresh() {
  const ForceRecorder* const recorder = m_session.recorder();
  if (isHidden() != (recorder == nullptr)) setVisible(recorder != nullptr);
  if (!recorder) return;
  const int seconds = static_cast<int>(recorder->duration());
  const QString shown =
      tr("Recording %1").arg(QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0')));
  if (shown == text()) return;
  setText(shown);
  setAccessibleName(shown);
}

}  // namespace handwheel
