// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "StlFiles.h"
#include "WindowDriver.h"
#include "WindowTestMain.h"
#include "tools/ToolRunner.h"
#include "window/tools/ToolHost.h"

#include <QComboBox>
#include <QThread>
#include <cmath>

#include <X11/Xlib.h>  // last: it defines words such as None

using namespace handwheel;
using namespace handwheel::test;

// The mouse goes on while the window is busy with a frame: no position is lost.
class FastMouseTest : public QObject {
  Q_OBJECT

 private:
  // Events of another client, which come through the server as those of the mouse do.
  class Mouse {
   public:
    explicit Mouse(QWidget& view) : m_view(view), m_display(XOpenDisplay(nullptr)) {
      if (!m_display) qFatal("no X server");
      m_window = m_view.window()->winId();
    }
    ~Mouse() { XCloseDisplay(m_display); }

    void send(int type, const QPoint& at, unsigned int held) {
      const QPoint inWindow = m_view.mapTo(m_view.window(), at), onScreen = m_view.mapToGlobal(at);
      XEvent event{};
      event.xbutton.type = type;
      event.xbutton.display = m_display;
      event.xbutton.window = m_window;
      event.xbutton.root = DefaultRootWindow(m_display);
      event.xbutton.time = m_time += 5;
      event.xbutton.x = inWindow.x();
      event.xbutton.y = inWindow.y();
      event.xbutton.x_root = onScreen.x();
      event.xbutton.y_root = onScreen.y();
      event.xbutton.state = held;
      event.xbutton.same_screen = True;
      if (type == MotionNotify) {
        event.xmotion.is_hint = NotifyNormal;
      } else {
        event.xbutton.button = Button1;
      }
      XSendEvent(m_display, m_window, False, NoEventMask, &event);
      XSync(m_display, False);
    }

   private:
    QWidget& m_view;
    Display* m_display;
    ::Window m_window = 0;
    Time m_time = 1000;
  };

 private slots:
  void aLassoKeepsAllItsPlaces() {
    constexpr int kPositions = 60;
    QTemporaryDir folder;
    WindowDriver driver;
    writeStl(folder.filePath("part.stl"), quadTorus(48, 24, {}));
    QVERIFY(driver.open(folder.filePath("part.stl")));
    driver.find<QAction>("selectTool")->trigger();
    auto* mode = driver.find<QWidget>("toolDock")->findChild<QWidget*>("property/mode")->findChild<QComboBox*>();
    mode->setCurrentIndex(mode->findText(QStringLiteral("Lasso"), Qt::MatchFixedString));
    emit mode->activated(mode->currentIndex());
    QVERIFY(driver.settle());
    auto* view = driver.find<Viewport>("viewport");
    QTRY_VERIFY(view->isPickingReady());

    const auto* host = driver.window().findChild<ToolHost*>();
    QVERIFY(host);
    std::size_t drawn = 0;
    const auto position = [view](int i) {
      const double turn = 2.0 * M_PI * i / kPositions;
      return view->rect().center() +
             QPoint(static_cast<int>(150 * std::cos(turn)), static_cast<int>(150 * std::sin(turn)));
    };
    {
      Mouse mouse(*view);
      mouse.send(MotionNotify, position(0), 0);
      mouse.send(ButtonPress, position(0), 0);
      for (int i = 1; i < kPositions; ++i) mouse.send(MotionNotify, position(i), Button1Mask);
      QThread::msleep(100);  // they have all arrived before the window looks at the first
      connect(host, &ToolHost::updated, this, [&] {
        const Tool* tool = const_cast<ToolHost*>(host)->runner().tool();
        for (const auto& line : tool ? tool->preview().lines : std::vector<std::vector<Vec3>>())
          drawn = std::max(drawn, line.size());
      });
      if (!QTest::qWaitFor([&] { return drawn >= kPositions; }))
        QFAIL(qPrintable(QStringLiteral("%1 of %2 places").arg(drawn).arg(kPositions)));
      mouse.send(ButtonRelease, position(kPositions - 1), Button1Mask);
    }
    QTRY_VERIFY(driver.find<QAbstractButton>("toolAction/delete")->isEnabled());
    QVERIFY(driver.settle());
  }
};

// XInput 2 has no events that one client can send to another.
HANDWHEEL_TEST_RUN(FastMouseTest, [](int argc, char** argv) {
  qputenv("QT_XCB_NO_XI2", "1");
  return runWindowTest<FastMouseTest>(argc, argv);
})
#include "FastMouseTest.moc"
