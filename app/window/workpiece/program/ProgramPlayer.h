// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace handwheel {

// Controls to play a program by line and by time. They are Back, Play or Pause, Step, a slider, and the speed relative
// to the machine. They request times through signals and show the time that is set. It must be used on the window
// thread.
class ProgramPlayer : public QWidget {
  Q_OBJECT

 public:
  explicit ProgramPlayer(QWidget* parent = nullptr);

  // Sets the duration of a run, s; 0: there is no run. Stops playing.
  void setDuration(double seconds);
  void setTime(double seconds);  // emits no signal
  double time() const { return m_time; }
  void setPlaying(bool isPlaying);
  bool isPlaying() const { return m_clock.isActive(); }

 signals:
  void timeWanted(double seconds);
  void stepWanted(bool isBack);

 private:
  QToolButton* button(const char* name, const char* iconName, const QString& tip);
  void advance();
  void wind(int position);

  QToolButton* m_back;
  QToolButton* m_play;
  QToolButton* m_step;
  QSlider* m_slider;
  QComboBox* m_speed;
  QLabel* m_text;
  QTimer m_clock;
  QElapsedTimer m_since;
  double m_duration = 0.0;
  double m_time = 0.0;
};

// Returns a time as minutes and seconds, such as "1:05.3", with hours if there are any.
QString programTime(double seconds);

}  // namespace handwheel
