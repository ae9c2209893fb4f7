// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The action that optimises a path.
#include "document/cell/RobotCellDocument.h"
#include "tools/cell/path/OptimisePathOperation.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"

#include <algorithm>

namespace handwheel {

void CellPaths::optimise() {
  const RobotPath* const present = path();
  const auto scene = m_collisions.scene();
  if (!present) return;
  if (!scene) return reportUnprepared();
  OperationValues values(optimisePathOperation());
  setFidelity(values, m_parts.fidelity.values());
  DocumentTab& tab = *m_document;
  Job job;
  job.name = tr("Optimising %1").arg(QString::fromStdString(present->name));
  job.document = &tab.document;
  job.failed = [this, &tab](const Error& error) { report(&tab, error); };
  job.work = [this, &tab, scene, content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot()),
              before = *present,
              settings = optimisationSettingsOf(values, plans(), *present)](Progress progress) -> Job::Finish {
    auto optimised = optimisedPath(*scene, *content->plans, before, settings, progress);
    return [this, &tab, scene, content, before, optimised = std::move(optimised)]() mutable {
      const RobotPath* const now = cellIn(tab).plans()->path(before.name);
      if (!now) return;
      if (!(*now == before) || !isUnchanged(tab, *scene, *content)) {
        return reportChanged(tab, before.name, [this, name = before.name] {
          if (choosePath(name)) optimise();
        });
      }
      if (!optimised) return report(&tab, optimised.error());
      takeOptimised(tab, *optimised);
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellPaths::takeOptimised(DocumentTab& tab, const OptimisedPath& optimised) {
  const std::string& id = optimised.planned.path.name;
  const QString name = QString::fromStdString(id);
  const QLocale locale;
  const auto seconds = [&](double time) { return locale.toString(time, 'f', 2); };
  QString detail;
  if (optimised.isChanged) {
    CellPlans changed = *cellIn(tab).plans();
    *std::find_if(changed.paths.begin(), changed.paths.end(), [&](const RobotPath& each) { return each.name == id; }) =
        optimised.planned.path;
    commit(tab, tr("Optimise %1").arg(name), std::move(changed));
    select(tab, {PlanTree::Entry::Kind::Path, id});
    detail = tr("Cycle time %1 s before, %2 s now.").arg(seconds(optimised.before), seconds(optimised.after));
    if (!std::is_sorted(optimised.order.begin(), optimised.order.end()))
      detail += QLatin1Char(' ') + tr("The places are in another order.");
    if (optimised.reconfigured > 0) {
      detail += QLatin1Char(' ') + tr("%Ln place(s) in another configuration of the arm.", nullptr,
                                      static_cast<int>(optimised.reconfigured));
    }
  } else {
    detail = tr("No other order or configuration takes less than its %1 s.").arg(seconds(optimised.before));
  }
  emit message({Message::Weight::Info,
                optimised.isChanged ? tr("%1 was optimised").arg(name) : tr("%1 was not changed").arg(name),
                detail,
                {},
                {},
                {},
                {},
                {},
                &tab.document});
}

}  // namespace handwheel
