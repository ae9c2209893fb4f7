// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The action that lets pairs of links and bodies touch.
#include "document/cell/CellErrors.h"
#include "document/cell/RobotCellDocument.h"
#include "text/ErrorText.h"
#include "tools/scene/BodyOperation.h"
#include "window/cell/CellPaths.h"
#include "window/cell/pairs/PairsDialog.h"
#include "window/documents/DocumentTab.h"

#include <algorithm>

namespace handwheel {

namespace {

// Returns true if a tool is meant to work on a body: a path leads along it, or a target is on it. part: the part of a
// path that is not yet in the plans; empty: none.
bool isWorkedOn(const Body& body, const std::string& part, const CellPlans& plans, const BodySet& bodies) {
  const auto isPart = [&](const std::string& text) {
    const Result<BodyPointer> called = bodyCalled(bodies, text);
    return called && (*called)->id == body.id;
  };
  const auto leadsAlong = [&](const RobotPath& path) {
    if (!path.process) return false;
    const OperationValues values = valuesOf(*path.process);
    return values.isSet("part") && isPart(values.text("part"));
  };
  const auto isOn = [&](const NamedTarget& target) { return target.body == body.id; };
  return isPart(part) || std::any_of(plans.paths.begin(), plans.paths.end(), leadsAlong) ||
         std::any_of(plans.targets.begin(), plans.targets.end(), isOn);
}

// Returns the row of a waypoint that an error about a path names, to which the robot can be sent to show the collision;
// nothing if there is no such row, as for the present configuration or a point of a curve.
std::optional<PlanTree::Entry> rowOfWaypoint(const std::string& waypoint, const std::string& path,
                                             const CellPlans& plans) {
  if (plans.configuration(waypoint)) return PlanTree::Entry{PlanTree::Entry::Kind::Configuration, waypoint};
  const RobotPath* const of = plans.path(path);
  for (std::size_t i = 0; of && !of->process && i < of->waypoints.size(); ++i) {
    if (nameOfWaypoint(of->waypoints[i], i) == waypoint)
      return PlanTree::Entry{PlanTree::Entry::Kind::Waypoint, path, i};
  }
  return std::nullopt;
}

}  // namespace

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

// Only bodies, as a tool and its part, are meant to touch; a link that meets something, or a tool that meets what
// stands around, is none to allow in passing.
void CellPaths::reportHindered(DocumentTab& tab, const Error& error, const QString& title, const PlanRequest& request) {
  const std::vector<std::string>& named = error.arguments;
  const bool isMet = error.code == CellError::WaypointCollides || error.code == CellError::LineCollides;
  const bool isNear = error.code == CellError::WaypointTooNear || error.code == CellError::LineTooNear;
  const bool isOnCurve = error.code == CellError::TrackBlocked;
  const std::size_t at = isOnCurve ? 5 : 1;  // Position of the two names in the error
  const RobotCellDocument& edited = cellIn(tab);
  const BodySet& bodies = edited.bodies();
  auto pair = (isMet || isOnCurve) && named.size() >= at + 2
                  ? bodiesCalled(named[at], named[at + 1], bodies, edited.robot().model)
                  : std::nullopt;
  if (pair && !isWorkedOn(*bodies.withName(named[at]), request.part, *edited.plans(), bodies) &&
      !isWorkedOn(*bodies.withName(named[at + 1]), request.part, *edited.plans(), bodies))
    pair.reset();
  const auto row =
      (isMet || isNear) && !named.empty() ? rowOfWaypoint(named.front(), request.name, *edited.plans()) : std::nullopt;
  if (!pair && !row) return report(&tab, error, title);
  Message said{
      .weight = Message::Weight::Error, .title = title, .detail = errorSentence(error), .advice = errorAdvice(error)};
  const auto let = [this, pair, again = request.again, document = &tab] {
    if (document != m_document) return;
    CellPlans changed = plans();
    setAllowed(changed, *pair, true);
    if (commit(tr("Change the pairs that may touch"), std::move(changed)) && again) whenPrepared(again);
  };
  const auto go = [this, row, document = &tab] {
    if (document == m_document) goTo(*row);
  };
  const QString goText = !row ? QString()
                         : row->kind == PlanTree::Entry::Kind::Waypoint
                             ? tr("&Go to place %1").arg(row->waypoint + 1)
                             : tr("&Go to %1").arg(QString::fromStdString(row->name));
  if (pair) {
    said.actionText =
        tr("&Let %1 touch %2").arg(QString::fromStdString(named[at]), QString::fromStdString(named[at + 1]));
    said.action = let;
    said.otherText = goText;
    if (row) said.other = go;
  } else {
    said.actionText = goText;
    said.action = go;
  }
  said.about = &tab.document;
  emit message(said);
}

}  // namespace handwheel
