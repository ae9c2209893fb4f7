// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/ToolKey.h"

#include "TestClass.h"
#include "tools/MeasureTool.h"
#include "tools/cell/JointDragTool.h"
#include "tools/mesh/DecimateTool.h"
#include "tools/mesh/FillHoleTool.h"
#include "tools/mesh/MakeFaceTool.h"
#include "tools/mesh/SelectTool.h"
#include "tools/mesh/SubdivideTool.h"
#include "tools/mesh/TransformTool.h"
#include "tools/mesh/boundary/BoundaryTool.h"
#include "tools/mesh/sculpt/SculptTool.h"
#include "tools/mesh/voxels/VolumeRepairTool.h"

#include <QKeySequence>
#include <QTest>
#include <set>

using namespace handwheel;

class ToolKeyTest : public QObject {
  Q_OBJECT

 private slots:
  void anActionIsOfItsKey();
  void theKeysOfATool_data();
  void theKeysOfATool();
};

void ToolKeyTest::anActionIsOfItsKey() {
  constexpr ToolKey kKeys[] = {{"smaller", "[", "smaller brush"}, {"next", "N", "next hole", "nextHole"}};
  const ToolAction usual = actionOf(kKeys, "next");
  QVERIFY(usual.id == "next" && usual.input == "N" && usual.effect == "next hole" && usual.command == "nextHole");
  QVERIFY(usual.enabled);
  const ToolAction now = actionOf(kKeys, "smaller", false, "shrink");
  QVERIFY(now.id == "smaller" && now.input == "[" && now.effect == "shrink" && now.command.empty());
  QVERIFY(!now.enabled);
}

void ToolKeyTest::theKeysOfATool_data() {
  QTest::addColumn<const ToolKey*>("first");
  QTest::addColumn<int>("count");
  const auto add = [](const char* name, std::span<const ToolKey> keys) {
    QTest::newRow(name) << keys.data() << static_cast<int>(keys.size());
  };
  add("measure", MeasureTool::keys());
  add("joints", JointDragTool::keys());
  add("boundary", BoundaryTool::keys());
  add("decimate", DecimateTool::keys());
  add("fill", FillHoleTool::keys());
  add("face", MakeFaceTool::keys());
  add("sculpt", SculptTool::keys());
  add("select", SelectTool::keys());
  add("subdivide", SubdivideTool::keys());
  add("transform", TransformTool::keys());
  add("volume-repair", VolumeRepairTool::keys());
}

// Return finishes every tool, Esc cancels; all others are keys of one press, and no two are equal.
void ToolKeyTest::theKeysOfATool() {
  QFETCH(const ToolKey*, first);
  QFETCH(int, count);
  std::set<std::string> actions;
  std::set<QString> inputs;
  for (const ToolKey& key : std::span(first, static_cast<std::size_t>(count))) {
    const std::string action = key.action;
    QVERIFY2(actions.insert(action).second, key.action);
    QVERIFY2(*key.effect, key.action);
    QCOMPARE(action == "commit", std::string(key.input) == "Return");
    QCOMPARE(action == "revert", std::string(key.input) == "Esc");
    if (!*key.input) continue;
    const QKeySequence keys(QString::fromLatin1(key.input), QKeySequence::PortableText);
    QVERIFY2(keys.count() == 1 && keys[0].key() != Qt::Key_unknown, key.action);
    QVERIFY2(inputs.insert(keys.toString()).second, key.action);
  }
  QVERIFY(actions.count("commit") == 1 && actions.count("revert") == 1);
}

HANDWHEEL_TEST(ToolKeyTest)
#include "ToolKeyTest.moc"
