// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace handwheel {

class HapticSession;

// A status bar button that shows the duration of the running recording of the device. It is hidden while nothing is
// recorded.
class RecordingIndicator : public QToolButton {
  Q_OBJECT

 public:
  explicit RecordingIndicator(HapticSession& session,
                              QWidget* parent = nullptr);  // the session must outlive the button

 private:
  void refresh();

  HapticSession& m_session;
};

}  // namespace handwheel
