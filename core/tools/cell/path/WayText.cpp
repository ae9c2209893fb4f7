// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/WayText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

QString wayWord(const char* text) {
  return QCoreApplication::translate("WayText", text);
}

constexpr const char* kShoulders[] = {
    QT_TRANSLATE_NOOP("WayText", "Shoulder in front"), QT_TRANSLATE_NOOP("WayText", "Shoulder behind"),
    QT_TRANSLATE_NOOP("WayText", "Shoulder left"), QT_TRANSLATE_NOOP("WayText", "Shoulder right")};

}  // namespace

QString stanceText(const ArmStance& stance) {
  const char* const elbow =
      stance.isElbowUp ? QT_TRANSLATE_NOOP("WayText", "elbow up") : QT_TRANSLATE_NOOP("WayText", "elbow down");
  const char* const wrist = stance.isWristFlipped ? QT_TRANSLATE_NOOP("WayText", "wrist flipped")
                                                  : QT_TRANSLATE_NOOP("WayText", "wrist not flipped");
  return wayWord(kShoulders[static_cast<int>(stance.shoulder)]) + QStringLiteral(", ") + wayWord(elbow) +
         QStringLiteral(", ") + wayWord(wrist);
}

QString problemText(const CellScene& scene, const CellWay& way) {
  if (way.arm.beyond) {
    const std::uint32_t dof = scene.dofs[static_cast<std::size_t>(*way.arm.beyond)];
    return wayWord(QT_TRANSLATE_NOOP("WayText", "%1 beyond its limits"))
        .arg(QString::fromStdString(scene.robot->model.jointOfDof(dof).name));
  }
  if (way.isFree()) return {};
  const auto [link, other] = scene.namesOf(way.blocked);
  return wayWord(QT_TRANSLATE_NOOP("WayText", "collides: %1 with %2"))
      .arg(QString::fromStdString(link), QString::fromStdString(other));
}

QString wayText(const CellScene& scene, const CellWay& way, std::size_t number) {
  const QString stance =
      way.arm.stance ? stanceText(*way.arm.stance) : wayWord(QT_TRANSLATE_NOOP("WayText", "Way %1")).arg(number);
  const QString problem = problemText(scene, way);
  return stance + QStringLiteral(": ") + (problem.isEmpty() ? wayWord(QT_TRANSLATE_NOOP("WayText", "free")) : problem);
}

}  // namespace handwheel
