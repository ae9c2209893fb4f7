// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/StateCard.h"

#include "panels/defects/DefectList.h"
#include "panels/defects/DefectModel.h"
#include "text/RepairText.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>

namespace handwheel {

namespace {

struct Verdict {
  QString icon;
  QColor colour;
  QString headline;
};

Verdict verdictOn(const DefectList& defectList) {
  const ThemeColours& colours = themeColours(currentTheme());
  const auto holes = static_cast<int>(defectList.count(DefectKind::Hole));
  const MeshState state = defectList.state();
  if (holes > 0) {
    return {defectIconName(DefectKind::Hole), defectColour(DefectKind::Hole),
            StateCard::tr("%Ln hole(s)", nullptr, holes)};
  }
  const auto warning = [&colours](const QString& headline) {
    return Verdict{QStringLiteral("warning"), colours.warning, headline};
  };
  if (!state.manifold) return warning(StateCard::tr("Not manifold"));
  if (defectList.count(DefectKind::InsideOut) > 0) return warning(StateCard::tr("Inside out"));
  if (defectList.count(DefectKind::Inconsistent) > 0) return warning(StateCard::tr("Inconsistently oriented"));
  if (!state.oriented) return warning(StateCard::tr("Not oriented"));
  if (state.selfIntersectingPairs.value_or(0) > 0) return warning(StateCard::tr("Self-intersecting"));
  if (state.isKnownSound()) return {QStringLiteral("watertight"), colours.success, StateCard::tr("Watertight")};
  if (state.isSound()) return {QStringLiteral("watertight"), colours.muted, StateCard::tr("Closed")};
  return {defectIconName(DefectKind::KeptOpen), defectColour(DefectKind::KeptOpen), StateCard::tr("No holes")};
}

// Returns the state, and the changes that are no part of it.
QString detailsOf(const DefectList& defectList) {
  QStringList parts{stateText(defectList.state())};
  const auto add = [&](std::size_t count, const auto& phrase) {
    if (const auto n = static_cast<int>(count); n > 0) parts << phrase(n);
  };
  if (!defectList.state().selfIntersectingPairs) parts << StateCard::tr("self-intersections not known yet");
  const std::size_t sheets = defectList.sheetCount();
  add(sheets, [](int n) { return StateCard::tr("%Ln open sheet(s)", nullptr, n); });
  add(defectList.count(DefectKind::KeptOpen) - sheets,
      [](int n) { return StateCard::tr("%Ln hole(s) kept open", nullptr, n); });
  add(defectList.count(DefectKind::Flipped),
      [](int n) { return StateCard::tr("%Ln reversed on opening", nullptr, n); });
  // Lines break between the findings, not within one.
  QString text = parts.join(QStringLiteral(", ")).replace(QLatin1Char(' '), QChar::Nbsp);
  text.replace(QLatin1Char(',') + QString(QChar::Nbsp), QStringLiteral(", "));
  return text.replace(QLatin1Char('-'), QChar(0x2011));
}

}  // namespace

QString stateHeadline(const DefectList& defectList) {
  return verdictOn(defectList).headline;
}

StateCard::StateCard(QWidget* parent)
    : QFrame(parent), m_icon(new QLabel(this)), m_headline(new QLabel(this)), m_details(new QLabel(this)) {
  setObjectName(QStringLiteral("stateCard"));
  setProperty("card", true);
  m_headline->setObjectName(QStringLiteral("stateHeadline"));
  m_details->setObjectName(QStringLiteral("stateDetails"));
  m_details->setProperty("muted", true);
  m_details->setWordWrap(true);
  QFont big = m_headline->font();
  big.setPointSizeF(big.pointSizeF() * 1.35);
  big.setBold(true);
  m_headline->setFont(big);
  m_headline->setWordWrap(true);
  auto* text = new QVBoxLayout;
  text->setSpacing(2);
  text->addWidget(m_headline);
  text->addWidget(m_details);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 8, 12, 8);
  row->setSpacing(12);
  row->addWidget(m_icon);
  row->addLayout(text, 1);
}

void StateCard::showState(const DefectList& defectList) {
  const Verdict verdict = verdictOn(defectList);
  m_icon->setPixmap(icon(verdict.icon, verdict.colour).pixmap(QSize(28, 28), devicePixelRatioF()));
  m_headline->setText(verdict.headline);
  m_headline->setProperty("good", defectList.state().isKnownSound());
  m_headline->style()->polish(m_headline);  // the style sheet colours a good state
  m_details->setText(detailsOf(defectList));
  setAccessibleName(verdict.headline + QStringLiteral(", ") + m_details->text());
}

}  // namespace handwheel
