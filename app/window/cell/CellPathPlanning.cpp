// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The actions that plan paths.
#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/cell/PlanDialog.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"

#include <algorithm>

namespace handwheel {

void CellPaths::askForPath() {
  CellPlans offered = plans();  // configurations of another robot are no places of this one
  std::erase_if(offered.configurations,
                [&](const NamedConfiguration& each) { return !isSameArm(cell().robot(), each.arm, offered.arm); });
  auto* dialog = new PlanDialog(offered, m_parts.fidelity.values(), m_document->document.displayUnit(), m_parts.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PlanDialog::chosen, this, [this, document = m_document](const OperationValues& values) {
    if (document == m_document) plan(values);
  });
  dialog->open();
}

void CellPaths::plan(const OperationValues& values) {
  const auto scene = m_collisions.scene();
  if (!scene) return reportUnprepared();
  const auto content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot());
  const Result<std::vector<PathPlace>> places = placesOf(values, *scene, *content);
  if (!places) return report(places.error());
  const std::string name = plans().freePathName(values.isSet("name") ? values.text("name") : tr("Path").toStdString());
  startPlanning(*places, routeSettingsOf(values, plans()), name, tr("Plan %1"), [this, values] { plan(values); });
}

void CellPaths::planAgain() {
  const RobotPath* const present = path();
  if (!present) return;
  const auto again = [this, name = present->name] {
    m_tree->select({PlanTree::Entry::Kind::Path, name});
    planAgain();
  };
  const QString text = tr("Plan %1 again");
  if (present->process) {
    Planning planning = processPlanning(valuesOf(*present->process), nullptr, present->process->part);
    return startPlanning(std::move(planning), present->name, text, again);
  }
  OperationValues values(planOperation());
  setFidelity(values, m_parts.fidelity.values());
  startPlanning(present->places, routeSettingsOf(values, plans()), present->name, text, again);
}

void CellPaths::startPlanning(std::vector<PathPlace> places, const RouteSettings& settings, const std::string& name,
                              const QString& text, std::function<void()> again) {
  startPlanning([places = std::move(places), settings](
                    const CellScene& scene, const RobotCellSnapshot& content,
                    Progress progress) { return plannedThrough(scene, *content.plans, places, settings, progress); },
                name, text, std::move(again));
}

void CellPaths::planProcess(const OperationValues& values, std::shared_ptr<const PartSurface> surface) {
  startPlanning(processPlanning(values, std::move(surface), std::nullopt),
                plans().freePathName(tr("Process").toStdString()), tr("Plan %1"),
                [this, values] { planProcess(values, nullptr); });  // the part may be another one then
}

CellPaths::Planning CellPaths::processPlanning(const OperationValues& values,
                                               std::shared_ptr<const PartSurface> surface,
                                               const std::optional<Pose>& chosenAt) {
  return [values, surface = std::move(surface), chosenAt](const CellScene& scene, const RobotCellSnapshot& content,
                                                          Progress progress) -> Result<PlannedPath> {
    const Result<BodyPointer> part = partCalled(values, scene);
    if (!part) return part.error();
    const auto own = surface ? surface : std::make_shared<const PartSurface>(*(*part)->geometry->surface());
    return processPath(scene, content, values, own, **part, progress, chosenAt);
  };
}

void CellPaths::startPlanning(Planning planning, const std::string& name, const QString& text,
                              std::function<void()> again) {
  const auto scene = m_collisions.scene();
  if (!scene) return reportUnprepared();
  const RobotPath* const present = plans().path(name);
  Job job;
  job.name = tr("Planning %1").arg(QString::fromStdString(name));
  job.owner = this;
  job.failed = [this](const Error& error) { report(error); };
  job.work = [this, scene, content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot()),
              planning = std::move(planning), before = present ? std::optional(*present) : std::nullopt, name, text,
              again = std::move(again)](Progress progress) -> Job::Finish {
    auto planned = planning(*scene, *content, progress);
    return [this, scene, before, name, text, again, planned = std::move(planned)]() mutable {
      if (!m_document) return;
      if (scene != m_collisions.scene()) return reportChanged(name, again);
      if (!planned) return report(planned.error());
      planned->path.name = name;
      takePlanned(std::move(planned->path), before, text);
    };
  };
  m_parts.jobs.start(std::move(job));
}

// before: the path of this name when planning began. What was changed by hand since then stays.
void CellPaths::takePlanned(RobotPath planned, const std::optional<RobotPath>& before, const QString& text) {
  const std::string wanted = planned.name;
  CellPlans changed = plans();
  const auto old = std::find_if(changed.paths.begin(), changed.paths.end(),
                                [&](const RobotPath& each) { return each.name == wanted; });
  const bool wasEdited = old != changed.paths.end() && !(before && *old == *before);
  if (wasEdited) planned.name = changed.freePathName(wanted);
  const QString name = QString::fromStdString(planned.name);
  const PlanTree::Entry entry{PlanTree::Entry::Kind::Path, planned.name};
  if (old == changed.paths.end() || wasEdited)
    changed.paths.push_back(std::move(planned));
  else
    *old = std::move(planned);
  commit(text.arg(name), std::move(changed));
  m_tree->select(entry);
  if (!wasEdited) return;
  emit message({Message::Weight::Info,
                tr("%1 was changed while it was planned").arg(QString::fromStdString(wanted)),
                tr("Your changes stay; what was planned is %1.").arg(name),
                {},
                {},
                {},
                {},
                {},
                &m_document->document});
}

// again: begins once more.
void CellPaths::reportChanged(const std::string& path, const std::function<void()>& again) {
  emit message({Message::Weight::Warning,
                tr("The cell was changed while %1 was planned").arg(QString::fromStdString(path)),
                tr("The result does not hold for the cell as it is now, and was thrown away."),
                {},
                tr("Plan it again"),
                [this, document = m_document, again] {
                  if (document == m_document) again();
                },
                {},
                {},
                &m_document->document});
}

}  // namespace handwheel
