// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PathRemark.h"

#include "controls/QuantityText.h"

#include <QCoreApplication>
#include <cmath>

namespace handwheel {

namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(PathRemark)

 public:
  Words(LengthUnit unit, const QLocale& locale) : m_unit(unit), m_locale(locale) {}

  static QString notSince(BasisChange change) {
    switch (change) {
      case BasisChange::Robots:
        return tr("not verified since a robot was moved, added or removed");
      case BasisChange::Path:
        return tr("not verified since the path was changed");
      case BasisChange::Joints:
        return tr("not verified since other joints were moved");
      case BasisChange::Bodies:
        return tr("not verified since the bodies were changed");
      case BasisChange::Pairs:
        return tr("not verified since the allowed pairs were changed");
      case BasisChange::Tool:
        return tr("not verified since the tool centre point was changed");
      case BasisChange::Clearance:
        return tr("not verified since the clearance was changed");
      case BasisChange::Nothing:
        break;
    }
    return tr("not verified yet");
  }

  QString shortly(const PathResult& result) const {
    if (!result.checked) return tr("cannot be verified");
    const CheckedPath& checked = *result.checked;
    if (checked.way.stopsAt) return tr("line cannot be followed, %1").arg(time(result));
    if (!checked.isCertified()) return tr("%1, %2").arg(collisions(checked), time(result));
    if (!checked.partMoved.empty())
      return tr("plan again: %1 has moved").arg(QString::fromStdString(checked.partMoved));
    const QString known = tr("%1, %2").arg(clearanceText(checked, m_unit, m_locale), time(result));
    return moved(checked, result.hasShapeless ? tr("free but for links without meshes, %1").arg(known)
                                              : tr("free, %1").arg(known));
  }

  QString found(const PathResult& result) const {
    if (!result.checked) return tr("cannot be verified");
    const CheckedPath& checked = *result.checked;
    if (checked.way.stopsAt) return tr("line cannot be followed (%1)").arg(time(result));
    if (!checked.isCertified()) return tr("%1 (%2)").arg(collisions(checked), time(result));
    const QString known = tr("%1, clearance %2").arg(time(result), clearanceText(checked, m_unit, m_locale));
    return moved(checked, result.hasShapeless ? tr("free of collisions but for links without meshes (%1)").arg(known)
                                              : tr("free of collisions (%1)").arg(known));
  }

  QStringList details(const PathResult& result) const {
    QStringList lines{tr("Verified at %1.").arg(m_locale.toString(result.at, QLocale::ShortFormat))};
    if (!result.checked) return lines + QStringList{result.problem};
    const CheckedPath& checked = *result.checked;
    if (checked.way.stopsAt)
      return lines + QStringList{tr("The straight line to place %1 leaves the reach of the arm or the limits of its "
                                    "joints.")
                                     .arg(*checked.way.stopsAt + 1)};
    if (!checked.isCertified()) return lines + result.collisions;
    if (!checked.partMoved.empty()) {
      lines += tr("It leads along the curve where %1 was when it was planned. Plan it again, and it follows the part.")
                   .arg(QString::fromStdString(checked.partMoved));
    }
    const double kept = result.basis.clearance;
    lines += kept > 0.0 ? tr("Every motion is proven to keep %1 from everything.")
                              .arg(quantityText(kept, Quantity::Length, m_unit, m_locale))
                        : tr("Every motion is proven free of collisions.");
    lines += tr("Least clearance: %1.").arg(clearanceText(checked, m_unit, m_locale));
    lines += tr("Cycle time: %1 s.").arg(m_locale.toString(checked.seconds, 'f', 1));
    return lines;
  }

 private:
  // Of the day, as of this session.
  QString time(const PathResult& result) const { return m_locale.toString(result.at.time(), QLocale::ShortFormat); }
  static QString collisions(const CheckedPath& checked) {
    return tr("%Ln collision(s)", nullptr, static_cast<int>(checked.verification.collisions.size()));
  }
  static QString moved(const CheckedPath& checked, const QString& text) {
    if (checked.robotsMoved.empty()) return text;
    return tr("%1; %2 has moved since").arg(text, QString::fromStdString(*checked.robotsMoved.begin()));
  }

  LengthUnit m_unit;
  QLocale m_locale;
};

}  // namespace

QString clearanceText(const CheckedPath& checked, LengthUnit unit, const QLocale& locale) {
  const double least = checked.metrics.leastClearance;
  constexpr double kFarthest = PathMetricsSettings().farthest;
  if (!(least < kFarthest)) return QStringLiteral("> ") + quantityText(kFarthest, Quantity::Length, unit, locale);
  const int digits = unit == LengthUnit::Millimetre ? 1 : 3;
  const double step = std::pow(10.0, -digits);  // rounded down: it is never said to be more
  const double shown = std::floor(least / perShownUnit(Quantity::Length, unit) / step) * step;
  return locale.toString(shown, 'f', digits) + QLatin1Char(' ') + unitSymbol(Quantity::Length, unit);
}

PathRemark remarkOf(const PathChecks::State& state, const RobotPath& path, LengthUnit unit, const QLocale& locale) {
  const Words words(unit, locale);
  const auto plain = [](const QString& text, const QString& details, const char* icon) {
    return PathRemark{text, text, details, QLatin1String(icon)};
  };
  if (path.places.size() < 2)
    return plain(Words::tr("too few places"), Words::tr("A path needs at least two places."), "info");
  if (state.isUnderWay) return plain(Words::tr("verifying…"), Words::tr("The path is being verified."), "");
  if (!state.last) {
    return plain(Words::tr("not verified yet"),
                 Words::tr("Not verified since the document was opened: select the path, or choose Verify all paths."),
                 "info");
  }
  const QString found = words.found(*state.last);
  if (state.change != BasisChange::Nothing) {
    const QString text = Words::notSince(state.change);
    return plain(text, text + QLatin1Char('\n') + Words::tr("Before: %1").arg(found), "info");
  }
  const bool isFree =
      state.last->checked && state.last->checked->isCertified() && state.last->checked->partMoved.empty();
  return {words.shortly(*state.last), found, (QStringList{found} + words.details(*state.last)).join('\n'),
          isFree ? QStringLiteral("ok") : QStringLiteral("warning")};
}

}  // namespace handwheel
