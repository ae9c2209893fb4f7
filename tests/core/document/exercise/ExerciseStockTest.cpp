// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/ExerciseStock.h"

#include "TestClass.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

// The deviation of work on an exercise from its target.
class ExerciseStockTest : public QObject {
  Q_OBJECT

 private slots:
  // A cylinder of 70 mm at the free end of a bar of 100 mm, of which the chuck holds 20 mm: the 10 mm between them are
  // no part of it.
  void theBarBehindTheTargetDoesNotCount() {
    const auto target = TargetProfile::make({{{18, 30}, {18, 100}, 0.0}});
    QVERIFY(bool(target));
    auto task = std::make_shared<TurningTask>();
    task->stock = {40.0, 100.0, 0.0};
    task->lathe.chuckHeight = 20.0;
    task->target = *target;
    for (const double off : {0.0, 0.5, -0.5}) {
      TurnedProfile part(task->stock, 0.1);
      for (std::size_t i = 0; i < part.size(); ++i)
        if (part.z(i) > 30.0) part.limitOuter(i, 18.0 + off);
      QVERIFY(std::abs(targetError({{}, task}, part) - std::abs(off)) < 1e-9);
    }
  }
};

HANDWHEEL_TEST(ExerciseStockTest)
#include "ExerciseStockTest.moc"
