// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/ProgramRemarks.h"

#include "base/NumberText.h"
#include "base/Units.h"
#include "scene/RigidPose.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

QString programRemark(const char* text) {
  return QCoreApplication::translate("ProgramRemarks", text);
}

QString listed(const std::vector<std::size_t>& lines) {
  constexpr std::size_t kMostListed = 5;
  QStringList some;
  for (std::size_t i = 0; i < std::min(lines.size(), kMostListed); ++i) some += QString::number(lines[i]);
  if (lines.size() > kMostListed) some += QStringLiteral("…");
  return some.join(QStringLiteral(", "));
}

QString openConfigurationsRemark(const std::vector<std::size_t>& lines) {
  return programRemark(QT_TRANSLATE_NOOP(
                           "ProgramRemarks",
                           "These lines do not say in which way the arm comes to their poses: %1. The path has the "
                           "nearest way, and a controller may take another one; give joint values or a configuration."))
      .arg(listed(lines));
}

// "0, 0, 120 mm, turned by 0, 0, 90°": roll, pitch and yaw.
QString toolPointText(const Pose& tool) {
  const auto list = [](const Vec3& numbers) {
    QStringList texts;
    for (const double number : numbers) texts += QString::fromStdString(roundedText(std::round(1e3 * number) / 1e3, 9));
    return texts.join(QStringLiteral(", "));
  };
  const QString at = list(tool.translation()) + QStringLiteral(" mm");
  constexpr double kStraight = 1e-9;
  if (tool.linear().isIdentity(kStraight)) return at;
  return programRemark(QT_TRANSLATE_NOOP("ProgramRemarks", "%1, turned by %2°"))
      .arg(at, list(rollPitchYaw(tool) / kRadiansPerDegree));
}

}  // namespace

QStringList programRemarks(const ProgramPath& read, const Pose& tool) {
  QStringList remarks;
  if (!read.openConfigurations.empty()) remarks += openConfigurationsRemark(read.openConfigurations);
  if (!read.leftOut.empty()) {
    remarks += programRemark(QT_TRANSLATE_NOOP(
                                 "ProgramRemarks",
                                 "The path does not have all that these lines say: %1 (handlers of errors and "
                                 "interrupts, functions, options of motions such as ACC and PTH, speeds that are no "
                                 "numbers). A program that is "
                                 "written from it does not have this either."))
                   .arg(listed(read.leftOut));
  }
  const auto axes = std::ranges::find(read.path.head, ProgramLine::Kind::Axes, &ProgramLine::kind);
  if (axes != read.path.head.end()) {
    remarks += programRemark(QT_TRANSLATE_NOOP(
                                 "ProgramRemarks",
                                 "External axes stand at “%1” in the whole program. The cell does not move them: robot "
                                 "and parts must stand there as they do then. Programs in the same language are "
                                 "written with these axes."))
                   .arg(QString::fromStdString(axes->text));
  }
  if (read.otherTool) {
    remarks += programRemark(QT_TRANSLATE_NOOP(
                                 "ProgramRemarks",
                                 "The tool centre point of the program is at %1, that of the cell at %2. The arm comes "
                                 "to the same places, but lines and blends are those of the cell's tool: set the tool "
                                 "centre point of the cell to that of the program, and open it again."))
                   .arg(toolPointText(*read.otherTool), toolPointText(tool));
  }
  return remarks;
}

}  // namespace handwheel
