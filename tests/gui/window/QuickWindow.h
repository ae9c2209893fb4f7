// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindowDriver.h"
#include "window/documents/DocumentTabs.h"

#include <QTimer>
#include <memory>

// Windows for tests that do not look at the model.
namespace handwheel::test {

// Shortens the pause of the user after which a mesh is searched for self-intersections. The timer of a window is
// shortened when it first expires.
class ShortRests : public QObject {
 public:
  ShortRests() { QCoreApplication::instance()->installEventFilter(this); }

  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Timer) {
      auto* timer = qobject_cast<QTimer*>(watched);
      if (timer && timer->isSingleShot() && timer->interval() == kRestMs) timer->setInterval(1);
    }
    return false;
  }

 private:
  static constexpr int kRestMs = 500;
};

// A small window with a small view. Both are drawn by software, which takes less time for fewer pixels.
class QuickWindow : public WindowDriver {
 public:
  QuickWindow() {
    window().resize(960, 600);
    find<Viewport>("viewport")->setMaximumSize(320, 240);
  }

  // Closes all documents without asking, and all messages.
  void clear() {
    auto* open = window().findChild<DocumentTabs*>();
    while (!open->all().empty()) open->close(open->all().back().get());
    auto* bar = find<QWidget>("messageBar");
    while (!bar->isHidden()) find<QAbstractButton>("messageClose")->click();
    find<QLabel>("messageText")->clear();
    QTest::qWait(0);  // rows of closed documents are deleted by the next turn of the event loop
    if (!settle()) qFatal("the window does not come to rest");
  }

 private:
  ShortRests m_rests;
};

// One window for all test functions of a class.
class ClassWindow {
 public:
  // Returns the window without the documents of the function before.
  QuickWindow& cleared() {
    if (!m_window) m_window = std::make_unique<QuickWindow>();
    m_window->clear();
    return *m_window;
  }

 private:
  std::unique_ptr<QuickWindow> m_window;
};

}  // namespace handwheel::test
