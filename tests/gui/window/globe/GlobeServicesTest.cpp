// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeWindow.h"

#include "controls/ServiceModel.h"
#include "window/WindowServices.h"

#include <QDir>
#include <QDockWidget>

using namespace handwheel;
using namespace handwheel::test;

// A background service of a kind is in the list of services, and costs nothing while nobody needs it.
class GlobeServicesTest : public QObject {
  Q_OBJECT

  // The row of the service in the Status panel.
  struct Row {
    QString state;
    double ticks = 0.0, cost = 0.0;
  };
  static std::optional<Row> rowOf(GlobeWindow& globe) {
    const QAbstractItemModel& model = *globe.driver.find<QTreeView>("serviceList")->model();
    const auto number = [&](int row, int column) {
      return QLocale().toDouble(model.index(row, column).data().toString());
    };
    for (int row = 0; row < model.rowCount(); ++row) {
      if (model.index(row, ServiceModel::Name).data().toString() != QStringLiteral("Dents of globes")) continue;
      return Row{model.index(row, ServiceModel::State).data().toString(), number(row, ServiceModel::Ticks),
                 number(row, ServiceModel::Cost)};
    }
    return std::nullopt;
  }
  static qsizetype threads() {
    return QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size();
  }

 private slots:
  void runsWhileItIsNeeded() {
    GlobeWindow globe;
    QVERIFY(globe.begin());
    globe.driver.find<QDockWidget>("statusDock")->show();
    QTRY_VERIFY(rowOf(globe) && rowOf(globe)->state == QStringLiteral("idle"));
    QTest::qWait(500);  // workers that began with the window
    const qsizetype before = threads();
    globe.driver.find<QAction>("dentTool")->trigger();
    QTRY_VERIFY(rowOf(globe)->state == QStringLiteral("running") && rowOf(globe)->ticks > 20.0);
    QVERIFY(rowOf(globe)->cost > 0.0);
    QCOMPARE(threads(), before + 1);
    globe.driver.find<QAction>("growTool")->trigger();
    QTRY_VERIFY(rowOf(globe)->state == QStringLiteral("idle"));
    QTRY_COMPARE(threads(), before);
  }

  // Nobody needs it with another document in front, or with none.
  void isNotNeededByAnotherDocument() {
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Front));
    globe.driver.find<QDockWidget>("statusDock")->show();
    QTRY_VERIFY(rowOf(globe)->state == QStringLiteral("running"));
    globe.driver.choose("newWorkpiece");
    QVERIFY(globe.driver.settle());
    QTRY_VERIFY(rowOf(globe)->state == QStringLiteral("idle"));
    globe.driver.find<QTabBar>("documentTabBar")->setCurrentIndex(0);  // with its tool
    QTRY_VERIFY(rowOf(globe)->state == QStringLiteral("running"));
    globe.driver.choose("closeDocument");
    QTRY_VERIFY(rowOf(globe)->state == QStringLiteral("idle"));
  }

  // Work that a service did not do in time is reported once, as a share of the time since the last query.
  void troublesAreReported() {
    WindowServices services;
    Service dents("slow dents");
    services.add(dents, "Slow dents");
    {
      const ServiceHandle need = services.needs().need("slow dents");
      const auto status = [&services] {
        for (const ServiceStatus& each : services.status())
          if (each.id == QStringLiteral("slow dents")) return each;
        return ServiceStatus();
      };
      QCOMPARE(status().dropped, 0);
      dents.countLost(3'600'000'000'000);  // an hour: this test is quicker
      dents.countDropped(5);
      const ServiceStatus slow = status();
      QVERIFY(slow.running && slow.behind > 1.0);
      QCOMPARE(slow.dropped, 5);
      const ServiceStatus again = status();
      QVERIFY(again.behind == 0.0 && again.dropped == 0);
    }
    services.remove(dents);
  }
};

HANDWHEEL_WINDOW_TEST(GlobeServicesTest)
#include "GlobeServicesTest.moc"
