// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/device/RecordingsPage.h"

namespace handwheel {

class HapticSession;
class Recordings;

// The recordings page connected to the recordings and the session.
class SessionRecordingsPage : public RecordingsPage {
  Q_OBJECT

 public:
  // The recordings and the session must outlive the page.
  SessionRecordingsPage(Recordings& recordings, HapticSession& session, QWidget* parent = nullptr);

 private:
  void showAll();
  void showRecorder();
  void showPlayed();

  Recordings& m_recordings;
  HapticSession& m_session;
};

}  // namespace handwheel
