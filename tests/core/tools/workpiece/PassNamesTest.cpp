// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/PassNames.h"

#include "TestClass.h"
#include "machining/lathe/LatheTool.h"

using namespace handwheel;

namespace {

std::shared_ptr<const TurningPass> passOf(std::optional<LatheToolKind> kind, TurningSide side = TurningSide::Outside) {
  TurningPass pass;
  pass.side = side;
  if (kind) {
    LatheTool tool;
    tool.kind = *kind;
    pass.tool = std::make_shared<const LatheTool>(tool);
  }
  return std::make_shared<const TurningPass>(pass);
}

TurnedPart partWithPasses(TurningPasses passes) {
  return TurnedPart::of(TurnedProfile(StockCylinder{20.0, 10.0, 0.0}, 1.0), std::move(passes), 0.1);
}

}  // namespace

// The names of passes in the history.
class PassNamesTest : public QObject {
  Q_OBJECT

 private slots:
  void calledByTheTool() {
    const std::pair<std::optional<LatheToolKind>, const char*> names[] = {
        {std::nullopt, "Turning pass 1"},
        {LatheToolKind::Facing, "Turning pass 1"},
        {LatheToolKind::Drill, "Drilling pass 1"},
        {LatheToolKind::BoringBar, "Boring pass 1"},
        {LatheToolKind::Parting, "Plunging pass 1"},
        {LatheToolKind::Threading, "Threading pass 1"},
        {LatheToolKind::File, "Filing pass 1"},
        {LatheToolKind::GrindingDisk, "Grinding pass 1"}};
    const QString removed = QStringLiteral(": −%1 mm³").arg(QLocale().toString(5.0, 'f', 2));
    for (const auto& [kind, name] : names)
      QCOMPARE(passesText(partWithPasses({passOf(kind)}), 0, 5.0), QString::fromUtf8(name) + removed);
    QVERIFY(passesText(partWithPasses({passOf({}, TurningSide::Bore)}), 0, 5.0).startsWith("Boring pass 1"));
    QCOMPARE(passName(nullptr, TurningSide::Outside, QStringLiteral("7")), QStringLiteral("Turning pass 7"));
  }

  // No number is left out: a step with several passes has all of theirs.
  void severalInOneStep() {
    const TurnedPart part = partWithPasses(
        {passOf({}), passOf(LatheToolKind::Drill), passOf(LatheToolKind::Drill), passOf(LatheToolKind::BoringBar)});
    QCOMPARE(passesText(part, 1, 120.4), QStringLiteral("Pass 2–4: −120 mm³"));
    QCOMPARE(passesText(part, 3, 120.4), QStringLiteral("Boring pass 4: −120 mm³"));
    const TurnedPart drilled = partWithPasses({passOf(LatheToolKind::Drill), passOf(LatheToolKind::Drill)});
    QCOMPARE(passesText(drilled, 0, 12.0), QStringLiteral("Drilling pass 1–2: −12 mm³"));
  }
};

HANDWHEEL_TEST(PassNamesTest)
#include "PassNamesTest.moc"
