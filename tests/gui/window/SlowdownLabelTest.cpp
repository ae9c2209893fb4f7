// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindowTestMain.h"
#include "window/SlowdownLabel.h"

using namespace handwheel;
using namespace handwheel::test;

// The label appears while a service loses time against the clock, and goes with that.
class SlowdownLabelTest : public QObject {
  Q_OBJECT

 private slots:
  void showsWhatIsLost() {
    Service service("simulation");
    ServiceRegistry registry;
    registry.add(service);
    SlowdownLabel label(service);
    // Half a second of every second, in one piece for each look of the label.
    service.countLost(500'000'000);
    QTest::qWait(1200);
    QVERIFY(label.isHidden());  // nobody needs it
    const ServiceHandle need = registry.need("simulation");
    service.countLost(500'000'000);
    QTRY_VERIFY_WITH_TIMEOUT(!label.isHidden(), 3000);
    // The second may be a little shorter, or longer on a busy machine.
    const int percent = label.text().remove(QRegularExpression("[^0-9]")).toInt();
    QVERIFY2(percent >= 40 && percent <= 95, qPrintable(label.text()));
    QTRY_VERIFY_WITH_TIMEOUT(label.isHidden(), 5000);
    service.countLost(10'000'000);  // the usual loss by a scheduler
    QTest::qWait(1200);
    QVERIFY(label.isHidden());
  }
};

HANDWHEEL_WINDOW_TEST(SlowdownLabelTest)
#include "SlowdownLabelTest.moc"
