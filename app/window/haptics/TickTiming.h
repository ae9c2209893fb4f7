// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <deque>

namespace handwheel {

class FidelityChoice;
class HapticSession;

// Shows the duration of a servo tick as a share of its period. Shows beside it the duration that the curves predict for
// a tick in contact. Visible while a device is open. Computed exactly from the latest ticks, while ServoStatistics
// counts in bins of 5 us.
class TickTiming : public QLabel {
  Q_OBJECT

 public:
  TickTiming(HapticSession& session, FidelityChoice& choice, QWidget* parent = nullptr);

 private:
  void sample();
  QString text() const;

  struct Tick {
    double microseconds;
    bool isContact;
  };
  HapticSession& m_session;
  FidelityChoice& m_choice;
  std::deque<Tick> m_ticks;
  int m_sinceUpdate = 0;  // samples since the text was updated
};

}  // namespace handwheel
