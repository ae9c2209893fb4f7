// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/LatheEvents.h"

#include "theme/Theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

struct Event {
  double time = 0.0;  // s
  QString text;
  bool isCrash = false;
};

QString eventNumber(double value, int digits) {
  return QLocale().toString(value, 'f', digits);
}

Event eventOf(const LatheCollision& crash, double zero) {
  const auto part = [](LathePart which) { return QCoreApplication::translate("LathePart", titleOf(which)); };
  return {crash.time,
          LatheEvents::tr("%1 s: crash, %2 – %3 at R %4, Z %5. %6")
              .arg(eventNumber(crash.time, 1), part(crash.moving), part(crash.struck),
                   eventNumber(crash.position.x(), 2), eventNumber(crash.position.y() - zero, 2),
                   QCoreApplication::translate("LathePart", sentenceOf(crash.cause))),
          true};
}

Event eventOf(const LatheWarning& warning) {
  return {warning.time, LatheEvents::tr("%1 s: %2").arg(eventNumber(warning.time, 1), textOfRule(warning.warning)),
          false};
}

}  // namespace

QString textOfRule(const CutWarning& warning) {
  const QString value = QLocale().toString(warning.value, 'g', 3), limit = QLocale().toString(warning.limit, 'g', 3);
  switch (warning.rule) {
    case CutWarning::Rule::Power:
      return LatheEvents::tr("Power: the cut needs %1 kW, and the motor has %2 kW; the spindle slows down.")
          .arg(value, limit);
    case CutWarning::Rule::Torque:
      return LatheEvents::tr("Torque: the cut needs %1 N·m, and the spindle has %2 N·m; the spindle stalls.")
          .arg(value, limit);
    case CutWarning::Rule::Slenderness:
      return LatheEvents::tr(
                 "L/D: the work protrudes by %1 times its diameter; at most %2 times is recommended. Support it.")
          .arg(value, limit);
    case CutWarning::Rule::Deflection:
      return LatheEvents::tr("Deflection: the work bends away and is left %1 mm thicker here; the limit is %2 mm.")
          .arg(value, limit);
    case CutWarning::Rule::Chatter:
      return LatheEvents::tr("Chatter: the depth of cut is %1 mm; up to %2 mm is stable at any spindle speed.")
          .arg(value, limit);
    case CutWarning::Rule::Pressing:
      return LatheEvents::tr(
                 "Pressing: this tool is laid on the surface and cannot be fed %1 mm into the work; its full force is "
                 "reached at %2 mm.")
          .arg(value, limit);
    case CutWarning::Rule::Rubbing:
      break;
  }
  const QString chip = warning.value < kLeastShownChip
                           ? LatheEvents::tr("less than %1").arg(QLocale().toString(kLeastShownChip, 'g', 3))
                           : value;
  return LatheEvents::tr("Rubbing: a chip thickness of %1 mm is too small to be cut; at least %2 mm is needed.")
      .arg(chip, limit);
}

LatheEvents::LatheEvents(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("latheCrashes"));
  setAccessibleName(tr("Crashes and warnings"));
  setToolTip(
      tr("Collisions with the parts involved, and warnings with the rule that was broken, each with its time. A crash "
         "stops the spindle."));
  setMinimumWidth(180);
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  setResizeMode(QListView::Adjust);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);  // it breaks its lines
}

void LatheEvents::show(const ManualLatheTool& tool) {
  std::vector<LatheCollision> crashes = tool.collisions();
  std::vector<LatheWarning> warnings = tool.warnings();
  const double zero = tool.eventsZero(), before = std::exchange(m_zero, zero);
  if (crashes == m_crashes && warnings == m_warnings && zero == before) return;
  m_crashes = std::move(crashes);
  m_warnings = std::move(warnings);
  std::vector<Event> events;
  for (const LatheCollision& crash : m_crashes) events.push_back(eventOf(crash, zero));
  for (const LatheWarning& warning : m_warnings) events.push_back(eventOf(warning));
  std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.time < b.time; });
  clear();
  for (const Event& event : events) {
    auto* const item = new QListWidgetItem(event.text, this);
    if (event.isCrash) item->setForeground(themeColours(currentTheme()).error);
  }
  scrollToBottom();
}

}  // namespace handwheel
