// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Changes of the document by the actions for paths.
#include "document/FileBytes.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/cell/PlansEdit.h"
#include "document/cell/RobotCellDocument.h"
#include "document/cell/WaypointProperties.h"
#include "document/cell/path/OutdatedReasons.h"
#include "document/scene/BodyChanges.h"
#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "tools/cell/ConfigurationOperation.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/cell/CellRobots.h"
#include "window/documents/DiscardedResult.h"
#include "window/documents/DocumentTab.h"

#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace handwheel {

namespace {

using Kind = PlanTree::Entry::Kind;

RobotPath* pathOf(CellPlans& plans, const std::string& name) {
  const auto found =
      std::find_if(plans.paths.begin(), plans.paths.end(), [&](const RobotPath& path) { return path.name == name; });
  return found == plans.paths.end() ? nullptr : &*found;
}

// Returns the path whose waypoints the user edits: it is no longer planned along a curve, so that planning it again
// keeps them.
RobotPath* pathByHand(CellPlans& plans, const std::string& name) {
  RobotPath* const path = pathOf(plans, name);
  if (path) path->process.reset();
  return path;
}

}  // namespace

void CellPaths::report(const DocumentTab* tab, const Error& error, const QString& title) {
  if (error.code == ErrorCode::Cancelled) return;
  emit message({Message::Weight::Error,
                title,
                errorSentence(error),
                errorAdvice(error),
                {},
                {},
                {},
                {},
                tab ? &tab->document : nullptr});
}

void CellPaths::reportUnprepared() {
  m_collisions.prepareIfIdle();
  emit message({Message::Weight::Info,
                tr("The cell is still being prepared"),
                tr("Try again in a moment."),
                {},
                {},
                {},
                {},
                {},
                &m_document->document});
}

bool CellPaths::commit(DocumentTab& tab, const QString& text, CellPlans plans) {
  if (const Status fits = checkCounts(plans); !fits) {
    report(&tab, fits.error());
    return false;
  }
  RobotCellDocument& document = cellIn(tab);
  if (auto edit = document.plansEdit(std::move(plans))) document.commit(text, std::move(edit));
  return true;
}

void CellPaths::select(const DocumentTab& tab, const PlanTree::Entry& entry) {
  if (&tab == m_document) m_tree->select(entry);
}

void CellPaths::store() {
  m_document->document.settle();  // the hand may lead the robot
  CellPlans changed = plans();
  const std::string preferred = tr("Configuration %1").arg(changed.configurations.size() + 1).toStdString();
  const std::string name = changed.freePoseName(preferred);
  changed.configurations.push_back({name, seenJoints(), changed.arm});
  if (!commit(tr("Store %1").arg(QString::fromStdString(name)), std::move(changed))) return;
  m_tree->select({Kind::Configuration, name});
  reportStored(*m_document, tr("%1 was stored").arg(QString::fromStdString(name)), tr("It is selected in the list."),
               PlanTree::Entry{Kind::Configuration, name});
}

// Also while a tool is used, when nobody looks at the list.
void CellPaths::reportStored(const DocumentTab& tab, const QString& title, const QString& detail,
                             std::optional<PlanTree::Entry> named) {
  m_parts.log.add(title);
  Message said{Message::Weight::Info, title, detail};
  if (named) {
    said.actionText = tr("&Rename");
    said.action = [this, named, document = &tab] {
      if (document != m_document) return;
      m_tree->select(*named);
      m_rename.trigger();
    };
  }
  said.about = &tab.document;
  emit message(said);
}

// On the selected body it moves with that, or else with the chosen frame, unless the robot itself moves it.
void CellPaths::storeTarget() {
  m_document->document.settle();  // the hand may lead the robot
  CellPlans changed = plans();
  const std::string preferred = tr("Target %1").arg(changed.targets.size() + 1).toStdString();
  NamedTarget target{.name = changed.freePoseName(preferred)};
  const RobotModel& robot = cell().robot().model;
  target.pose = toolPose(cell().robot(), changed, seenJoints());
  const BodyPointer body = bodyForTargets();
  const NamedFrame* const work = changed.frame(changed.workFrame);
  const bool isStill = work && !movesWith(*work, cell().bodies(), robot,
                                          dofsOfArm(cell().robot(), activeArmNumber(cell().robot(), changed)));
  const Result<NamedTarget> inFrame = targetInFrame(target, changed.workFrame, seenPlacement());
  if (body)
    target = onBody(std::move(target), *body, robot, seenJoints());
  else if (isStill && inFrame)
    target = *inFrame;
  const PlanTree::Entry entry{Kind::Target, target.name};
  const QString name = QString::fromStdString(target.name), frame = QString::fromStdString(target.frame);
  changed.targets.push_back(std::move(target));
  const QString text = body               ? tr("Store %1 on %2").arg(name, QString::fromStdString(body->name))
                       : !frame.isEmpty() ? tr("Store %1 in %2").arg(name, frame)
                                          : tr("Store %1").arg(name);
  if (!commit(text, std::move(changed))) return;
  m_tree->select(entry);
  reportStored(*m_document, tr("%1 was stored").arg(name),
               body               ? tr("It moves with %1.").arg(QString::fromStdString(body->name))
               : !frame.isEmpty() ? tr("It moves with %1.").arg(frame)
                                  : tr("It is selected in the list."),
               entry);
}

// It stays on its body, and in its frame.
void CellPaths::setTargetHere(const std::string& name) {
  CellPlans changed = plans();
  const auto target = std::find_if(changed.targets.begin(), changed.targets.end(),
                                   [&](const NamedTarget& each) { return each.name == name; });
  if (target == changed.targets.end()) return;
  *target = targetAt(*target, toolPose(cell().robot(), changed, seenJoints()), seenPlacement());
  commit(tr("Set %1").arg(QString::fromStdString(name)), std::move(changed));
}

// Paths through it lead to where it was, and are outdated.
void CellPaths::setConfigurationHere(const std::string& name) {
  CellPlans changed = plans();
  const auto stored = std::find_if(changed.configurations.begin(), changed.configurations.end(),
                                   [&](const NamedConfiguration& each) { return each.name == name; });
  if (stored == changed.configurations.end()) return;
  stored->joints = seenJoints();
  commit(tr("Set %1").arg(QString::fromStdString(name)), std::move(changed));
}

void CellPaths::goToTarget(const std::string& name) {
  const auto scene = m_collisions.scene();
  if (!scene) return reportUnprepared();
  const auto content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot());
  const Result<Waypoint> waypoint = waypointCalled(*scene, *content, name, cell().joints());
  if (!waypoint) return report(waypoint.error());
  if (auto edit = cell().jointEdit(waypoint->joints))
    cell().commit(tr("Go to %1").arg(QString::fromStdString(name)), std::move(edit));
  emit robotSent();
}

void CellPaths::goTo(const PlanTree::Entry& entry) {
  if (entry.kind == Kind::Robot) return m_robots.choose(entry.name);
  if (entry.kind == Kind::Frame) return workIn(entry.name);
  if (entry.kind == Kind::Target && plans().target(entry.name)) return goToTarget(entry.name);
  const NamedConfiguration* const configuration =
      entry.kind == Kind::Configuration ? plans().configuration(entry.name) : nullptr;
  const RobotPath* const of = entry.kind == Kind::Waypoint ? plans().path(entry.name) : nullptr;
  const bool isWaypoint = of && entry.waypoint < of->waypoints.size();
  if (!configuration && !isWaypoint) return;
  const JointValues& set = configuration ? configuration->joints : of->waypoints[entry.waypoint].joints;
  const std::string& arm = configuration ? configuration->arm : of->arm;
  auto edit = cell().jointEdit(jointsSetBy(cell().robot(), arm, set, cell().joints()));
  const QString name = QString::fromStdString(entry.name);
  const QString text =
      configuration ? tr("Go to %1").arg(name) : tr("Go to place %1 of %2").arg(entry.waypoint + 1).arg(name);
  if (edit) cell().commit(text, std::move(edit));
  emit robotSent();
}

// Inserts before the goal, unless an earlier waypoint is selected: the path still ends at its goal.
void CellPaths::insertHere() {
  m_document->document.settle();
  const PlanTree::Entry entry = m_tree->current();
  const RobotPath* const present = path();
  if (!present) return;
  const std::size_t count = present->waypoints.size();
  const std::size_t goal = count < 2 ? count : count - 1;
  insertAt(entry.kind == Kind::Waypoint ? std::min(entry.waypoint + 1, goal) : goal);
}

void CellPaths::insertAt(std::size_t behind) {
  CellPlans changed = plans();
  RobotPath& of = *pathByHand(changed, path()->name);
  Waypoint waypoint{.joints = seenJoints()};
  if (behind > 0)
    waypoint.speed =
        of.waypoints[behind - 1].motion == waypoint.motion ? of.waypoints[behind - 1].speed : waypoint.speed;
  of.waypoints.insert(of.waypoints.begin() + static_cast<std::ptrdiff_t>(behind), std::move(waypoint));
  const PlanTree::Entry inserted{Kind::Waypoint, of.name, behind};
  const QString name = QString::fromStdString(of.name);
  const std::size_t count = of.waypoints.size();
  if (!commit(tr("Insert a place into %1").arg(name), std::move(changed))) return;
  m_tree->select(inserted);
  reportStored(*m_document, tr("Place %1 of %2 was stored").arg(behind + 1).arg(name),
               tr("The path has %Ln place(s) now.", nullptr, static_cast<int>(count)));
}

void CellPaths::addWaypoint() {
  m_document->document.settle();  // the hand may lead the robot
  const PlanTree::Entry chosen = m_tree->current();
  if (chosen.kind == Kind::Path || chosen.kind == Kind::Waypoint) {
    const RobotPath* const present = path();
    if (!present) return;
    const std::size_t count = present->waypoints.size();
    return insertAt(chosen.kind == Kind::Waypoint ? std::min(chosen.waypoint + 1, count) : count);
  }
  CellPlans changed = plans();
  RobotPath begun{changed.freePathName(tr("Path").toStdString()), {{.joints = cell().joints()}}, changed.arm};
  const PlanTree::Entry first{Kind::Waypoint, begun.name, 0};
  const QString name = QString::fromStdString(begun.name);
  changed.paths.push_back(std::move(begun));
  if (!commit(tr("Begin a path"), std::move(changed))) return;
  m_tree->select(first);
  reportStored(*m_document, tr("Place 1 of %1 was stored").arg(name),
               tr("The next places that are stored continue the path."));
}

void CellPaths::setWaypointHere() {
  m_document->document.settle();
  const PlanTree::Entry entry = m_tree->current();
  if (entry.kind == Kind::Configuration) return setConfigurationHere(entry.name);
  if (entry.kind == Kind::Target) return setTargetHere(entry.name);
  if (entry.kind == Kind::Frame) return setFrameHere(entry.name);
  CellPlans changed = plans();
  RobotPath* const of = pathByHand(changed, entry.name);
  if (entry.kind != Kind::Waypoint || !of || entry.waypoint >= of->waypoints.size()) return;
  Waypoint& waypoint = of->waypoints[entry.waypoint];
  waypoint.joints = seenJoints();
  waypoint.isCritical = true;
  waypoint.target.reset();
  waypoint.frame.reset();
  waypoint.configuration.clear();
  commit(tr("Set place %1 of %2").arg(entry.waypoint + 1).arg(QString::fromStdString(entry.name)), std::move(changed));
}

void CellPaths::moveWaypoint(int by) {
  const PlanTree::Entry entry = m_tree->current();
  CellPlans changed = plans();
  RobotPath* const of = pathByHand(changed, entry.name);
  const std::size_t to = entry.waypoint + static_cast<std::size_t>(by);  // below 0: larger than all
  if (entry.kind != Kind::Waypoint || !of || std::max(entry.waypoint, to) >= of->waypoints.size()) return;
  std::swap(of->waypoints[entry.waypoint], of->waypoints[to]);
  commit(tr("Move place %1 of %2").arg(entry.waypoint + 1).arg(QString::fromStdString(entry.name)), std::move(changed));
  m_tree->select({Kind::Waypoint, entry.name, to});
}

void CellPaths::setStraight(bool isStraight) {
  const PlanTree::Entry entry = m_tree->current();
  CellPlans changed = plans();
  RobotPath* const of = pathByHand(changed, entry.name);
  if (entry.kind != Kind::Waypoint || !of || entry.waypoint >= of->waypoints.size()) return;
  setMotion(*of, entry.waypoint, isStraight ? ProgramMotion::Kind::Linear : ProgramMotion::Kind::Joint);
  commit(isStraight ? tr("Straight line to place %1").arg(entry.waypoint + 1)
                    : tr("Joint motion to place %1").arg(entry.waypoint + 1),
         std::move(changed));
}

void CellPaths::removeCurrent() {
  const PlanTree::Entry entry = m_tree->current();
  CellPlans changed = plans();
  const QString name = QString::fromStdString(entry.name);
  if (entry.kind == Kind::Robot) return m_robots.remove(entry.name);
  if (entry.kind == Kind::Configuration) {
    std::erase_if(changed.configurations, [&](const NamedConfiguration& each) { return each.name == entry.name; });
    const std::vector<std::string> paths = pathsThrough(changed, entry.name);
    if (commit(tr("Remove %1").arg(name), std::move(changed)) && !paths.empty()) reportRemoved(name, paths);
  } else if (entry.kind == Kind::Target) {
    commit(tr("Remove %1").arg(name), withoutTarget(std::move(changed), entry.name));
  } else if (entry.kind == Kind::Frame) {
    commit(tr("Remove %1").arg(name), withoutFrame(entry.name, cell().placement()));
  } else if (entry.kind == Kind::Path) {
    std::erase_if(changed.paths, [&](const RobotPath& each) { return each.name == entry.name; });
    commit(tr("Remove %1").arg(name), std::move(changed));
  } else if (RobotPath* const of = pathByHand(changed, entry.name);
             entry.kind == Kind::Waypoint && of && entry.waypoint < of->waypoints.size()) {
    removeWaypoint(*of, entry.waypoint);
    commit(tr("Remove place %1 of %2").arg(entry.waypoint + 1).arg(name), std::move(changed));
  }
}

// Its paths go on leading to where it was.
void CellPaths::reportRemoved(const QString& configuration, const std::vector<std::string>& paths) {
  constexpr std::size_t kMostNamed = 5;
  QStringList names;
  for (const std::string& path : paths) {
    if (names.size() == kMostNamed) {
      names += QStringLiteral("…");
      break;
    }
    names += QString::fromStdString(path);
  }
  Message said{.weight = Message::Weight::Warning,
               .title = tr("%1 was removed").arg(configuration),
               .detail = tr("%Ln path(s) keep its joint values: %1.", nullptr, static_cast<int>(paths.size()))
                             .arg(names.join(QStringLiteral(", "))),
               .advice = tr("Undo brings it back.")};
  said.about = &m_document->document;
  emit message(said);
}

void CellPaths::rename(const PlanTree::Entry& entry, const QString& name) {
  CellPlans changed = plans();
  const std::string wanted = name.toStdString();
  const bool isWaypoint = entry.kind == Kind::Configuration || entry.kind == Kind::Target;
  const bool isTaken = isWaypoint                  ? changed.configuration(wanted) || changed.target(wanted)
                       : entry.kind == Kind::Frame ? changed.frame(wanted) != nullptr
                                                   : changed.path(wanted) != nullptr;
  if (wanted == entry.name || isTaken || !isBodyName(wanted)) return update();
  if (entry.kind == Kind::Configuration) {
    changed = withConfigurationRenamed(std::move(changed), entry.name, wanted);
  } else if (entry.kind == Kind::Target) {
    changed = withTargetRenamed(std::move(changed), entry.name, wanted);
  } else if (entry.kind == Kind::Frame) {
    changed = withFrameRenamed(std::move(changed), entry.name, wanted);
  } else if (RobotPath* const of = pathOf(changed, entry.name)) {
    of->name = wanted;
  }
  commit(tr("Rename %1").arg(QString::fromStdString(entry.name)), std::move(changed));
  if (entry.kind == Kind::Path) m_checks.renamed(entry.name, wanted);
  m_tree->select({entry.kind, wanted});
}

// Reads for the selected robot, or else the one that is planned for.
void CellPaths::readSemantics(const QString& file) {
  const CellRobot& robots = cell().robot();
  const PlanTree::Entry entry = m_tree->current();
  const std::size_t arm =
      entry.kind == Kind::Robot ? armNumber(robots, entry.name).value_or(0) : activeArmNumber(robots, plans());
  const QString title = QFileInfo(file).fileName(), robot = QString::fromStdString(robots.arms[arm].name);
  DocumentTab& tab = *m_document;
  Job job;
  job.name = tr("Reading %1").arg(title);
  job.document = &tab.document;
  job.failed = [this, &tab, name = QFile::encodeName(file).toStdString()](Error error) {
    error.subject = name;
    report(&tab, error);
  };
  job.work = [this, &tab, content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot()), arm, file,
              title, robot, name = job.name, failed = job.failed](Progress progress) -> Job::Finish {
    const Result<std::string> bytes = readFileHead(QFile::encodeName(file).toStdString(), kLargestSrdf + 1);
    const CellRobot& all = *content->robot;
    Result<RobotSemantics> read =
        bytes ? readSrdf(*bytes, all.model, all.arms, arm, progress) : Result<RobotSemantics>(bytes.error());
    return [this, &tab, content, title, robot, name, failed, read = std::move(read)] {
      if (content->robot.get() != &cellIn(tab).robot()) return emit message(discardedResultMessage(name, tab.document));
      if (!read) return failed(read.error());
      Result<CellPlans> changed = withSemantics(*cellIn(tab).plans(), *read, *content);
      if (!changed) return failed(changed.error());
      commit(tab, tr("Read %1 for %2").arg(title, robot), std::move(changed).value());
      reportSemantics(tab, *read, title, robot);
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellPaths::reportSemantics(const DocumentTab& tab, const RobotSemantics& read, const QString& file,
                                const QString& robot) {
  QString detail = tr("%Ln pair(s) of links that may touch", nullptr, static_cast<int>(read.allowed.size())) +
                   QStringLiteral(", ") + tr("%Ln named state(s).", nullptr, static_cast<int>(read.states.size()));
  if (!read.damage.empty()) {
    detail += QLatin1Char(' ') +
              tr("%Ln entry(ies) name links or joints that the robot does not have, and were left out; see the log.",
                 nullptr, static_cast<int>(read.damage.size()));
  }
  for (const Error& each : read.damage) m_parts.log.add(errorSentence(each), {}, LogEntry::Weight::Warning);
  emit message({read.damage.empty() ? Message::Weight::Info : Message::Weight::Warning,
                tr("%1 was read for %2").arg(file, robot),
                detail,
                read.allowed.empty() && read.states.empty()
                    ? tr("Select the robot that the file describes, and read it again.")
                    : QString(),
                {},
                {},
                {},
                {},
                &tab.document});
}

}  // namespace handwheel
