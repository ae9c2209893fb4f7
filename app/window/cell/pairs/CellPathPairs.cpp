// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The action that lets pairs of links and bodies touch.
#include "document/cell/CellErrors.h"
#include "document/cell/RobotCellDocument.h"
#include "text/ErrorText.h"
#include "window/cell/CellPaths.h"
#include "window/cell/pairs/PairsDialog.h"
#include "window/documents/DocumentTab.h"

namespace handwheel {

// Those that meet where the robot is, and that the verification of the present path has found.
void CellPaths::askForPairs() {
  const auto now = scene();
  if (!now) return reportUnprepared();
  std::set<PairNames> found;
  const auto add = [&](const RobotScene::Nearest& nearest) {
    if (auto pair = pairNamesOf(*now, nearest)) found.insert(*std::move(pair));
  };
  for (const RobotScene::Nearest& each : now->scene.allTooNear(now->planned(cell().joints()), 0.0, 0.0)) add(each);
  if (const auto known = checked()) {
    for (const PathCollision& each : known->verification.collisions) add(each.deepest);
  }
  auto* const dialog = new PairsDialog(plans(), found, cell().bodies(), m_parts.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(
      dialog, &PairsDialog::chosen, this,
      [this, document = m_document](const std::vector<PairNames>& allowed, const std::vector<PairNames>& forbidden) {
        if (document != m_document) return;
        CellPlans changed = plans();
        for (const PairNames& each : allowed) setAllowed(changed, each, true);
        for (const PairNames& each : forbidden) setAllowed(changed, each, false);
        commit(tr("Change the pairs that may touch"), std::move(changed));
      });
  dialog->open();
}

// Only bodies, as a tool and its part, are meant to touch; a link that meets something is none to allow in passing.
void CellPaths::reportHindered(DocumentTab& tab, const Error& error, const QString& title) {
  const std::vector<std::string>& named = error.arguments;
  const bool isMet = error.code == CellError::PlaceCollides || error.code == CellError::LineCollides;
  const bool isOnCurve = error.code == CellError::TrackBlocked;
  const std::size_t at = isOnCurve ? 5 : 1;  // where the error has the two
  const auto pair = (isMet || isOnCurve) && named.size() >= at + 2
                        ? bodiesCalled(named[at], named[at + 1], cellIn(tab).bodies(), cellIn(tab).robot().model)
                        : std::nullopt;
  if (!pair) return report(&tab, error, title);
  Message said{
      .weight = Message::Weight::Error,
      .title = title,
      .detail = errorSentence(error),
      .advice = errorAdvice(error),
      .actionText =
          tr("&Let %1 touch %2").arg(QString::fromStdString(named[at]), QString::fromStdString(named[at + 1]))};
  said.action = [this, pair, document = &tab] {
    if (document != m_document) return;
    CellPlans changed = plans();
    setAllowed(changed, *pair, true);
    commit(tr("Change the pairs that may touch"), std::move(changed));
  };
  said.about = &tab.document;
  emit message(said);
}

}  // namespace handwheel
