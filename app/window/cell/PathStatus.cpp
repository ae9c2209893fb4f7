// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/PathStatus.h"

#include "base/ShownDistance.h"
#include "controls/QuantityText.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

class Words {
  Q_DECLARE_TR_FUNCTIONS(PathStatus)

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
        return tr("not verified since the allowed pairs, or the shapes left out, were changed");
      case BasisChange::Tool:
        return tr("not verified since the tool centre point was changed");
      case BasisChange::Clearance:
        return tr("not verified since the clearance was changed");
      case BasisChange::Targets:
        return tr("not verified since its targets or frames were moved");
      case BasisChange::Configurations:
        return tr("not verified since its configurations were changed");
      case BasisChange::Rates:
        return tr("not verified since what is assumed for the times was changed");
      case BasisChange::Nothing:
        break;
    }
    return tr("not verified yet");
  }

  QString shortly(const PathResult& result) const {
    if (!result.found) return tr("cannot be verified");
    const PathFindings& found = *result.found;
    const bool isOutdated = found.outdated.isAny();
    if (isOutdated && (found.stopsAt || !found.isCertified)) return withProblem(found, planAgain(found.outdated));
    if (found.stopsAt) return tr("line cannot be followed, %1").arg(time(result));
    if (!found.isCertified) return tr("%1, %2").arg(collisions(found), time(result));
    if (isOutdated) return planAgain(found.outdated);
    const QString known = tr("%1, %2").arg(clearanceText(found.leastClearance, m_unit, m_locale), time(result));
    return withRemarks(found, found.isTouching ? tr("free, but touching, %1").arg(known) : tr("free, %1").arg(known));
  }

  QString found(const PathResult& result) const {
    if (!result.found) return tr("cannot be verified");
    const PathFindings& found = *result.found;
    if (found.outdated.isAny() && (found.stopsAt || !found.isCertified))
      return tr("%1 (%2)").arg(withProblem(found, planAgain(found.outdated)), time(result));
    if (found.stopsAt) return tr("line cannot be followed (%1)").arg(time(result));
    if (!found.isCertified) return tr("%1 (%2)").arg(collisions(found), time(result));
    const QString known =
        tr("%1, clearance %2").arg(time(result), clearanceText(found.leastClearance, m_unit, m_locale));
    return withRemarks(found, found.isTouching ? tr("free of collisions, but touching (%1)").arg(known)
                                               : tr("free of collisions (%1)").arg(known));
  }

  QStringList details(const PathResult& result) const {
    QStringList lines{tr("Verified at %1.").arg(m_locale.toString(result.at, QLocale::ShortFormat))};
    if (!result.found) return lines + QStringList{result.problem};
    const PathFindings& found = *result.found;
    lines += outdatedSentences(found.outdated);
    if (found.outdated.isAny()) lines += tr("Plan it again.");
    if (found.stopsAt)
      return lines + QStringList{tr("The straight line to place %1 leaves the reach of the arm or the limits of its "
                                    "joints.")
                                     .arg(*found.stopsAt + 1)};
    lines += missingSentences(found.missing);
    for (const ProofGap& gap : found.gaps) lines += gapSentence(gap);
    if (!found.isCertified) return lines + listedCollisions(found, m_unit, m_locale);
    const double kept = found.clearance;
    lines += kept > 0.0 ? tr("Every motion is proven to keep a clearance of %1.")
                              .arg(quantityText(kept, Quantity::Length, m_unit, m_locale))
                        : tr("Every motion is proven free of collisions.");
    lines += tr("Least clearance: %1.").arg(clearanceText(found.leastClearance, m_unit, m_locale));
    if (const std::size_t stops = result.checked ? stoppedBlends(result.basis.path, *result.checked) : 0; stops > 0) {
      lines += tr("%Ln blend(s) will be exact stops, as not every way within their zones is proven free.", nullptr,
                  static_cast<int>(stops));
    }
    lines += tr("Estimated cycle time: %1 s.").arg(m_locale.toString(found.seconds, 'f', 1));
    const WaitingTime waiting = waitingTimeOf(result.basis.path);
    if (waiting.seconds > 0.0) lines += tr("%1 s of it is waiting.").arg(m_locale.toString(waiting.seconds, 'f', 1));
    if (waiting.unknown > 0) {
      lines += tr("The time of %Ln line(s) that wait for something is not in it.", nullptr,
                  static_cast<int>(waiting.unknown));
    }
    return lines;
  }

 private:
  // Time of the day, or on another day its date.
  QString time(const PathResult& result) const {
    const bool isToday = result.at.date() == QDate::currentDate();
    return isToday ? m_locale.toString(result.at.time(), QLocale::ShortFormat)
                   : m_locale.toString(result.at.date(), QLocale::ShortFormat);
  }
  static QString collisions(const PathFindings& found) {
    const auto open = std::ranges::find(found.missing, MissingShape::State::Open, &MissingShape::state);
    if (found.collisions == 0 && open != found.missing.end())
      return tr("not proven: the shape of %1 is missing").arg(QString::fromStdString(open->name));
    if (found.collisions == 0 && !found.gaps.empty()) return shortText(found.gaps.front());
    const auto tooNear = static_cast<int>(std::min(found.tooNear, found.collisions));
    const int meeting = static_cast<int>(found.collisions) - tooNear;
    const QString nearly = tr("too near %Ln time(s)", nullptr, tooNear);
    if (meeting == 0 && tooNear > 0) return nearly;
    const QString met = tr("%Ln collision(s)", nullptr, meeting);
    return tooNear > 0 ? tr("%1, %2").arg(met, nearly) : met;
  }
  static QString shortText(const ProofGap& gap) {
    if (gap.kind == ProofGap::Kind::Corner) return tr("not proven: CNT");
    if (gap.kind == ProofGap::Kind::Zone) return tr("not proven: blend at place %1").arg(gap.waypoint + 1);
    return tr("proven only as far as what is carried is known");
  }
  QString gapSentence(const ProofGap& gap) const {
    if (gap.kind == ProofGap::Kind::Zone)
      return gap.kept > 0.0
                 ? tr("Not everything within the blend of the program at place %1 is free: an export writes %2.")
                       .arg(gap.waypoint + 1)
                       .arg(quantityText(gap.kept, Quantity::Length, m_unit, m_locale))
                 : tr("Not everything within the blend of the program at place %1 is free: an export writes an exact "
                      "stop.")
                       .arg(gap.waypoint + 1);
    if (gap.kind == ProofGap::Kind::Corner)
      return tr("The controller rounds the corner at place %1 (CNT), and not everything within it is free: set its "
                "rounding to 0, or change the places.")
          .arg(gap.waypoint + 1);
    return tr("The proof ends at place %1: \"%2\" may grip or release something. Say at that place that the robot "
              "carries the same as before.")
        .arg(gap.waypoint + 1)
        .arg(QString::fromStdString(gap.text));
  }
  // Adds the problem of a path that is not free.
  static QString withProblem(const PathFindings& found, const QString& text) {
    return tr("%1; %2").arg(text, found.stopsAt ? tr("line cannot be followed") : collisions(found));
  }
  static QString planAgain(const OutdatedReasons& outdated) {
    if (!outdated.part.empty()) return tr("plan again: %1 has moved").arg(QString::fromStdString(outdated.part));
    if (outdated.isBaseOther) return tr("plan again: its robot has moved");
    if (outdated.isToolOther) return tr("plan again: the tool centre point was changed");
    if (!outdated.targets.empty())
      return tr("plan again: it misses %1").arg(QString::fromStdString(*outdated.targets.begin()));
    if (!outdated.frames.empty())
      return tr("plan again: the frame %1 has moved").arg(QString::fromStdString(*outdated.frames.begin()));
    return tr("plan again: %1 was changed").arg(QString::fromStdString(*outdated.configurations.begin()));
  }
  static QStringList missingSentences(const std::vector<MissingShape>& missing) {
    QStringList lines;
    for (const MissingShape& each : missing) {
      const QString name = QString::fromStdString(each.name), what = QString::fromStdString(each.what);
      switch (each.state) {
        case MissingShape::State::Open:
          lines += tr("The shape of %1 (%2) could not be read, so nothing is proven free: leave it out or replace it "
                      "in the panel Cell.")
                       .arg(name, what);
          break;
        case MissingShape::State::LeftOut:
          lines += tr("The shape of %1 (%2) could not be read, and is left out of the proof.").arg(name, what);
          break;
        case MissingShape::State::Replaced:
          lines += tr("The shape of %1 (%2) could not be read, and %3 replaces it.")
                       .arg(name, what, QString::fromStdString(each.by));
          break;
      }
    }
    return lines;
  }
  static QString withRemarks(const PathFindings& found, QString text) {
    QStringList decided;
    for (const MissingShape& each : found.missing) {
      if (each.state == MissingShape::State::LeftOut) decided += QString::fromStdString(each.name);
    }
    if (!decided.isEmpty()) text = tr("%1; left out: %2").arg(text, decided.join(QStringLiteral(", ")));
    if (const QString pairs = notCheckedText(found.notChecked); !pairs.isEmpty())
      text = tr("%1; not checked: %2").arg(text, pairs);
    if (found.robotsMoved.empty()) return text;
    return tr("%1; %2 has moved since").arg(text, QString::fromStdString(*found.robotsMoved.begin()));
  }

  LengthUnit m_unit;
  QLocale m_locale;
};

}  // namespace

QStringList collisionsOf(const PathFindings& found, LengthUnit unit, const QLocale& locale) {
  QStringList texts;
  for (const PathFindings::Meeting& each : found.listed) {
    const QString link = QString::fromStdString(each.link), other = QString::fromStdString(each.other);
    texts += each.distance > 0.0
                 ? Words::tr("On the way to place %1: %2 only %4 from %3")
                           .arg(each.waypoint + 1)
                           .arg(link, other, clearanceText(each.distance, unit, locale)) +
                       (each.needed > 0.0 ? Words::tr(" (the proof needs %1)")
                                                .arg(quantityText(each.needed, Quantity::Length, unit, locale))
                                          : QString())
                 : Words::tr("On the way to place %1: %2 with %3").arg(each.waypoint + 1).arg(link, other);
  }
  return texts;
}

QStringList listedCollisions(const PathFindings& found, LengthUnit unit, const QLocale& locale) {
  QStringList texts = collisionsOf(found, unit, locale);
  if (found.collisions > found.listed.size())
    texts += Words::tr("and %Ln more", nullptr, static_cast<int>(found.collisions - found.listed.size()));
  return texts;
}

QString linkedDetails(const PathStatus& status) {
  QStringList lines;
  qsizetype next = 0;
  for (const QString& line : status.details.split(QLatin1Char('\n'))) {
    const bool isLink = next < status.collisions.size() && line == status.collisions[next];
    lines +=
        isLink ? QStringLiteral("<a href=\"%1\">%2</a>").arg(next++).arg(line.toHtmlEscaped()) : line.toHtmlEscaped();
  }
  return lines.join(QStringLiteral("<br>"));
}

QStringList outdatedSentences(const OutdatedReasons& outdated) {
  QStringList reasons;
  if (!outdated.part.empty()) {
    reasons +=
        Words::tr("It leads along the curve where %1 was when it was planned: the tool does not meet it any more.")
            .arg(QString::fromStdString(outdated.part));
  }
  if (outdated.isBaseOther)
    reasons += Words::tr("Its robot stood elsewhere when its curve was planned: the tool does not meet that any more.");
  if (outdated.isToolOther)
    reasons += Words::tr("The tool centre point was another one when its curve was planned: that is not met any more.");
  for (const std::string& target : outdated.targets) {
    reasons += Words::tr("The tool does not come to the target %1 any more: that, or the tool, has moved since.")
                   .arg(QString::fromStdString(target));
  }
  for (const std::string& frame : outdated.frames) {
    reasons += Words::tr(
                   "The frame %1, or the tool, has moved since the program was opened: the path leads to where "
                   "that was. Plan the path again, or open the program again.")
                   .arg(QString::fromStdString(frame));
  }
  for (const std::string& configuration : outdated.configurations)
    reasons += Words::tr("It leads to %1 as that was stored when the path was planned: it was changed since.")
                   .arg(QString::fromStdString(configuration));
  return reasons;
}

QString notCheckedText(const std::vector<std::pair<std::string, std::string>>& pairs) {
  constexpr std::size_t kMostNamed = 3;
  QStringList texts;
  for (const auto& [one, other] : pairs) {
    if (texts.size() == kMostNamed) break;
    texts += Words::tr("%1 with %2").arg(QString::fromStdString(one), QString::fromStdString(other));
  }
  if (pairs.size() > kMostNamed)
    texts += Words::tr("and %Ln more", nullptr, static_cast<int>(pairs.size() - kMostNamed));
  return texts.join(QStringLiteral(", "));
}

QString clearanceText(double least, LengthUnit unit, const QLocale& locale) {
  constexpr double kFarthest = PathMetricsSettings().farthest;
  if (!(least < kFarthest)) return QStringLiteral("> ") + quantityText(kFarthest, Quantity::Length, unit, locale);
  const bool isMetric = unit == LengthUnit::Millimetre;
  constexpr double kThousandths = 1e3;  // Also for other units; rounded down, too
  const double shown = isMetric
                           ? shownDistance(least)
                           : std::floor(least / perShownUnit(Quantity::Length, unit) * kThousandths) / kThousandths;
  return locale.toString(shown, 'f', isMetric ? decimalsOfDistance(least) : 3) + QLatin1Char(' ') +
         unitSymbol(Quantity::Length, unit);
}

PathStatus pathStatusOf(const PathChecks::State& state, const RobotPath& path, LengthUnit unit, const QLocale& locale) {
  const Words words(unit, locale);
  const auto plain = [](const QString& text, const QString& details, const char* icon) {
    return PathStatus{text, text, details, {}, QLatin1String(icon), false};
  };
  if (path.waypoints.size() < 2)
    return plain(Words::tr("too few places"), Words::tr("A path needs at least two places."), "info");
  if (state.isUnderWay) return plain(Words::tr("verifying…"), Words::tr("The path is being verified."), "");
  if (!state.last) {
    return plain(Words::tr("not verified yet"),
                 Words::tr("It was never verified: select the path, or choose Verify all paths."), "info");
  }
  const QString found = words.found(*state.last);
  if (state.change != BasisChange::Nothing) {
    const QString text = Words::notSince(state.change);
    return plain(text, text + QLatin1Char('\n') + Words::tr("Before: %1").arg(found), "info");
  }
  const bool isFree = state.last->found && state.last->found->isCertified && !state.last->found->outdated.isAny();
  // Only what was proven in this session is shown as such.
  const bool isStored = isFree && !state.last->checked;
  const QString summary = isStored ? Words::tr("%1, as stored with the cell").arg(found) : found;
  const char* const icon = !isFree ? "warning" : isStored ? "info" : "ok";
  const auto& findings = state.last->found;
  const bool isListed = findings && !findings->isCertified && !findings->stopsAt;
  return {words.shortly(*state.last),
          summary,
          (QStringList{summary} + words.details(*state.last)).join('\n'),
          isListed ? collisionsOf(*findings, unit, locale) : QStringList(),
          QLatin1String(icon),
          isFree};
}

}  // namespace handwheel
