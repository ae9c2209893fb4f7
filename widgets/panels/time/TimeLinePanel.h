// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/time/TimeAxis.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace handwheel {

class TimePlot;
class TimeTrack;

// Plays and scrubs one or two recordings, with their curves and markers. It shows what it is
// given and says where it is; who shows the recording itself listens. Two recordings stand on one axis, of time or of
// distance, and the first sets the pace. Space plays and stops. Window thread.
class TimeLinePanel : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kSlowest = 0.1, kFastest = 10.0;

  explicit TimeLinePanel(QWidget* parent = nullptr);

  // At most two are shown. Stops, and goes to the beginning, without a signal.
  void setRecordings(std::vector<TimeLineRecording> recordings);
  // Shows a time of the first recording, without a signal.
  void setTime(double seconds);
  // The time that a recording is at, s; 0 where there is none.
  double timeOf(std::size_t recording) const;
  double time() const { return timeOf(0); }

  void setPlaying(bool isPlaying);
  bool isPlaying() const { return m_timer.isActive(); }
  void setSpeed(double speed);  // within kSlowest to kFastest; to the nearest that is offered
  double speed() const;
  void setAxis(TimeAxis::Kind kind);
  // Moves on as playing does, by a time on the clock, s.
  void advance(double seconds);

 signals:
  void timeChanged(double s);  // of the first recording; ask timeOf() for the other one
  void playingChanged(bool isPlaying);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* controls();
  void goTo(double position);
  void showCurves();
  void showLanes();
  void showPosition();
  QString positionText() const;

  std::vector<TimeLineRecording> m_recordings;
  TimeAxis m_axis;
  double m_position = 0.0;  // on the axis
  double m_time = 0.0;      // of the first recording: on the axis of distance it may rest while time goes on
  QTimer m_timer;
  QElapsedTimer m_clock;
  TimePlot* m_plot;
  TimeTrack* m_track;
  QLabel* m_text;
  QToolButton* m_play;
  QToolButton* m_previous;
  QToolButton* m_next;
  QComboBox* m_speed;
  QComboBox* m_kind;
  QComboBox* m_curve;
};

}  // namespace handwheel
