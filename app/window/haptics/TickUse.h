// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <deque>

namespace handwheel {

class FidelityChoice;
class HapticSession;

// Says how much of the servo tick is in use, and beside it what the curves predict for a tick that touches a surface.
// Shown while a device is open. What LoopMeasure counts in bins of 5 us is taken exactly here, from the latest ticks.
class TickUse : public QLabel {
  Q_OBJECT

 public:
  TickUse(HapticSession& session, FidelityChoice& choice, QWidget* parent = nullptr);

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
  int m_untold = 0;  // samples since the text was made
};

}  // namespace handwheel
