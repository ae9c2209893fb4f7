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

// Controls to play a program by line and by time. They are Back, Play or Pause, Step, a slider, and how much faster
// than the machine it plays. It says what is wanted, and shows the time that it is given. Window thread.
class ProgramPlayer : public QWidget {
  Q_OBJECT

 public:
  explicit ProgramPlayer(QWidget* parent = nullptr);

  // The length of a run, s; 0: there is none, and nothing to play. Stops.
  void setDuration(double seconds);
  void setTime(double seconds);  // without a signal
  double time() const { return m_time; }
  void setPlaying(bool isPlaying);
  bool isPlaying() const { return m_clock.isActive(); }

 signals:
  void timeWanted(double seconds);
  void stepWanted(bool isBack);

 private:
  QToolButton* button(const char* name, const char* iconName, const QString& tip);
  void advance();
  void wind(int place);

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

// "1:05.3": minutes and seconds, with hours where there are some.
QString programTime(double seconds);

}  // namespace handwheel
