// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/MeasuredSettings.h"

#include <QTest>
#include <cmath>
#include <string_view>

// Runs the cases of the measured settings, a group of subjects at a time. All of them together take too long for one
// test with sanitizers.
namespace handwheel::test {

enum class CaseGroup { Mesh, VolumeReduction, Volume, Other };

inline const FidelityRegistry& measured() {
  static const FidelityRegistry all = measuredSettings();
  return all;
}

inline double errorAt(const FidelityCase& c, double value) {
  return c.run(value, 1, {}).error;
}

inline CaseGroup groupOf(std::string_view setting) {
  if (setting.starts_with("mesh.")) return CaseGroup::Mesh;
  if (setting == "volume.reduction") return CaseGroup::VolumeReduction;
  return setting.starts_with("volume.") || setting.starts_with("drill.") ? CaseGroup::Volume : CaseGroup::Other;
}

inline void addCases(CaseGroup group) {
  QTest::addColumn<QString>("id");
  QTest::addColumn<int>("index");
  for (const auto& entry : measured().entries()) {
    if (groupOf(entry.setting.id) != group) continue;
    for (int i = 0; i < int(entry.cases.size()); ++i) {
      QTest::addRow("%s, %s", entry.setting.id.c_str(), entry.cases[i].name.c_str())
          << QString::fromStdString(entry.setting.id) << i;
    }
  }
}

// Checks that at the default there is a result with an error and a cost, and that the seed alone decides on the error.
inline void runCase() {
  QFETCH(QString, id);
  QFETCH(int, index);
  const FidelityRegistry::Entry& entry = *measured().find(id.toStdString());
  const FidelityCase& c = entry.cases[index];
  QVERIFY(!c.truth.empty());
  const FidelitySample first = c.run(entry.setting.standard, 1, {});
  QVERIFY(std::isfinite(first.error) && first.error >= 0.0);
  QVERIFY(first.cost > 0.0);
  QCOMPARE(errorAt(c, entry.setting.standard), first.error);
}

}  // namespace handwheel::test
