// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "haptics/servo/RealTimeThread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <QtTest>
#include <thread>

using namespace handwheel;

class RealTimeThreadTest : public QObject {
  Q_OBJECT

 private slots:
  // The reported state is that of the kernel; and the slack is 1 ns in any case, but not that of other threads.
  void saysWhatItIs() {
    RealTimeState state = RealTimeState::NotRunning;
    int policy = -1, slack = -1;
    sched_param parameters{};
    std::thread([&] {
      state = makeThreadRealTime(80);
      pthread_getschedparam(pthread_self(), &policy, &parameters);
      slack = prctl(PR_GET_TIMERSLACK);
    }).join();
    QVERIFY(state == RealTimeState::RealTime || state == RealTimeState::NotPermitted);
    QCOMPARE(policy == SCHED_FIFO, state == RealTimeState::RealTime);
    if (state == RealTimeState::RealTime) QVERIFY(parameters.sched_priority >= 1 && parameters.sched_priority <= 80);
    if (state == RealTimeState::NotPermitted) QCOMPARE(slack, 1);  // a real-time thread has none, whatever it asks for
    pthread_getschedparam(pthread_self(), &policy, &parameters);
    QVERIFY(policy != SCHED_FIFO);
  }
};

HANDWHEEL_TEST(RealTimeThreadTest)
#include "RealTimeThreadTest.moc"
