// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/IkSolutionText.h"

#include "base/Units.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

QString solutionWord(const char* text) {
  return QCoreApplication::translate("IkSolutionText", text);
}

constexpr const char* kShoulders[] = {
    QT_TRANSLATE_NOOP("IkSolutionText", "Shoulder in front"), QT_TRANSLATE_NOOP("IkSolutionText", "Shoulder behind"),
    QT_TRANSLATE_NOOP("IkSolutionText", "Shoulder left"), QT_TRANSLATE_NOOP("IkSolutionText", "Shoulder right")};

}  // namespace

QString configurationText(const ArmConfiguration& configuration) {
  const char* const elbow = configuration.isElbowUp ? QT_TRANSLATE_NOOP("IkSolutionText", "elbow up")
                                                    : QT_TRANSLATE_NOOP("IkSolutionText", "elbow down");
  const char* const wrist = configuration.isWristFlipped ? QT_TRANSLATE_NOOP("IkSolutionText", "wrist flipped")
                                                         : QT_TRANSLATE_NOOP("IkSolutionText", "wrist not flipped");
  return solutionWord(kShoulders[static_cast<int>(configuration.shoulder)]) + QStringLiteral(", ") +
         solutionWord(elbow) + QStringLiteral(", ") + solutionWord(wrist);
}

QString problemText(const CellScene& scene, const CellIkSolution& solution) {
  if (solution.arm.beyond) {
    const std::uint32_t dof = scene.dofs[static_cast<std::size_t>(*solution.arm.beyond)];
    return solutionWord(QT_TRANSLATE_NOOP("IkSolutionText", "%1 beyond its limits"))
        .arg(QString::fromStdString(scene.robot->model.jointOfDof(dof).name));
  }
  if (solution.isFree()) return {};
  const auto [link, other] = scene.namesOf(solution.blocked);
  return solutionWord(QT_TRANSLATE_NOOP("IkSolutionText", "collides: %1 with %2"))
      .arg(QString::fromStdString(link), QString::fromStdString(other));
}

QString turnedOffText(const CellIkSolution& solution) {
  const double degrees = solution.arm.turnedOff / kRadiansPerDegree;
  if (degrees < 0.05) return {};
  return solutionWord(QT_TRANSLATE_NOOP("IkSolutionText", "turned off by %1°")).arg(degrees, 0, 'f', 1);
}

QString ikSolutionText(const CellScene& scene, const CellIkSolution& solution, std::size_t number) {
  const QString configuration = solution.arm.configuration
                                    ? configurationText(*solution.arm.configuration)
                                    : solutionWord(QT_TRANSLATE_NOOP("IkSolutionText", "Way %1")).arg(number);
  const QString problem = problemText(scene, solution), turned = turnedOffText(solution);
  return configuration + QStringLiteral(": ") +
         (problem.isEmpty() ? solutionWord(QT_TRANSLATE_NOOP("IkSolutionText", "free")) : problem) +
         (turned.isEmpty() ? QString() : QStringLiteral(", ") + turned);
}

}  // namespace handwheel
