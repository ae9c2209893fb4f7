// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/time/TimeLinePanel.h"

#include "panels/time/TimePlot.h"
#include "panels/time/TimeTrack.h"
#include "theme/Icons.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

constexpr double kSpeeds[] = {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0};
constexpr int kFrameMs = 16;               // while playing: 60 Hz, and 30 Hz where drawing takes as long again
constexpr double kLongestStep = 0.5;       // s: after a pause of the window playback goes on without a leap
constexpr std::size_t kMostShown = 2;      // recordings
constexpr std::size_t kMostPoints = 2000;  // points of a curve

QToolButton* timeButton(const char* name, const char* iconName, const QString& text, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QString::fromLatin1(name));
  button->setIcon(icon(QString::fromLatin1(iconName)));
  button->setToolTip(text);
  button->setAccessibleName(text);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

QComboBox* timeChoice(const char* name, const QString& label, QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(label);
  box->setToolTip(label);
  return box;
}

}  // namespace

TimeLinePanel::TimeLinePanel(QWidget* parent)
    : QWidget(parent),
      m_timer(this),
      m_plot(new TimePlot(this)),
      m_track(new TimeTrack(
          {[this](double p) { return m_plot->screenX(p); }, [this](double x) { return m_plot->positionAt(x); }}, this)),
      m_text(new QLabel(this)) {
  setObjectName(QStringLiteral("timeLinePanel"));
  m_plot->setObjectName(QStringLiteral("timePlot"));
  m_track->setObjectName(QStringLiteral("timeTrack"));
  m_text->setObjectName(QStringLiteral("timeText"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  // The controls stay visible if the panel is low.
  column->addWidget(controls());
  column->addWidget(m_text);
  column->addWidget(m_track);
  column->addWidget(m_plot, 1);
  m_timer.setObjectName(QStringLiteral("timeTimer"));
  m_timer.setTimerType(Qt::PreciseTimer);
  m_timer.setInterval(kFrameMs);
  connect(&m_timer, &QTimer::timeout, this, [this] { advance(1e-3 * static_cast<double>(m_clock.restart())); });
  connect(m_plot, &TimePlot::positionWanted, this, &TimeLinePanel::goTo);
  connect(m_track, &TimeTrack::positionWanted, this, &TimeLinePanel::goTo);
  setRecordings({});
}

QWidget* TimeLinePanel::controls() {
  auto* bar = new QWidget(this);
  m_play = timeButton("timePlay", "play", tr("Play"), bar);
  m_previous = timeButton("timePrevious", "previous", tr("Previous event"), bar);
  m_next = timeButton("timeNext", "next", tr("Next event"), bar);
  m_speed = timeChoice("timeSpeed", tr("Speed"), bar);
  for (double speed : kSpeeds) m_speed->addItem(tr("%1×").arg(locale().toString(speed, 'g', 3)), speed);
  setSpeed(1.0);
  m_kind = timeChoice("timeAxis", tr("Axis"), bar);
  m_kind->addItem(tr("Over time"), static_cast<int>(TimeAxis::Kind::Time));
  m_kind->addItem(tr("Over distance"), static_cast<int>(TimeAxis::Kind::Distance));
  m_curve = timeChoice("timeCurve", tr("Curve"), bar);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (QWidget* part : {static_cast<QWidget*>(m_play), static_cast<QWidget*>(m_previous), static_cast<QWidget*>(m_next),
                        static_cast<QWidget*>(m_speed)}) {
    row->addWidget(part);
  }
  row->addStretch(1);
  row->addWidget(m_kind);
  row->addWidget(m_curve);
  connect(m_play, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
  for (QToolButton* button : {m_previous, m_next}) {
    connect(button, &QToolButton::clicked, this, [this, button] {
      if (const auto next = m_track->nextMarker(button == m_previous)) goTo(*next);
    });
  }
  connect(m_kind, &QComboBox::activated, this,
          [this] { setAxis(static_cast<TimeAxis::Kind>(m_kind->currentData().toInt())); });
  connect(m_curve, &QComboBox::activated, this, &TimeLinePanel::showCurves);
  return bar;
}

void TimeLinePanel::setRecordings(std::vector<TimeLineRecording> recordings) {
  setPlaying(false);
  if (recordings.size() > kMostShown) recordings.resize(kMostShown);
  m_recordings = std::move(recordings);
  m_axis.setRecordings(m_recordings);
  m_position = m_time = 0.0;
  const QString before = m_curve->currentText();
  m_curve->clear();
  for (const TimeLineRecording& recording : m_recordings) {
    for (const TimeLineCurve& curve : recording.curves) {
      if (m_curve->findText(curve.name) < 0) m_curve->addItem(curve.name);
    }
  }
  m_curve->setCurrentIndex(std::max(0, m_curve->findText(before)));
  m_curve->setVisible(m_curve->count() > 1);
  m_kind->setVisible(m_axis.hasDistance());
  setEnabled(!m_recordings.empty());
  setAxis(m_axis.kind());
}

void TimeLinePanel::setAxis(TimeAxis::Kind kind) {
  const double time = m_time;
  m_axis.setKind(kind);
  m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(m_axis.kind())));
  m_position = m_recordings.empty() ? 0.0 : m_axis.positionAt(0, time);
  showCurves();
  showLanes();
  showPosition();
}

void TimeLinePanel::setTime(double seconds) {
  if (m_recordings.empty() || !std::isfinite(seconds)) return;
  m_time = std::clamp(seconds, 0.0, m_axis.duration(0));
  m_position = m_axis.positionAt(0, m_time);
  showPosition();
}

double TimeLinePanel::timeOf(std::size_t recording) const {
  if (recording >= m_recordings.size()) return 0.0;
  return recording == 0 ? m_time : m_axis.timeAt(recording, m_position);
}

void TimeLinePanel::goTo(double position) {
  if (m_recordings.empty() || !std::isfinite(position)) return;
  m_position = std::clamp(position, 0.0, m_axis.length());
  m_time = m_axis.timeAt(0, m_position);
  showPosition();
  emit timeChanged(m_time);
}

void TimeLinePanel::setPlaying(bool isPlaying) {
  if (isPlaying == m_timer.isActive() || (isPlaying && m_axis.length() <= 0.0)) return;
  if (isPlaying && m_position >= m_axis.length()) goTo(0.0);
  isPlaying ? m_timer.start() : m_timer.stop();
  m_clock.start();
  m_play->setIcon(icon(isPlaying ? QStringLiteral("pause") : QStringLiteral("play")));
  m_play->setToolTip(isPlaying ? tr("Pause") : tr("Play"));
  m_play->setAccessibleName(m_play->toolTip());
  emit playingChanged(isPlaying);
}

void TimeLinePanel::setSpeed(double speed) {
  const auto nearer = [speed](double a, double b) { return std::abs(a - speed) < std::abs(b - speed); };
  const double* nearest = std::min_element(std::begin(kSpeeds), std::end(kSpeeds), nearer);
  m_speed->setCurrentIndex(static_cast<int>(nearest - std::begin(kSpeeds)));
}

double TimeLinePanel::speed() const {
  return m_speed->currentData().toDouble();
}

// The first recording sets the pace; after its end, the rest of the other one goes on at its mean speed.
void TimeLinePanel::advance(double seconds) {
  if (m_recordings.empty() || !(seconds > 0.0)) return;
  const double by = std::min(seconds, kLongestStep) * speed();
  const double duration = m_axis.duration(0);
  if (m_time < duration) {
    m_time = std::min(m_time + by, duration);
    m_position = m_axis.positionAt(0, m_time);
  } else {
    const double rate = duration > 0.0 && m_axis.length(0) > 0.0 ? m_axis.length(0) / duration : 1.0;
    m_position = std::min(m_position + by * rate, m_axis.length());
  }
  showPosition();
  emit timeChanged(m_time);
  if (m_time >= duration && m_position >= m_axis.length()) setPlaying(false);
}

void TimeLinePanel::showCurves() {
  Plot plot;
  const bool isTime = m_axis.kind() == TimeAxis::Kind::Time;
  plot.x = {isTime ? tr("Time") : tr("Distance"),
            isTime ? QStringLiteral("s") : QStringLiteral("mm"),
            false,
            {0.0, m_axis.length()}};
  plot.y = {m_curve->currentText(), {}, false, {0.0}};
  plot.locale = locale();
  plot.title = m_recordings.empty()       ? tr("No recording")
               : m_recordings.size() == 1 ? m_recordings.front().name
                                          : tr("Two recordings");
  for (std::size_t i = 0; i < m_recordings.size(); ++i) {
    for (const TimeLineCurve& curve : m_recordings[i].curves) {
      if (curve.name != m_curve->currentText()) continue;
      plot.y.unit = curve.unit;
      PlotSeries series;
      series.name = curve.label.isEmpty() ? m_recordings[i].name : curve.label;
      series.dotted = false;
      series.points = thinnedCurve(curve.points, kMostPoints);
      for (QPointF& point : series.points) point.setX(m_axis.positionAt(i, point.x()));
      plot.series.push_back(std::move(series));
    }
  }
  m_plot->showCurves(std::move(plot));
  m_track->update();
}

void TimeLinePanel::showLanes() {
  std::vector<TimeTrack::Lane> lanes;
  for (std::size_t i = 0; i < m_recordings.size(); ++i) {
    TimeTrack::Lane lane{m_recordings[i].name, m_axis.length(i), {}};
    for (const TimeLineMarker& marker : m_recordings[i].markers) {
      if (std::isfinite(marker.time)) {
        lane.markers.push_back({m_axis.positionAt(i, marker.time), marker.label, marker.severity});
      }
    }
    std::stable_sort(lane.markers.begin(), lane.markers.end(),
                     [](const auto& a, const auto& b) { return a.position < b.position; });
    lanes.push_back(std::move(lane));
  }
  m_track->setLanes(std::move(lanes));
}

QString TimeLinePanel::positionText() const {
  if (m_recordings.empty()) return {};
  const auto number = [this](double value) { return locale().toString(value, 'f', 2); };
  // On the axis of time the line goes to the end of the longer one; on that of distance the time is that of the first.
  const bool isDistance = m_axis.kind() == TimeAxis::Kind::Distance;
  QString text =
      tr("%1 of %2 s")
          .arg(number(isDistance ? m_time : m_position), number(isDistance ? m_axis.duration(0) : m_axis.length()));
  if (isDistance) text += tr(", %1 mm").arg(number(m_position));
  if (const TimeTrack::Marker* marker = m_track->markerHere()) text += QStringLiteral(" · ") + marker->label;
  return text;
}

void TimeLinePanel::showPosition() {
  m_plot->setPosition(m_position);
  m_track->setPosition(m_position, {});
  const QString text = positionText();
  m_track->setPosition(m_position, text);
  m_text->setText(text);
  m_text->setToolTip(text);
  m_previous->setEnabled(m_track->nextMarker(true).has_value());
  m_next->setEnabled(m_track->nextMarker(false).has_value());
}

void TimeLinePanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space) return QWidget::keyPressEvent(event);
  setPlaying(!isPlaying());
}

void TimeLinePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LocaleChange) showCurves(), showPosition();
  QWidget::changeEvent(event);
}

void TimeLinePanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  m_track->update();
}

}  // namespace handwheel
