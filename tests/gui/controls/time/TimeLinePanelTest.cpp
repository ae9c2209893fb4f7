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

// Returns a pass of 10 s with a moderate and a strong event.
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

struct TimeFixture {
  explicit TimeFixture(std::vector<TimeLineRecording> recordings) {
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
  QPoint onTrack(double position) const {  // for the only lane
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
  TimeFixture fixture({passOf("pass", 10.0, 2.0)});
  QSignalSpy times(&fixture.panel, &TimeLinePanel::timeChanged);
  const double pixel = fixture.plot->positionAt(101.0) - fixture.plot->positionAt(100.0);
  QTest::mouseClick(fixture.track, Qt::LeftButton, {}, fixture.onTrack(5.0));
  QCOMPARE(times.size(), 1);
  QVERIFY(std::abs(fixture.panel.time() - 5.0) <= pixel);
  QCOMPARE(times[0][0].toDouble(), fixture.panel.time());
  QTest::mouseClick(fixture.plot, Qt::LeftButton, {},
                    {static_cast<int>(std::lround(fixture.plot->screenX(2.0))), fixture.plot->height() / 2});
  QVERIFY(std::abs(fixture.panel.time() - 2.0) <= pixel);
  QTest::mouseClick(fixture.track, Qt::LeftButton, {}, {fixture.track->width() - 1, 5});
  QCOMPARE(fixture.panel.time(), 10.0);
  QTest::mouseClick(fixture.track, Qt::LeftButton, {}, {0, 5});
  QCOMPARE(fixture.panel.time(), 0.0);
}

// A bound beside a curve has its own name.
void TimeLinePanelTest::boundsAreNamed() {
  TimeLineRecording pass = passOf("pass", 10.0, 2.0);
  pass.curves.push_back({"Cutting force", "N", {{0.0, 500.0}, {10.0, 500.0}}, "Most that is allowed"});
  TimeFixture fixture({pass});
  const std::vector<PlotSeries>& series = fixture.plot->plot().series;
  QCOMPARE(series.size(), std::size_t{2});
  QCOMPARE(series[0].name, QString("pass"));
  QCOMPARE(series[1].name, QString("Most that is allowed"));
  QVERIFY((series[1].points == std::vector<QPointF>{{0.0, 500.0}, {10.0, 500.0}}));
}

void TimeLinePanelTest::whatIsSetIsNotSaid() {
  TimeFixture fixture({passOf("pass", 10.0, 2.0)});
  QSignalSpy times(&fixture.panel, &TimeLinePanel::timeChanged);
  fixture.panel.setTime(3.25);
  QCOMPARE(fixture.panel.time(), 3.25);
  QVERIFY(fixture.part<QLabel>("timeText")->text().startsWith("3.25 of 10.00 s"));
  fixture.panel.setTime(99.0);
  QCOMPARE(fixture.panel.time(), 10.0);
  fixture.panel.setTime(std::numeric_limits<double>::quiet_NaN());
  QCOMPARE(fixture.panel.time(), 10.0);
  QCOMPARE(times.size(), 0);
}

void TimeLinePanelTest::plays() {
  TimeFixture fixture({passOf("pass", 1.0, 2.0)});
  QSignalSpy times(&fixture.panel, &TimeLinePanel::timeChanged), states(&fixture.panel, &TimeLinePanel::playingChanged);
  fixture.panel.setPlaying(true);
  for (int i = 0; i < 3; ++i) fixture.panel.advance(0.25);
  QVERIFY(std::abs(fixture.panel.time() - 0.75) < 0.2);  // the clock plays, too
  QVERIFY(fixture.panel.isPlaying());
  fixture.panel.advance(0.4);
  QCOMPARE(fixture.panel.time(), 1.0);
  QVERIFY(!fixture.panel.isPlaying());  // the end stops it
  QCOMPARE(states.size(), 2);
  fixture.panel.setPlaying(true);  // once more from the beginning
  QVERIFY(fixture.panel.time() < 0.2);
  fixture.panel.setPlaying(false);
  const double stopped = fixture.panel.time();
  fixture.panel.advance(-1.0);
  fixture.panel.advance(std::numeric_limits<double>::quiet_NaN());
  QCOMPARE(fixture.panel.time(), stopped);
  fixture.panel.advance(100.0);  // the window was busy: it does not leap
  QVERIFY(fixture.panel.time() <= stopped + 0.5);
}

void TimeLinePanelTest::playsOnItsOwn() {
  TimeFixture fixture({passOf("pass", 0.3, 2.0)});
  QTest::mouseClick(fixture.part<QToolButton>("timePlay"), Qt::LeftButton);
  QVERIFY(fixture.panel.isPlaying());
  QTRY_COMPARE(fixture.panel.time(), 0.3);
  QVERIFY(!fixture.panel.isPlaying());
}

// Playback is at 30 Hz or more: its frames are counted beside a clock of 30 Hz in the same event loop, which a busy
// machine delays by as much.
void TimeLinePanelTest::playsSmoothly() {
  TimeFixture fixture({passOf("pass", 100.0, 2.0)});
  const auto* own = fixture.part<QTimer>("timeTimer");
  QVERIFY(own->interval() * 30 <= 1000);
  QCOMPARE(own->timerType(), Qt::PreciseTimer);
  int ticks = 0;
  QTimer clock;
  clock.setTimerType(Qt::PreciseTimer);
  clock.setInterval(1000 / 30);
  connect(&clock, &QTimer::timeout, this, [&ticks] { ++ticks; });
  QSignalSpy frames(&fixture.panel, &TimeLinePanel::timeChanged);
  fixture.panel.setPlaying(true);
  clock.start();
  QTRY_VERIFY_WITH_TIMEOUT(ticks >= 30, 60'000);
  fixture.panel.setPlaying(false);
  QVERIFY2(frames.size() >= ticks - 1, qPrintable(QString::number(frames.size())));
  double before = 0.0;  // each shows a later time
  for (const auto& frame : frames) {
    QVERIFY(frame[0].toDouble() > before);
    before = frame[0].toDouble();
  }
}

void TimeLinePanelTest::speeds() {
  TimeFixture fixture({passOf("pass", 10.0, 2.0)});
  for (double speed : {0.1, 1.0, 10.0}) {
    fixture.panel.setTime(1.0);
    fixture.panel.setSpeed(speed);
    QCOMPARE(fixture.panel.speed(), speed);
    fixture.panel.advance(0.25);
    QVERIFY(std::abs(fixture.panel.time() - 1.0 - 0.25 * speed) < 1e-9);
  }
  fixture.panel.setSpeed(1e9);
  QCOMPARE(fixture.panel.speed(), TimeLinePanel::kFastest);
  fixture.panel.setSpeed(-1.0);
  QCOMPARE(fixture.panel.speed(), TimeLinePanel::kSlowest);
}

void TimeLinePanelTest::jumpsToMarkers() {
  TimeFixture fixture({passOf("pass", 10.0, 2.0)});
  auto* next = fixture.part<QToolButton>("timeNext");
  auto* previous = fixture.part<QToolButton>("timePrevious");
  QVERIFY(next->isEnabled() && !previous->isEnabled());
  QTest::mouseClick(next, Qt::LeftButton);
  QCOMPARE(fixture.panel.time(), 3.0);
  QVERIFY(fixture.part<QLabel>("timeText")->text().endsWith("Force peak 550 N"));
  QTest::mouseClick(next, Qt::LeftButton);
  QCOMPARE(fixture.panel.time(), 8.0);
  QVERIFY(!next->isEnabled());
  QTest::mouseClick(previous, Qt::LeftButton);
  QCOMPARE(fixture.panel.time(), 3.0);
  QTest::mouseClick(fixture.track, Qt::LeftButton, {}, fixture.onTrack(8.0) + QPoint(3, 0));  // near is on it
  QCOMPARE(fixture.panel.time(), 8.0);
}

void TimeLinePanelTest::keys() {
  TimeFixture fixture({passOf("pass", 10.0, 2.0)});
  const auto press = [&fixture](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(fixture.track, key, modifiers);
    return fixture.panel.time();
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
  QVERIFY(fixture.panel.isPlaying());
  press(Qt::Key_Space);
  QVERIFY(!fixture.panel.isPlaying());
  QVERIFY(fixture.track->accessibleDescription().contains("of 10.00 s"));
}

void TimeLinePanelTest::curves() {
  TimeFixture fixture({passOf("pass", 10.0, 2.0)});
  auto* choice = fixture.part<QComboBox>("timeCurve");
  QCOMPARE(choice->count(), 2);
  QCOMPARE(fixture.plot->plot().y.title, QString("Cutting force"));
  QCOMPARE(fixture.plot->plot().y.unit, QString("N"));
  QCOMPARE(fixture.plot->plot().series.size(), std::size_t(1));
  choice->setCurrentIndex(1);
  emit choice->activated(1);
  QCOMPARE(fixture.plot->plot().y.unit, QString("mm"));
  fixture.panel.setRecordings({passOf("again", 5.0, 2.0)});
  QCOMPARE(choice->currentText(), QString("Depth of cut"));  // the choice stays
}

void TimeLinePanelTest::twoOverTime() {
  TimeFixture fixture({passOf("Anna", 10.0, 2.0), passOf("Ben", 16.0, 1.25), passOf("third", 1.0, 1.0)});
  QCOMPARE(fixture.plot->plot().series.size(), std::size_t(2));
  QCOMPARE(fixture.plot->plot().series[1].name, QString("Ben"));
  fixture.panel.setTime(4.0);
  QCOMPARE(fixture.panel.timeOf(1), 4.0);
  QCOMPARE(fixture.panel.timeOf(2), 0.0);
  QVERIFY(fixture.part<QLabel>("timeText")->text().startsWith("4.00 of 16.00 s"));
  QTest::keyClick(fixture.track, Qt::Key_End);
  QCOMPARE(fixture.panel.timeOf(0), 10.0);
  QCOMPARE(fixture.panel.timeOf(1), 16.0);
  QVERIFY(fixture.part<QLabel>("timeText")->text().startsWith("16.00 of 16.00 s"));
  fixture.panel.setTime(9.9);
  fixture.panel.setPlaying(true);
  fixture.panel.advance(0.2);
  fixture.panel.advance(0.5);
  QCOMPARE(fixture.panel.timeOf(0), 10.0);
  QVERIFY(fixture.panel.timeOf(1) >= 10.4 && fixture.panel.isPlaying());  // the longer one goes on
}

// Both went 20 mm: after 5 mm one had taken 2.5 s, the other one 4 s.
void TimeLinePanelTest::twoOverDistance() {
  TimeFixture fixture({passOf("Anna", 10.0, 2.0), passOf("Ben", 16.0, 1.25)});
  fixture.panel.setTime(2.5);
  fixture.panel.setAxis(TimeAxis::Kind::Distance);
  QCOMPARE(fixture.panel.time(), 2.5);
  QCOMPARE(fixture.panel.timeOf(1), 4.0);
  QCOMPARE(fixture.plot->plot().x.unit, QString("mm"));
  QCOMPARE(fixture.plot->plot().series[1].points.back().x(), 20.0);
  fixture.panel.advance(0.5);
  QCOMPARE(fixture.panel.time(), 3.0);  // the first sets the pace
  QCOMPARE(fixture.panel.timeOf(1), 4.8);
  QVERIFY(fixture.part<QLabel>("timeText")->text().contains("6.00 mm"));
  QTest::keyClick(fixture.track, Qt::Key_PageDown);
  QTest::keyClick(fixture.track, Qt::Key_PageDown);
  QVERIFY(std::abs(fixture.panel.time() - 8.0) < 1e-9);
  QVERIFY(std::abs(fixture.panel.timeOf(1) - 12.8) < 1e-9);
}

void TimeLinePanelTest::toolTips() {
  TimeFixture fixture({passOf("pass", 10.0, 2.0)});
  const QPoint point = fixture.onTrack(8.0);
  QHelpEvent help(QEvent::ToolTip, point, fixture.track->mapToGlobal(point));
  QApplication::sendEvent(fixture.track, &help);
  QCOMPARE(QToolTip::text(), QString("Collision: tool holder with jaw"));
  QToolTip::hideText();
}

void TimeLinePanelTest::empty() {
  TimeFixture fixture({});
  QVERIFY(!fixture.panel.isEnabled());
  fixture.panel.setPlaying(true);
  QVERIFY(!fixture.panel.isPlaying());
  fixture.panel.advance(1.0);
  fixture.panel.setTime(1.0);
  fixture.panel.setAxis(TimeAxis::Kind::Distance);
  QCOMPARE(fixture.panel.time(), 0.0);
  fixture.panel.grab();
  fixture.panel.setRecordings({passOf("pass", 10.0, 2.0)});
  QVERIFY(fixture.panel.isEnabled());
}

void TimeLinePanelTest::extremes() {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN(),
                   kEndless = std::numeric_limits<double>::infinity();
  for (double duration : {0.0, -1.0, 1e-9, 1e12, kNothing, kEndless}) {
    TimeLineRecording wild;
    wild.duration = duration;
    wild.curves = {{"a", "", {{kNothing, 1}, {0, kEndless}, {1e300, 1e300}}}, {"", "", {}}};
    wild.markers = {{kNothing, "no time"}, {-1.0, "before"}, {1e300, "far"}};
    TimeFixture fixture({wild, wild});
    fixture.panel.setPlaying(true);
    fixture.panel.advance(0.4);
    for (auto key : {Qt::Key_Right, Qt::Key_PageDown, Qt::Key_End, Qt::Key_PageUp}) QTest::keyClick(fixture.track, key);
    fixture.panel.grab();
    QVERIFY(std::isfinite(fixture.panel.time()) && fixture.panel.time() >= 0.0);
  }
}

void TimeLinePanelTest::pictures() {
  TimeFixture one({passOf("Shaft, first pass", 10.0, 2.0)});
  one.panel.setTime(3.0);
  lookAt(one.panel, "time-one");
  TimeFixture two({passOf("Anna", 10.0, 2.0), passOf("Ben", 16.0, 1.25)});
  two.panel.setTime(6.0);
  two.panel.setAxis(TimeAxis::Kind::Distance);
  lookAt(two.panel, "time-two");
  two.panel.resize(420, 280);
  lookAt(two.panel, "time-small");
}

HANDWHEEL_CONTROLS_TEST(TimeLinePanelTest)
#include "TimeLinePanelTest.moc"
