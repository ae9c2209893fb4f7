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

// A panel that plays and scrubs one or two recordings, with their curves and markers. The panel does not show a
// recording itself, but emits the time for the code that shows it. Two recordings share one axis, of time or distance,
// and the first one determines the speed. The space bar plays and stops. All calls must be made on the window thread.
class TimeLinePanel : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kSlowest = 0.1, kFastest = 10.0;

  explicit TimeLinePanel(QWidget* parent = nullptr);

  // Sets the recordings, of which at most two are shown. Stops the playback and goes to the beginning, without emitting
  // a signal.
  void setRecordings(std::vector<TimeLineRecording> recordings);
  // Shows a time of the first recording, without emitting a signal.
  void setTime(double seconds);
  // Returns the present time of a recording, s, or 0 if the recording does not exist.
  double timeOf(std::size_t recording) const;
  double time() const { return timeOf(0); }

  void setPlaying(bool isPlaying);
  bool isPlaying() const { return m_timer.isActive(); }
  void setSpeed(double speed);  // from kSlowest to kFastest; the nearest available speed is used
  double speed() const;
  void setAxis(TimeAxis::Kind kind);
  // Advances the position by an elapsed real time, s, like playback.
  void advance(double seconds);

 signals:
  void timeChanged(double s);  // s: time of the first recording; see timeOf() for the other one
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
  double m_position = 0.0;  // position on the axis
  // Time of the first recording, s. On a distance axis, the position may rest while time passes.
  double m_time = 0.0;
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
