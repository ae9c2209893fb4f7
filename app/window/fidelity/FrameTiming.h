// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QTimer>
#include <deque>

namespace handwheel {

class FidelityChoice;
class Viewport;

// Shows the drawing time of a frame as a fraction of the frame interval. It also shows the predicted time of the other
// work between two frames after an edit. The text appears when a frame has been drawn while the panel is visible.
class FrameTiming : public QLabel {
  Q_OBJECT

 public:
  FrameTiming(Viewport& viewport, FidelityChoice& choice, QWidget* parent = nullptr);

 private:
  void sample();
  void tell();
  QString text() const;
  double predicted() const;  // ms

  Viewport& m_viewport;
  FidelityChoice& m_choice;
  std::deque<double> m_frames;  // latest drawing times, ms
  int m_drawn = 0;              // number of frames that had been drawn at the last sample
  double m_spent = 0.0;         // drawing time of these frames, ms
  QTimer m_pause;               // limits how often the text changes
};

}  // namespace handwheel
