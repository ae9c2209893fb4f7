// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The action that lets pairs of links and bodies touch.
#include "document/cell/RobotCellDocument.h"
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

}  // namespace handwheel
