// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "LargeInputs.h"
#include "fidelity/MeasuredSettings.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

// Helpers that run the cases of the measured settings (MeasuredSettings.h), one group per test. All cases in one test
// would take too long with sanitizers.
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

// A case that takes long. With large inputs (withLargeInputs()) it runs twice, as all other cases always do. Otherwise
// it runs once, or not at all if another case or a smaller shape proves the same.
struct LongCase {
  std::string_view setting;
  int index;
  int runs;  // without large inputs: 1 or 0
};

inline int runsOf(std::string_view setting, int index, std::initializer_list<LongCase> longCases) {
  const auto found = std::find_if(longCases.begin(), longCases.end(),
                                  [&](const LongCase& each) { return each.setting == setting && each.index == index; });
  return withLargeInputs() || found == longCases.end() ? 2 : found->runs;
}

inline void addCases(CaseGroup group, std::initializer_list<LongCase> longCases) {
  for (const LongCase& each : longCases) {
    const FidelityRegistry::Entry* entry = measured().find(each.setting);
    if (!entry || groupOf(each.setting) != group || each.index >= int(entry->cases.size())) qFatal("no such long case");
  }
  QTest::addColumn<QString>("id");
  QTest::addColumn<int>("index");
  QTest::addColumn<int>("runs");
  for (const auto& entry : measured().entries()) {
    if (groupOf(entry.setting.id) != group) continue;
    for (int i = 0; i < int(entry.cases.size()); ++i) {
      const int runs = runsOf(entry.setting.id, i, longCases);
      if (runs == 0) continue;
      QTest::addRow("%s, %s", entry.setting.id.c_str(), entry.cases[i].name.c_str())
          << QString::fromStdString(entry.setting.id) << i << runs;
    }
  }
}

// Checks a case at the default of its setting. It must state its reference, and have a finite error and a cost. If the
// case runs twice, the errors for the same seed must be equal.
inline void runCase() {
  QFETCH(QString, id);
  QFETCH(int, index);
  QFETCH(int, runs);
  const FidelityRegistry::Entry& entry = *measured().find(id.toStdString());
  const FidelityCase& c = entry.cases[index];
  QVERIFY(!c.truth.empty());
  const FidelitySample first = c.run(entry.setting.standard, 1, {});
  QVERIFY(std::isfinite(first.error) && first.error >= 0.0);
  QVERIFY(first.cost > 0.0);
  if (runs == 2) QCOMPARE(errorAt(c, entry.setting.standard), first.error);
}

}  // namespace handwheel::test
