// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/StateCard.h"

#include "panels/defects/DefectModel.h"
#include "panels/defects/Inspection.h"
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

Verdict verdictOn(const Inspection& inspection) {
  const ThemeColours& colours = themeColours(currentTheme());
  const auto holes = static_cast<int>(inspection.count(DefectKind::Hole));
  if (inspection.isWatertight()) return {QStringLiteral("watertight"), colours.success, StateCard::tr("Watertight")};
  if (holes > 0) {
    return {defectIconName(DefectKind::Hole), defectColour(DefectKind::Hole),
            StateCard::tr("%Ln hole(s)", nullptr, holes)};
  }
  if (inspection.isClean()) {
    return {defectIconName(DefectKind::KeptOpen), defectColour(DefectKind::KeptOpen), StateCard::tr("No holes left")};
  }
  return {QStringLiteral("warning"), colours.warning, StateCard::tr("Not manifold")};
}

QString detailsOf(const Inspection& inspection) {
  QStringList parts;
  const auto add = [&](DefectKind kind, const auto& phrase) {
    if (const auto n = static_cast<int>(inspection.count(kind)); n > 0) parts << phrase(n);
  };
  const std::size_t tangled =
      inspection.count(DefectKind::NonManifoldEdge) + inspection.count(DefectKind::NonManifoldVertex);
  if (tangled > 0) parts << StateCard::tr("%1 non-manifold").arg(tangled);
  add(DefectKind::OneSided, [](int n) { return StateCard::tr("%Ln edge(s) with one side", nullptr, n); });
  add(DefectKind::KeptOpen, [](int n) { return StateCard::tr("%Ln kept open", nullptr, n); });
  add(DefectKind::Flipped, [](int n) { return StateCard::tr("%Ln turned over", nullptr, n); });
  add(DefectKind::SelfIntersection, [](int n) { return StateCard::tr("%Ln self-intersection(s)", nullptr, n); });
  if (parts.isEmpty())
    return inspection.isWatertight() ? StateCard::tr("Closed and manifold") : StateCard::tr("Manifold");
  // Lines break between the findings, not within one.
  parts.replaceInStrings(QStringLiteral(" "), QString(QChar::Nbsp));
  parts.replaceInStrings(QStringLiteral("-"), QStringLiteral("\u2011"));
  return parts.join(QStringLiteral(", "));
}

}  // namespace

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

void StateCard::showState(const Inspection& inspection) {
  const Verdict verdict = verdictOn(inspection);
  m_icon->setPixmap(icon(verdict.icon, verdict.colour).pixmap(QSize(28, 28), devicePixelRatioF()));
  m_headline->setText(verdict.headline);
  m_headline->setProperty("good", inspection.isWatertight());
  m_headline->style()->polish(m_headline);  // the style sheet colours what is good
  m_details->setText(detailsOf(inspection));
  setAccessibleName(verdict.headline + QStringLiteral(", ") + m_details->text());
}

}  // namespace handwheel
