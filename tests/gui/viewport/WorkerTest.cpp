// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "viewport/Worker.h"

#include <QtTest>

using namespace handwheel;

class WorkerTest : public QObject {
  Q_OBJECT

 private slots:
  void results() {
    const auto watcher = runOnWorker<int>([](QPromise<int>& promise) {
      for (int i = 0; i < 3; ++i) promise.addResult(i);
    });
    QTRY_VERIFY(watcher->isFinished());
    QCOMPARE(watcher->future().results(), QList<int>({0, 1, 2}));
  }

  // Earlier results stay, the rest does not come, and the program goes on.
  void outOfMemory() {
    const auto watcher = runOnWorker<int>([](QPromise<int>& promise) {
      promise.addResult(7);
      throw std::bad_alloc();
    });
    QTRY_VERIFY(watcher->isFinished());
    QVERIFY(!watcher->isCanceled());
    QCOMPARE(watcher->future().results(), QList<int>({7}));
  }
};

HANDWHEEL_TEST(WorkerTest)
#include "WorkerTest.moc"
