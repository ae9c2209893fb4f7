// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workpiece/PassNames.h"

#include "machining/lathe/LatheTool.h"

#include <QCoreApplication>
#include <QLocale>
#include <string_view>

namespace handwheel {

namespace {

const char* patternFor(const LatheTool* tool, TurningSide side) {
  if (!tool) return side == TurningSide::Bore ? "Boring pass %1" : QT_TRANSLATE_NOOP("Tool", "Turning pass %1");
  switch (tool->kind) {
    case LatheToolKind::Parting:
    case LatheToolKind::Grooving:
      return QT_TRANSLATE_NOOP("Tool", "Plunging pass %1");
    case LatheToolKind::Threading:
      return QT_TRANSLATE_NOOP("Tool", "Threading pass %1");
    case LatheToolKind::BoringBar:
      return QT_TRANSLATE_NOOP("Tool", "Boring pass %1");
    case LatheToolKind::Drill:
      return QT_TRANSLATE_NOOP("Tool", "Drilling pass %1");
    case LatheToolKind::File:
      return QT_TRANSLATE_NOOP("Tool", "Filing pass %1");
    case LatheToolKind::AbrasivePaper:
    case LatheToolKind::GrindingDisk:
      return QT_TRANSLATE_NOOP("Tool", "Grinding pass %1");
    case LatheToolKind::RightTurning:
    case LatheToolKind::LeftTurning:
    case LatheToolKind::Facing:
    case LatheToolKind::Form:
      break;
  }
  return "Turning pass %1";
}

QString named(const char* pattern, const QString& number) {
  return QCoreApplication::translate("Tool", pattern).arg(number);
}

}  // namespace

QString passName(const LatheTool* tool, TurningSide side, const QString& number) {
  return named(patternFor(tool, side), number);
}

QString passesText(const TurnedPart& part, std::size_t before, double removed) {
  const QLocale locale;
  const std::size_t count = part.passes.size();
  const char* pattern = nullptr;
  for (std::size_t i = before; i < count; ++i) {
    const char* const its = patternFor(part.passes[i]->tool.get(), part.passes[i]->side);
    const bool isOther = pattern && std::string_view(pattern) != its;
    pattern = isOther ? QT_TRANSLATE_NOOP("Tool", "Pass %1") : its;
    if (isOther) break;
  }
  QString number = locale.toString(before + 1);
  if (count > before + 1) number += QStringLiteral("–") + locale.toString(count);
  return QCoreApplication::translate("Tool", "%1: −%2 mm³")
      .arg(named(pattern ? pattern : "Pass %1", number), locale.toString(removed, 'f', removed < 10.0 ? 2 : 0));
}

}  // namespace handwheel
