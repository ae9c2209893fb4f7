// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QTimer>
#include <deque>

namespace handwheel {

class FidelityChoice;
class Viewport;

// Says how much of the time between two frames the drawing of one takes, and beside it what the curves predict for what
// is done between two frames besides, after an edit. Shown once a frame was drawn while the panel was seen.
class FrameUse : public QLabel {
  Q_OBJECT

 public:
  FrameUse(Viewport& viewport, FidelityChoice& choice, QWidget* parent = nullptr);

 private:
  void sample();
  void tell();
  QString text() const;
  double predicted() const;  // ms

  Viewport& m_viewport;
  FidelityChoice& m_choice;
  std::deque<double> m_frames;  // ms each, the latest
  int m_drawn = 0;              // frames, when one was last looked at,
  double m_spent = 0.0;         // and ms of drawing
  QTimer m_pause;               // from one text to the next
};

}  // namespace handwheel
