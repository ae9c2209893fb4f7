// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The actions that plan paths.
#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "panels/LogModel.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/cell/PathStatus.h"
#include "window/cell/PlanDialog.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"

#include <algorithm>
#include <set>

namespace handwheel {

void CellPaths::askForPath() {
  CellPlans offered = plans();  // Configurations of another robot are no waypoints of this one
  std::erase_if(offered.configurations,
                [&](const NamedConfiguration& each) { return !isSameArm(cell().robot(), each.arm, offered.arm); });
  auto* dialog = new PlanDialog(cell().robot(), offered, m_parts.fidelity.values(), m_planned,
                                m_document->document.displayUnit(), m_parts.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PlanDialog::chosen, this, [this, document = m_document](const OperationValues& values) {
    m_planned = values;
    if (document == m_document) plan(values);
  });
  dialog->open();
}

void CellPaths::verifyAgain() {
  const RobotPath* const present = path();
  if (!present) return;
  if (!scene()) return reportUnprepared();
  m_checks.verify(*present, PathChecks::Request::Again);
}

// Reports a verification on request. In most cases the result is known already, so the report shows that it was done.
void CellPaths::reportVerified(const PathResult& result) {
  const PathChecks::State state{&result, BasisChange::Nothing, false};
  const QString name = QString::fromStdString(result.basis.path.name);
  const PathStatus status = pathStatusOf(state, result.basis.path, cell().displayUnit(), QLocale());
  const QString title = tr("%1 was verified: %2").arg(name, status.summary);
  const bool isFree = result.found && result.found->isCertified;
  QStringList details =
      isFree || !result.found ? QStringList() : listedCollisions(*result.found, cell().displayUnit(), QLocale());
  if (!result.problem.isEmpty()) details += result.problem;
  QString detail = details.join(QStringLiteral("; "));
  if (result.checked) {
    const QString done = tr("%Ln motion(s)", nullptr, static_cast<int>(result.basis.path.waypoints.size()) - 1) +
                         QStringLiteral(", ") +
                         tr("%Ln point(s) checked.", nullptr, static_cast<int>(result.checked->verification.steps));
    detail = detail.isEmpty() ? done : done + QLatin1Char(' ') + detail;
  }
  m_parts.log.add(title + QStringLiteral(". ") + detail, {},
                  isFree ? LogEntry::Weight::Info : LogEntry::Weight::Warning);
  Message said{isFree ? Message::Weight::Info : Message::Weight::Warning, title, detail};
  said.about = &m_document->document;
  if (result.found && !result.found->listed.empty()) {
    said.actionText = tr("&Allow pairs to touch…");
    said.action = [this, document = m_document] {
      if (document == m_document) askForPairs();
    };
    said.otherText = tr("&Show the first on the time line");
    said.other = [this, document = m_document, of = result.basis.path.name] {
      if (document == m_document && choosePath(of)) emit collisionChosen(0);
    };
  }
  emit message(said);
}

// Reports the result of all: the number of proven paths, and the problem of the first other one.
void CellPaths::reportAllVerified() {
  int proven = 0;
  QStringList others;
  std::set<std::pair<std::string, std::string>> notChecked;  // on those that are proven
  for (const RobotPath& each : plans().paths) {
    const PathChecks::State state = m_checks.stateOf(each);
    const PathStatus status = pathStatusOf(state, each, cell().displayUnit(), QLocale());
    if (status.isFree) {
      ++proven;
      notChecked.insert(state.last->found->notChecked.begin(), state.last->found->notChecked.end());
    } else {
      others += tr("%1: %2").arg(QString::fromStdString(each.name), status.summary);
    }
  }
  const auto failed = static_cast<int>(others.size());
  QString title = tr("%Ln path(s) proven", nullptr, proven);
  if (failed > 0) title += QStringLiteral(", ") + tr("%Ln not", nullptr, failed);
  m_parts.log.add(title + QStringLiteral(". ") + others.join(QStringLiteral("; ")), {},
                  failed == 0 ? LogEntry::Weight::Info : LogEntry::Weight::Warning);
  Message said{failed == 0 ? Message::Weight::Info : Message::Weight::Warning, title};
  if (failed > 0) said.detail = others.front();
  if (const QString pairs = notCheckedText({notChecked.begin(), notChecked.end()}); !pairs.isEmpty()) {
    const QString text = tr("Not checked, as they may touch: %1.").arg(pairs);
    said.detail = said.detail.isEmpty() ? text : said.detail + QStringLiteral(". ") + text;
  }
  if (failed > 1) said.advice = tr("The list has what is known of the others.");
  said.about = &m_document->document;
  emit message(said);
}

void CellPaths::plan(const OperationValues& values) {
  const auto scene = m_collisions.scene();
  if (!scene) return reportUnprepared();
  const auto content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot());
  const Result<std::vector<Waypoint>> waypoints = waypointsOf(values, *scene, *content);
  if (!waypoints) return report(waypoints.error());
  const std::string name = plans().freePathName(values.isSet("name") ? values.text("name") : tr("Path").toStdString());
  startPlanning(*waypoints, routeSettingsOf(values, plans()), name, tr("Plan %1"), [this, values] { plan(values); });
}

void CellPaths::planAgain() {
  const RobotPath* const present = path();
  if (!present) return;
  const auto again = [this, name = present->name] {
    if (choosePath(name)) planAgain();
  };
  const QString text = tr("Plan %1 again");
  if (present->process) {
    Planning planning = processPlanning(valuesOf(*present->process), nullptr, present->process->part);
    return startPlanning(std::move(planning), {present->name, text, again});
  }
  OperationValues values(planOperation());
  setFidelity(values, m_parts.fidelity.values());
  RouteSettings settings = routeSettingsOf(values, plans());
  settings.plan.check.clearance = plans().clearanceOf(*present);
  startPlanning(
      [path = *present, settings](const CellScene& scene, const RobotCellSnapshot& content, Progress progress) {
        Result<PlannedPath> planned = plannedThrough(scene, *content.plans, path.waypoints, settings, progress);
        if (planned) {  // the lines of its waypoints are in the language of its program
          planned->path.head = path.head;
          planned->path.language = path.language;
        }
        return planned;
      },
      {present->name, text, again});
}

void CellPaths::startPlanning(std::vector<Waypoint> waypoints, const RouteSettings& settings, const std::string& name,
                              const QString& text, std::function<void()> again) {
  startPlanning([waypoints = std::move(waypoints), settings](
                    const CellScene& scene, const RobotCellSnapshot& content,
                    Progress progress) { return plannedThrough(scene, *content.plans, waypoints, settings, progress); },
                {name, text, std::move(again)});
}

void CellPaths::whenPrepared(const std::function<void()>& then) {
  if (m_collisions.scene()) return then();
  const auto goOn = [this, then, document = m_document] {
    if (document == m_document) whenPrepared(then);
  };
  connect(&m_collisions, &CellCollisions::prepared, this, goOn, Qt::SingleShotConnection);
}

// Another document may be in view when the path has been planned: it is put into the cell for which that was asked.
void CellPaths::startPlanning(Planning planning, PlanRequest request) {
  const auto scene = m_collisions.scene();
  if (!scene) {
    if (request.ended) request.ended();
    return reportUnprepared();
  }
  const RobotPath* const present = plans().path(request.name);
  const QString name = QString::fromStdString(request.name);
  const QString title =
      (present ? tr("%1 could not be planned again and was not changed") : tr("%1 could not be planned")).arg(name);
  DocumentTab& tab = *m_document;
  Job job;
  job.name = tr("Planning %1").arg(name);
  job.document = &tab.document;
  job.owner = request.owner;
  job.failed = [this, &tab, ended = request.ended, title](const Error& error) {
    if (ended) ended();
    report(&tab, error, title);
  };
  job.work = [this, &tab, scene, content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot()),
              planning = std::move(planning), before = present ? std::optional(*present) : std::nullopt,
              request = std::move(request), title](Progress progress) -> Job::Finish {
    auto planned = planning(*scene, *content, progress);
    return [this, &tab, scene, content, before, request, title, planned = std::move(planned)]() mutable {
      if (request.ended) request.ended();
      if (!isUnchanged(tab, *scene, *content)) return reportChanged(tab, request.name, request.again);
      if (!planned) return reportHindered(tab, planned.error(), title, request);
      planned->path.name = request.name;
      if (before) {
        planned->path.language = before->language;
        planned->path.head = before->head;
      }
      takePlanned(tab, std::move(planned).value(), before, request.text);
    };
  };
  m_parts.jobs.start(std::move(job));
}

// before: the path of this name when planning began. What was changed by hand since then stays.
void CellPaths::takePlanned(DocumentTab& tab, PlannedPath made, const std::optional<RobotPath>& before,
                            const QString& text) {
  RobotPath& planned = made.path;
  const std::string wanted = planned.name;
  CellPlans changed = *cellIn(tab).plans();
  const auto old = std::find_if(changed.paths.begin(), changed.paths.end(),
                                [&](const RobotPath& each) { return each.name == wanted; });
  const bool wasEdited = old != changed.paths.end() && !(before && *old == *before);
  if (wasEdited) planned.name = changed.freePathName(wanted);
  const QString name = QString::fromStdString(planned.name);
  const int count = static_cast<int>(planned.waypoints.size());
  const PlanTree::Entry entry{PlanTree::Entry::Kind::Path, planned.name};
  if (old == changed.paths.end() || wasEdited)
    changed.paths.push_back(std::move(planned));
  else
    *old = std::move(planned);
  if (!commit(tab, text.arg(name), std::move(changed))) return;
  select(tab, entry);
  if (!wasEdited) {
    QString detail = tr("It has %Ln place(s), and is selected in the list.", nullptr, count);
    if (made.keptLegs > 0) {
      detail += QLatin1Char(' ') + tr("%Ln leg(s) with unchanged ends, still proven free, were kept.", nullptr,
                                      static_cast<int>(made.keptLegs));
    }
    if (made.isJagged) {
      detail +=
          QLatin1Char(' ') + tr("Its curve turns to and fro again and again, as edges of scanned parts do: follow a "
                                "section or a drawn curve, or set a larger tolerance.");
    }
    return reportStored(tab, tr("%1 was planned").arg(name), detail);
  }
  emit message({Message::Weight::Info,
                tr("%1 was changed while it was planned").arg(QString::fromStdString(wanted)),
                tr("Your changes were kept; the planned path is %1.").arg(name),
                {},
                {},
                {},
                {},
                {},
                &tab.document});
}

// again: begins once more.
void CellPaths::reportChanged(DocumentTab& tab, const std::string& path, const std::function<void()>& again) {
  emit message({Message::Weight::Warning,
                tr("The cell was changed while %1 was planned").arg(QString::fromStdString(path)),
                tr("The result is not valid for the cell as it is now, and was discarded."),
                {},
                tr("Plan it again"),
                [this, document = &tab, again] {
                  if (document == m_document) again();
                },
                {},
                {},
                &tab.document});
}

}  // namespace handwheel
