// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/PlansText.h"

#include "TestClass.h"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;

// What "inspect" tells of the paths of a cell.
class PlansTextTest : public QObject {
  Q_OBJECT

 private slots:
  // A proof of a former state of the cell is told as one: only where nothing has changed is the path verified.
  void proofs() {
    nlohmann::json path{{"name", "weld"}, {"places", 6}, {"outdated", false}};
    const auto text = [&] { return plansText({{"paths", {path}}, {"may_touch", nlohmann::json::array()}}); };
    QCOMPARE(text(), std::string("path weld, 6 places\n"));
    path["verified"] = {
        {"at", "2026-11-24T10:00:00Z"}, {"certified", true}, {"clearance_mm", 1.5}, {"collisions", 0}, {"too_near", 0},
        {"changed_since", nullptr}};
    QCOMPARE(text(), std::string("path weld, 6 places, verified 2026-11-24T10:00:00Z: free of collisions, clearance "
                                 "1.5 mm\n"));
    for (const char* const changed :
         {"robots", "path", "joints", "bodies", "allowed", "tool", "clearance", "targets", "configurations"}) {
      path["verified"]["changed_since"] = changed;
      QVERIFY2(text().find("places, not verified since ") != std::string::npos, text().c_str());
    }
    path["verified"]["changed_since"] = "bodies";
    QCOMPARE(text(), std::string("path weld, 6 places, not verified since the bodies were changed; before, "
                                 "2026-11-24T10:00:00Z: free of collisions, clearance 1.5 mm\n"));
  }
};

HANDWHEEL_TEST(PlansTextTest)
#include "PlansTextTest.moc"
