// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/PlansText.h"

#include "TestClass.h"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;

// Output of "inspect" about the paths of a cell.
class PlansTextTest : public QObject {
  Q_OBJECT

 private slots:
  // A proof of a former state of the cell is reported as one: only where nothing has changed is the path verified.
  void proofs() {
    nlohmann::json path{{"name", "weld"}, {"places", 6}, {"outdated", false}};
    const auto text = [&] { return plansText({{"paths", {path}}, {"may_touch", nlohmann::json::array()}}); };
    QCOMPARE(text(), std::string("path weld, 6 places\n"));
    path["verified"] = {
        {"at", "2026-11-24T10:00:00Z"}, {"certified", true}, {"clearance_mm", 1.5}, {"collisions", 0}, {"too_near", 0},
        {"changed_since", nullptr}};
    QCOMPARE(text(), std::string("path weld, 6 places, verified 2026-11-24T10:00:00Z: free of collisions, clearance "
                                 "1.5 mm\n"));
    const auto pair = [](int i) { return nlohmann::json::array({"tool", "part " + std::to_string(i)}); };
    path["verified"]["not_checked"] = nlohmann::json::array({pair(1), pair(2)});
    QVERIFY2(text().ends_with("1.5 mm, not checked: tool with part 1, not checked: tool with part 2\n"),
             text().c_str());
    for (int i = 3; i < 9; ++i) path["verified"]["not_checked"].push_back(pair(i));
    QVERIFY2(text().ends_with(", not checked: tool with part 5 and 3 more pairs\n"), text().c_str());
    path["verified"].erase("not_checked");
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
