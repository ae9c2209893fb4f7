// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"

#include <QLabel>

using namespace handwheel;
using namespace handwheel::test;

// The texts of an exercise that a student reads in the window.
class LessonWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // The sizes of a drawing stand where the read-out and programs have them: from its finished face at Z 80.
  void sizesCountFromTheDrawing() {
    WindowDriver driver;
    driver.choose("openFirstLesson");
    QVERIFY(driver.settle());
    QString sizes;  // sizes on the page of a student's file, and in the panel beside the work
    for (const QLabel* const each : driver.window().findChildren<QLabel*>("lesson/sizes")) sizes += each->text();
    QVERIFY2(sizes.contains(QStringLiteral("From Z -27 mm, To Z -1 mm")), qPrintable(sizes));
    QVERIFY2(sizes.contains(QStringLiteral("between the faces at Z -30 mm and Z 0 mm")), qPrintable(sizes));
  }
};

HANDWHEEL_WINDOW_TEST(LessonWindowTest)
#include "LessonWindowTest.moc"
