// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <deque>

namespace handwheel {

class FidelityChoice;
class HapticSession;

// Shows the duration of a servo tick as a share of its period. Beside it stands the duration that the measured cost
// curves of the fidelity settings predict for a tick in contact. The label is visible while a device is open. The
// durations are medians of the latest ticks. ServoStatistics would be too coarse, because it counts in bins of 5 µs.
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
