// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/ProgramPlayer.h"

#include "theme/Icons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kFrameTimeMs = 40;
constexpr double kLongestLeap = 0.25;  // s on the clock: after a pause of the window it goes on, and does not leap
constexpr int kPlayerSteps = 10'000;   // steps of the slider
constexpr int kTimes[] = {1, 2, 5, 10, 20, 50, 100};
constexpr int kUsualTimes = 3;  // index: ten times as fast as the machine

}  // namespace

QString programTime(double seconds) {
  const auto tenths = static_cast<qint64>(std::llround(10.0 * seconds));
  const qint64 minutes = tenths / 600;
  const auto two = [](qint64 n) { return QStringLiteral("%1").arg(n, 2, 10, QLatin1Char('0')); };
  const QString rest = QStringLiteral("%1.%2").arg(two(tenths / 10 % 60)).arg(tenths % 10);
  return minutes < 60 ? QStringLiteral("%1:%2").arg(minutes).arg(rest)
                      : QStringLiteral("%1:%2:%3").arg(minutes / 60).arg(two(minutes % 60), rest);
}

ProgramPlayer::ProgramPlayer(QWidget* parent)
    : QWidget(parent),
      m_back(button("programBack", "previous", tr("One line back"))),
      m_play(button("programPlay", "play", tr("Play"))),
      m_step(button("programStep", "next", tr("One line on"))),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_speed(new QComboBox(this)),
      m_text(new QLabel(this)) {
  setObjectName(QStringLiteral("programPlayer"));
  m_slider->setObjectName(QStringLiteral("programTimeSlider"));
  m_slider->setAccessibleName(tr("Time in the program"));
  m_slider->setRange(0, kPlayerSteps);
  m_slider->setPageStep(kPlayerSteps / 20);
  m_speed->setObjectName(QStringLiteral("programSpeed"));
  m_speed->setAccessibleName(tr("Speed of playing"));
  m_speed->setToolTip(tr("Speed relative to that of the machine"));
  for (const int times : kTimes) m_speed->addItem(tr("%1×").arg(times), times);
  m_speed->setCurrentIndex(kUsualTimes);
  m_text->setObjectName(QStringLiteral("programTimeText"));
  m_text->setTextFormat(Qt::PlainText);
  auto* row = new QHBoxLayout;
  for (QWidget* part : std::initializer_list<QWidget*>{m_back, m_play, m_step, m_speed}) row->addWidget(part);
  row->addStretch();
  row->addWidget(m_text);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(m_slider);
  column->addLayout(row);
  m_clock.setInterval(kFrameTimeMs);
  connect(&m_clock, &QTimer::timeout, this, &ProgramPlayer::advance);
  connect(m_play, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
  connect(m_back, &QToolButton::clicked, this, [this] {
    setPlaying(false);
    emit stepWanted(true);
  });
  connect(m_step, &QToolButton::clicked, this, [this] {
    setPlaying(false);
    emit stepWanted(false);
  });
  connect(m_slider, &QSlider::valueChanged, this, &ProgramPlayer::wind);
  setDuration(0.0);
}

QToolButton* ProgramPlayer::button(const char* name, const char* iconName, const QString& tip) {
  auto* made = new QToolButton(this);
  made->setObjectName(QString::fromLatin1(name));
  made->setIcon(icon(QString::fromLatin1(iconName)));
  made->setToolTip(tip);
  made->setAccessibleName(tip);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

void ProgramPlayer::setDuration(double seconds) {
  setPlaying(false);
  m_duration = std::max(seconds, 0.0);
  setEnabled(m_duration > 0.0);
  setTime(0.0);
}

void ProgramPlayer::setTime(double seconds) {
  m_time = std::clamp(seconds, 0.0, m_duration);
  const QSignalBlocker quiet(m_slider);
  m_slider->setValue(m_duration > 0.0 ? static_cast<int>(std::lround(kPlayerSteps * m_time / m_duration)) : 0);
  m_text->setText(m_duration > 0.0 ? tr("%1 of %2").arg(programTime(m_time), programTime(m_duration)) : QString());
}

void ProgramPlayer::setPlaying(bool isPlaying) {
  if (isPlaying == m_clock.isActive() || (isPlaying && !(m_duration > 0.0))) return;
  if (isPlaying && m_time >= m_duration) emit timeWanted(0.0);
  isPlaying ? m_clock.start() : m_clock.stop();
  m_since.start();
  m_play->setIcon(icon(isPlaying ? QStringLiteral("pause") : QStringLiteral("play")));
  m_play->setToolTip(isPlaying ? tr("Pause") : tr("Play"));
  m_play->setAccessibleName(m_play->toolTip());
}

void ProgramPlayer::advance() {
  const double seconds = std::min(1e-3 * static_cast<double>(m_since.restart()), kLongestLeap);
  const double to = m_time + seconds * m_speed->currentData().toInt();
  emit timeWanted(std::min(to, m_duration));
  if (to >= m_duration) setPlaying(false);
}

void ProgramPlayer::wind(int position) {
  setPlaying(false);
  emit timeWanted(m_duration * position / kPlayerSteps);
}

}  // namespace handwheel
