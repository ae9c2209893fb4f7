// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/time/TimeLinePanel.h"

#include "ControlPictures.h"
#include "ControlsTestMain.h"
#include "panels/time/TimePlot.h"
#include "panels/time/TimeTrack.h"

#include <QComboBox>
#include <QHelpEvent>
#include <QSignalSpy>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <cmath>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A pass of 10 s with a moderate and a strong event.
TimeLineRecording passOf(const QString& name, double duration, double mmPerSecond) {
  TimeLineRecording pass;
  pass.name = name;
  pass.duration = duration;
  TimeLineCurve force{"Cutting force", "N", {}}, depth{"Depth of cut", "mm", {}};
  for (int i = 0; i <= 1000; ++i) {
    const double t = 1e-3 * i * duration;
    force.points.emplace_back(t, 400.0 + 150.0 * std::sin(3.0 * t));
    depth.points.emplace_back(t, 1.0 + 0.1 * t);
  }
  pass.curves = {force, depth};
  pass.markers = {{0.8 * duration, "Collision: tool holder with jaw", TimeLineMarker::Severity::Error},
                  {0.3 * duration, "Force peak 550 N", TimeLineMarker::Severity::Warning}};
  pass.distance = {{0.0, 0.0}, {duration, mmPerSecond * duration}};
  return pass;
}

struct TimeBench {
  explicit TimeBench(std::vector<TimeLineRecording> recordings) {
    panel.setRecordings(std::move(recordings));
    panel.resize(640, 360);
    panel.show();
    panel.activateWindow();
    if (!QTest::qWaitForWindowActive(&panel)) qFatal("the panel does not appear");
    track = panel.findChild<TimeTrack*>("timeTrack");
    plot = panel.findChild<TimePlot*>("timePlot");
    track->setFocus();
  }
  template <class Widget>
  Widget* part(const char* name) {
    return panel.findChild<Widget*>(name);
  }
  QPoint onTrack(double position) const {  // of the only lane
    return {static_cast<int>(std::lround(plot->screenX(position))), track->height() - 8};
  }
  TimeLinePanel panel;
  TimeTrack* track;
  TimePlot* plot;
};

}  // namespace

class TimeLinePanelTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }
  void scrubs();
  void boundsAreNamed();
  void whatIsSetIsNotSaid();
  void plays();
  void playsOnItsOwn();
  void playsSmoothly();
  void speeds();
  void jumpsToMarkers();
  void keys();
  void curves();
  void twoOverTime();
  void twoOverDistance();
  void toolTips();
  void empty();
  void extremes();
  void pictures();
};

void TimeLinePanelTest::scrubs() {
  TimeBench bench({passOf("pass", 10.0, 2.0)});
  QSignalSpy times(&bench.panel, &TimeLinePanel::timeChanged);
  const double pixel = bench.plot->positionAt(101.0) - bench.plot->positionAt(100.0);
  QTest::mouseClick(bench.track, Qt::LeftButton, {}, bench.onTrack(5.0));
  QCOMPARE(times.size(), 1);
  QVERIFY(std::abs(bench.panel.time() - 5.0) <= pixel);
  QCOMPARE(times[0][0].toDouble(), bench.panel.time());
  QTest::mouseClick(bench.plot, Qt::LeftButton, {},
                    {static_cast<int>(std::lround(bench.plot->screenX(2.0))), bench.plot->height() / 2});
  QVERIFY(std::abs(bench.panel.time() - 2.0) <= pixel);
  QTest::mouseClick(bench.track, Qt::LeftButton, {}, {bench.track->width() - 1, 5});
  QCOMPARE(bench.panel.time(), 10.0);
  QTest::mouseClick(bench.track, Qt::LeftButton, {}, {0, 5});
  QCOMPARE(bench.panel.time(), 0.0);
}

// A bound beside a curve has its own name.
void TimeLinePanelTest::boundsAreNamed() {
  TimeLineRecording pass = passOf("pass", 10.0, 2.0);
  pass.curves.push_back({"Cutting force", "N", {{0.0, 500.0}, {10.0, 500.0}}, "Most that is allowed"});
  TimeBench bench({pass});
  const std::vector<PlotSeries>& series = bench.plot->plot().series;
  QCOMPARE(series.size(), std::size_t{2});
  QCOMPARE(series[0].name, QString("pass"));
  QCOMPARE(series[1].name, QString("Most that is allowed"));
  QVERIFY((series[1].points == std::vector<QPointF>{{0.0, 500.0}, {10.0, 500.0}}));
}

void TimeLinePanelTest::whatIsSetIsNotSaid() {
  TimeBench bench({passOf("pass", 10.0, 2.0)});
  QSignalSpy times(&bench.panel, &TimeLinePanel::timeChanged);
  bench.panel.setTime(3.25);
  QCOMPARE(bench.panel.time(), 3.25);
  QVERIFY(bench.part<QLabel>("timeText")->text().startsWith("3.25 of 10.00 s"));
  bench.panel.setTime(99.0);
  QCOMPARE(bench.panel.time(), 10.0);
  bench.panel.setTime(std::numeric_limits<double>::quiet_NaN());
  QCOMPARE(bench.panel.time(), 10.0);
  QCOMPARE(times.size(), 0);
}

void TimeLinePanelTest::plays() {
  TimeBench bench({passOf("pass", 1.0, 2.0)});
  QSignalSpy times(&bench.panel, &TimeLinePanel::timeChanged), states(&bench.panel, &TimeLinePanel::playingChanged);
  bench.panel.setPlaying(true);
  for (int i = 0; i < 3; ++i) bench.panel.advance(0.25);
  QVERIFY(std::abs(bench.panel.time() - 0.75) < 0.2);  // the clock plays, too
  QVERIFY(bench.panel.isPlaying());
  bench.panel.advance(0.4);
  QCOMPARE(bench.panel.time(), 1.0);
  QVERIFY(!bench.panel.isPlaying());  // the end stops it
  QCOMPARE(states.size(), 2);
  bench.panel.setPlaying(true);  // once more from the beginning
  QVERIFY(bench.panel.time() < 0.2);
  bench.panel.setPlaying(false);
  const double stopped = bench.panel.time();
  bench.panel.advance(-1.0);
  bench.panel.advance(std::numeric_limits<double>::quiet_NaN());
  QCOMPARE(bench.panel.time(), stopped);
  bench.panel.advance(100.0);  // the window was busy: it does not leap
  QVERIFY(bench.panel.time() <= stopped + 0.5);
}

void TimeLinePanelTest::playsOnItsOwn() {
  TimeBench bench({passOf("pass", 0.3, 2.0)});
  QTest::mouseClick(bench.part<QToolButton>("timePlay"), Qt::LeftButton);
  QVERIFY(bench.panel.isPlaying());
  QTRY_COMPARE(bench.panel.time(), 0.3);
  QVERIFY(!bench.panel.isPlaying());
}

// At 30 Hz or more: its frames are counted beside a clock of 30 Hz in the same loop of events, which a busy machine
// holds up by as much.
void TimeLinePanelTest::playsSmoothly() {
  TimeBench bench({passOf("pass", 100.0, 2.0)});
  const auto* own = bench.part<QTimer>("timeTimer");
  QVERIFY(own->interval() * 30 <= 1000);
  QCOMPARE(own->timerType(), Qt::PreciseTimer);
  int ticks = 0;
  QTimer clock;
  clock.setTimerType(Qt::PreciseTimer);
  clock.setInterval(1000 / 30);
  connect(&clock, &QTimer::timeout, this, [&ticks] { ++ticks; });
  QSignalSpy frames(&bench.panel, &TimeLinePanel::timeChanged);
  bench.panel.setPlaying(true);
  clock.start();
  QTRY_VERIFY_WITH_TIMEOUT(ticks >= 30, 60'000);
  bench.panel.setPlaying(false);
  QVERIFY2(frames.size() >= ticks - 1, qPrintable(QString::number(frames.size())));
  double before = 0.0;  // each shows a later time
  for (const auto& frame : frames) {
    QVERIFY(frame[0].toDouble() > before);
    before = frame[0].toDouble();
  }
}

void TimeLinePanelTest::speeds() {
  TimeBench bench({passOf("pass", 10.0, 2.0)});
  for (double speed : {0.1, 1.0, 10.0}) {
    bench.panel.setTime(1.0);
    bench.panel.setSpeed(speed);
    QCOMPARE(bench.panel.speed(), speed);
    bench.panel.advance(0.25);
    QVERIFY(std::abs(bench.panel.time() - 1.0 - 0.25 * speed) < 1e-9);
  }
  bench.panel.setSpeed(1e9);
  QCOMPARE(bench.panel.speed(), TimeLinePanel::kFastest);
  bench.panel.setSpeed(-1.0);
  QCOMPARE(bench.panel.speed(), TimeLinePanel::kSlowest);
}

void TimeLinePanelTest::jumpsToMarkers() {
  TimeBench bench({passOf("pass", 10.0, 2.0)});
  auto* next = bench.part<QToolButton>("timeNext");
  auto* previous = bench.part<QToolButton>("timePrevious");
  QVERIFY(next->isEnabled() && !previous->isEnabled());
  QTest::mouseClick(next, Qt::LeftButton);
  QCOMPARE(bench.panel.time(), 3.0);
  QVERIFY(bench.part<QLabel>("timeText")->text().endsWith("Force peak 550 N"));
  QTest::mouseClick(next, Qt::LeftButton);
  QCOMPARE(bench.panel.time(), 8.0);
  QVERIFY(!next->isEnabled());
  QTest::mouseClick(previous, Qt::LeftButton);
  QCOMPARE(bench.panel.time(), 3.0);
  QTest::mouseClick(bench.track, Qt::LeftButton, {}, bench.onTrack(8.0) + QPoint(3, 0));  // near is on it
  QCOMPARE(bench.panel.time(), 8.0);
}

void TimeLinePanelTest::keys() {
  TimeBench bench({passOf("pass", 10.0, 2.0)});
  const auto press = [&bench](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(bench.track, key, modifiers);
    return bench.panel.time();
  };
  QCOMPARE(press(Qt::Key_Right), 0.1);  // a hundredth of the length
  QCOMPARE(press(Qt::Key_Right, Qt::ShiftModifier), 1.1);
  QVERIFY(std::abs(press(Qt::Key_Left, Qt::ControlModifier) - 1.09) < 1e-9);
  QCOMPARE(press(Qt::Key_End), 10.0);
  QCOMPARE(press(Qt::Key_PageUp), 8.0);
  QCOMPARE(press(Qt::Key_PageUp), 3.0);
  QCOMPARE(press(Qt::Key_PageUp), 3.0);
  QCOMPARE(press(Qt::Key_PageDown), 8.0);
  QCOMPARE(press(Qt::Key_Home), 0.0);
  press(Qt::Key_Space);
  QVERIFY(bench.panel.isPlaying());
  press(Qt::Key_Space);
  QVERIFY(!bench.panel.isPlaying());
  QVERIFY(bench.track->accessibleDescription().contains("of 10.00 s"));
}

void TimeLinePanelTest::curves() {
  TimeBench bench({passOf("pass", 10.0, 2.0)});
  auto* choice = bench.part<QComboBox>("timeCurve");
  QCOMPARE(choice->count(), 2);
  QCOMPARE(bench.plot->plot().y.title, QString("Cutting force"));
  QCOMPARE(bench.plot->plot().y.unit, QString("N"));
  QCOMPARE(bench.plot->plot().series.size(), std::size_t(1));
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  QCOMPARE(bench.plot->plot().y.unit, QString("mm"));
  bench.panel.setRecordings({passOf("again", 5.0, 2.0)});
  QCOMPARE(choice->currentText(), QString("Depth of cut"));  // the choice stays
}

void TimeLinePanelTest::twoOverTime() {
  TimeBench bench({passOf("Anna", 10.0, 2.0), passOf("Ben", 16.0, 1.25), passOf("third", 1.0, 1.0)});
  QCOMPARE(bench.plot->plot().series.size(), std::size_t(2));
  QCOMPARE(bench.plot->plot().series[1].name, QString("Ben"));
  bench.panel.setTime(4.0);
  QCOMPARE(bench.panel.timeOf(1), 4.0);
  QCOMPARE(bench.panel.timeOf(2), 0.0);
  QVERIFY(bench.part<QLabel>("timeText")->text().startsWith("4.00 of 16.00 s"));
  QTest::keyClick(bench.track, Qt::Key_End);
  QCOMPARE(bench.panel.timeOf(0), 10.0);
  QCOMPARE(bench.panel.timeOf(1), 16.0);
  QVERIFY(bench.part<QLabel>("timeText")->text().startsWith("16.00 of 16.00 s"));
  bench.panel.setTime(9.9);
  bench.panel.setPlaying(true);
  bench.panel.advance(0.2);
  bench.panel.advance(0.5);
  QCOMPARE(bench.panel.timeOf(0), 10.0);
  QVERIFY(bench.panel.timeOf(1) >= 10.4 && bench.panel.isPlaying());  // the longer one goes on
}

// Both went 20 mm: after 5 mm one had taken 2.5 s, the other one 4 s.
void TimeLinePanelTest::twoOverDistance() {
  TimeBench bench({passOf("Anna", 10.0, 2.0), passOf("Ben", 16.0, 1.25)});
  bench.panel.setTime(2.5);
  bench.panel.setAxis(TimeAxis::Kind::Distance);
  QCOMPARE(bench.panel.time(), 2.5);
  QCOMPARE(bench.panel.timeOf(1), 4.0);
  QCOMPARE(bench.plot->plot().x.unit, QString("mm"));
  QCOMPARE(bench.plot->plot().series[1].points.back().x(), 20.0);
  bench.panel.advance(0.5);
  QCOMPARE(bench.panel.time(), 3.0);  // the first sets the pace
  QCOMPARE(bench.panel.timeOf(1), 4.8);
  QVERIFY(bench.part<QLabel>("timeText")->text().contains("6.00 mm"));
  QTest::keyClick(bench.track, Qt::Key_PageDown);
  QTest::keyClick(bench.track, Qt::Key_PageDown);
  QVERIFY(std::abs(bench.panel.time() - 8.0) < 1e-9);
  QVERIFY(std::abs(bench.panel.timeOf(1) - 12.8) < 1e-9);
}

void TimeLinePanelTest::toolTips() {
  TimeBench bench({passOf("pass", 10.0, 2.0)});
  const QPoint place = bench.onTrack(8.0);
  QHelpEvent help(QEvent::ToolTip, place, bench.track->mapToGlobal(place));
  QApplication::sendEvent(bench.track, &help);
  QCOMPARE(QToolTip::text(), QString("Collision: tool holder with jaw"));
  QToolTip::hideText();
}

void TimeLinePanelTest::empty() {
  TimeBench bench({});
  QVERIFY(!bench.panel.isEnabled());
  bench.panel.setPlaying(true);
  QVERIFY(!bench.panel.isPlaying());
  bench.panel.advance(1.0);
  bench.panel.setTime(1.0);
  bench.panel.setAxis(TimeAxis::Kind::Distance);
  QCOMPARE(bench.panel.time(), 0.0);
  bench.panel.grab();
  bench.panel.setRecordings({passOf("pass", 10.0, 2.0)});
  QVERIFY(bench.panel.isEnabled());
}

void TimeLinePanelTest::extremes() {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN(),
                   kEndless = std::numeric_limits<double>::infinity();
  for (double duration : {0.0, -1.0, 1e-9, 1e12, kNothing, kEndless}) {
    TimeLineRecording wild;
    wild.duration = duration;
    wild.curves = {{"a", "", {{kNothing, 1}, {0, kEndless}, {1e300, 1e300}}}, {"", "", {}}};
    wild.markers = {{kNothing, "no time"}, {-1.0, "before"}, {1e300, "far"}};
    TimeBench bench({wild, wild});
    bench.panel.setPlaying(true);
    bench.panel.advance(0.4);
    for (auto key : {Qt::Key_Right, Qt::Key_PageDown, Qt::Key_End, Qt::Key_PageUp}) QTest::keyClick(bench.track, key);
    bench.panel.grab();
    QVERIFY(std::isfinite(bench.panel.time()) && bench.panel.time() >= 0.0);
  }
}

void TimeLinePanelTest::pictures() {
  TimeBench one({passOf("Shaft, first pass", 10.0, 2.0)});
  one.panel.setTime(3.0);
  lookAt(one.panel, "time-one");
  TimeBench two({passOf("Anna", 10.0, 2.0), passOf("Ben", 16.0, 1.25)});
  two.panel.setTime(6.0);
  two.panel.setAxis(TimeAxis::Kind::Distance);
  lookAt(two.panel, "time-two");
  two.panel.resize(420, 280);
  lookAt(two.panel, "time-small");
}

HANDWHEEL_CONTROLS_TEST(TimeLinePanelTest)
#include "TimeLinePanelTest.moc"
