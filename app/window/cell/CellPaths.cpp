// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellPaths.h"

#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "viewport/Viewport.h"
#include "viewport/path/PathPicture.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/OfferedAction.h"
#include "window/cell/CellRobots.h"
#include "window/cell/PathStatus.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileDialogs.h"
#include "window/kinds/KindPanel.h"

#include <QFileDialog>
#include <QLabel>
#include <algorithm>

namespace handwheel {

namespace {

// Gives what collides its look. points: of each sample one.
void markCollisions(const CheckedPath& path, std::vector<PathPoint>& points) {
  const auto& samples = path.metrics.samples;
  const auto& collisions = path.verification.collisions;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const PathSample &from = samples[i - 1], &to = samples[i];
    const double begin = from.motion == to.motion ? from.share : 0.0;
    const auto own = std::ranges::equal_range(collisions, to.motion, {}, &PathCollision::motion);
    const auto meets = [&](const PathCollision& each) { return each.to >= begin && each.from <= to.share; };
    if (std::ranges::any_of(own, meets)) points[i].look = PathLine::Look::Collision;
  }
}

}  // namespace

CellPaths::CellPaths(const WindowContext& parts, CellCollisions& collisions, CellTargets& targets, CellRobots& robots,
                     std::function<BodyPointer()> selected, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_collisions(collisions),
      m_targets(targets),
      m_robots(robots),
      m_selected(std::move(selected)),
      m_tree(new PlanTree(parts.window)),
      m_detail(new QLabel(parts.window)),
      m_layer(std::make_shared<PathLayer>()),
      m_checks(parts, collisions, this),
      m_store(tr("&Store this configuration"), this),
      m_storeTarget(tr("Store a &target here"), this),
      m_storeFrame(tr("Store a &frame here"), this),
      m_workIn(tr("&Work in the frame"), this),
      m_go(tr("&Go to it"), this),
      m_plan(tr("&Plan a path…"), this),
      m_again(tr("Plan the path &again"), this),
      m_insert(tr("&Insert this configuration into the path"), this),
      m_here(tr("Set the place to &here"), this),
      m_up(tr("Move the place &up"), this),
      m_down(tr("Move the place &down"), this),
      m_straight(tr("Straight &line to the place"), this),
      m_verify(tr("&Verify the path"), this),
      m_verifyAll(tr("Verif&y all paths"), this),
      m_export(tr("&Export a robot program…"), this),
      m_import(tr("Open a robot program as a pa&th…"), this),
      m_declareFrame(tr("&Declare the frame in RAPID programs"), this),
      m_semantics(tr("Read allowed pairs (S&RDF)…"), this),
      m_pairs(tr("Allow &pairs to touch…"), this),
      m_rename(tr("Re&name"), this),
      m_remove(tr("Remo&ve from the plan"), this),
      m_optimise(tr("Optimise the order and &configurations"), this),
      m_choose(tr("Plan for this ro&bot"), this),
      m_menu(new QMenu(parts.window)) {
  prepare(m_store, "storeConfiguration", "place", tr("Store the current joint values under a name"));
  prepare(m_storeTarget, "storeTarget", "target",
          tr("Store the current pose of the tool as a target; on the selected body, if any, or in the chosen frame, "
             "with which it moves"));
  prepare(
      m_storeFrame, "storeFrame", nullptr,
      tr("Store the current pose of the tool as a frame for targets and programs; on the selected body, if any, with "
         "which it moves"));
  prepare(m_workIn, "workInFrame", nullptr,
          tr("Show coordinates of targets, and write programs, in the selected frame; once more: in none"));
  m_workIn.setCheckable(true);
  prepare(m_go, "goToConfiguration", nullptr, tr("Move the robot to the selected configuration, place or target"));
  prepare(m_plan, "planPath", "program", tr("Plan a path between configurations that is proven free of collisions"));
  prepare(m_again, "planPathAgain", nullptr,
          tr("Plan the path again through its critical places; one along a curve follows it where the part is now"));
  prepare(m_insert, "insertPlace", nullptr,
          tr("Insert the current joint values after the selected place as a critical configuration; before the goal, "
             "if that or the path is selected"));
  prepare(m_here, "setPlaceHere", nullptr,
          tr("Replace the selected configuration, place, target or frame by the current position of the robot"));
  prepare(m_up, "movePlaceUp", nullptr, tr("Move the selected place towards the start of the path"));
  prepare(m_down, "movePlaceDown", nullptr, tr("Move the selected place towards the end of the path"));
  prepare(m_straight, "straightToPlace", nullptr,
          tr("Move the tool's centre point to the place along a straight line"));
  m_straight.setCheckable(true);
  prepare(m_verify, "verifyPath", "ok",
          tr("Verify that each motion of the selected path is free of collisions, or list all collisions; also if it "
             "was verified before"));
  prepare(m_verifyAll, "verifyAllPaths", nullptr,
          tr("Verify the paths of all robots that are not verified in their current state, each with the other robots "
             "where they are"));
  prepare(m_export, "exportProgram", "save-as",
          tr("Write the path for a controller (RAPID, KRL, Fanuc, URScript, CSV, JSON), if it is free of collisions"));
  prepare(m_import, "importProgram", nullptr, tr("Read a program of a controller as a path of this cell"));
  prepare(m_declareFrame, "declareFrame", nullptr,
          tr("Write the data of the frame (wobjdata) into each RAPID program; two modules of one task must not both "
             "have them"));
  m_declareFrame.setCheckable(true);
  m_declareFrame.setChecked(true);
  prepare(m_semantics, "readSemantics", nullptr,
          tr("Read the pairs of links that may touch, and named states, of the selected robot, or else of the one to "
             "plan for"));
  prepare(m_pairs, "allowPairs", nullptr,
          tr("Choose which of the pairs that meet here, or on the selected path, may touch; or no longer"));
  prepare(m_rename, "renamePlan", nullptr, tr("Give the selected configuration, path, target or frame another name"));
  prepare(m_remove, "removePlan", nullptr,
          tr("Remove the selected configuration, path, place, target, frame or robot"));
  prepare(m_optimise, "optimisePath", nullptr,
          tr("Choose the order of the critical places, and the configurations in which they are reached, that take the "
             "least time"));
  prepare(m_choose, "chooseRobot", nullptr,
          tr("Plan for the selected robot from now on; the others stay where they are"));
  m_menu->setObjectName(QStringLiteral("planMenu"));
  m_menu->addActions(ofRows() + ofConfigurations() + ofPaths() + ofVerification() + ofPrograms() + QList{&m_choose});
  m_detail->setObjectName(QStringLiteral("planDetail"));
  m_detail->setWordWrap(true);
  m_detail->setContentsMargins(12, 4, 8, 4);
  parts.viewport.addLayer(m_layer);
  connectActions();
  update();
}

CellPaths::~CellPaths() {
  m_parts.viewport.removeLayer(*m_layer);
}

void CellPaths::connectActions() {
  connect(&m_store, &QAction::triggered, this, &CellPaths::store);
  connect(&m_storeTarget, &QAction::triggered, this, &CellPaths::storeTarget);
  connect(&m_storeFrame, &QAction::triggered, this, &CellPaths::storeFrame);
  connect(&m_workIn, &QAction::triggered, this, [this] { workIn(m_tree->current().name); });
  connect(&m_go, &QAction::triggered, this, [this] { goTo(m_tree->current()); });
  connect(&m_choose, &QAction::triggered, this, [this] { m_robots.choose(m_tree->current().name); });
  connect(&m_plan, &QAction::triggered, this, &CellPaths::askForPath);
  connect(&m_again, &QAction::triggered, this, &CellPaths::planAgain);
  connect(&m_optimise, &QAction::triggered, this, &CellPaths::optimise);
  connect(&m_insert, &QAction::triggered, this, &CellPaths::insertHere);
  connect(&m_here, &QAction::triggered, this, &CellPaths::setWaypointHere);
  connect(&m_up, &QAction::triggered, this, [this] { moveWaypoint(-1); });
  connect(&m_down, &QAction::triggered, this, [this] { moveWaypoint(1); });
  connect(&m_straight, &QAction::triggered, this, &CellPaths::setStraight);
  connect(&m_verify, &QAction::triggered, this, &CellPaths::verifyAgain);
  connect(&m_verifyAll, &QAction::triggered, this, [this] {
    m_collisions.prepareIfIdle();
    m_checks.verifyAll();
  });
  connect(&m_checks, &PathChecks::verified, this, &CellPaths::reportVerified);
  connect(&m_checks, &PathChecks::allVerified, this, &CellPaths::reportAllVerified);
  connect(&m_checks, &PathChecks::changed, this, [this] {
    update();
    showPath();
  });
  connect(&m_export, &QAction::triggered, this, &CellPaths::requestProgram);
  connect(&m_import, &QAction::triggered, this, [this] {
    QFileDialog* const dialog =
        openingDialog(m_parts.window, m_document->document, tr("Open a robot program"),
                      tr("Robot programs (*.mod *.src *.ls *.script *.csv *.json);;All files (*)"));
    dialog->setObjectName(QStringLiteral("importProgramDialog"));
    connect(dialog, &QFileDialog::fileSelected, this, &CellPaths::importProgram);
    dialog->open();
  });
  connect(&m_semantics, &QAction::triggered, this, [this] {
    QFileDialog* const dialog = openingDialog(m_parts.window, m_document->document, tr("Read allowed pairs"),
                                              tr("Semantic descriptions (*.srdf *.xml);;All files (*)"));
    dialog->setObjectName(QStringLiteral("readSemanticsDialog"));
    connect(dialog, &QFileDialog::fileSelected, this, &CellPaths::readSemantics);
    dialog->open();
  });
  connect(&m_pairs, &QAction::triggered, this, &CellPaths::askForPairs);
  connect(&m_rename, &QAction::triggered, this, [this] {
    showKindPanel(m_parts);
    m_tree->setFocus();
    m_tree->editItem(m_tree->currentItem(), 0);
  });
  connect(&m_remove, &QAction::triggered, this, &CellPaths::removeCurrent);
  connect(m_tree, &PlanTree::currentChanged, this, [this] {
    verify();
    showSelected();
    offerActions();  // not update(): the row would be another one when a double click ends
    showDetail();
    showPath();
    emit rowChanged();
  });
  connect(m_tree, &PlanTree::activated, this, &CellPaths::goTo);
  connect(m_tree, &PlanTree::renameRequested, this, &CellPaths::rename);
  connect(m_tree, &PlanTree::removalRequested, this, &CellPaths::removeCurrent);
  connect(m_tree, &QWidget::customContextMenuRequested, this,
          [this](const QPoint& position) { m_menu->popup(m_tree->viewport()->mapToGlobal(position)); });
  connect(m_detail, &QLabel::linkActivated, this, [this](const QString& link) {
    if (path()) emit collisionChosen(link.toULongLong());
  });
  connect(&m_collisions, &CellCollisions::prepared, this, [this] {
    verify();
    offerActions();
    if (checked() != m_drawn) showPath();  // The results for a path are only shown with the scene
  });
  connect(&m_targets, &CellTargets::reachChanged, this, &CellPaths::update);
}

void CellPaths::setDocument(DocumentTab* document) {
  if (m_document) {
    m_document->document.disconnect(this);
    m_rows[m_document] = m_tree->current();
  }
  m_document = document;
  m_checks.setDocument(document);
  if (document) connect(&document->document, &Document::changed, this, &CellPaths::followDocument);
  followDocument();
  if (const auto before = m_rows.find(document); before != m_rows.end()) m_tree->select(before->second);
}

void CellPaths::forget(const DocumentTab* document) {
  m_checks.forget(document);
  m_rows.erase(document);
  if (const auto wanted = m_wanted.find(document); wanted != m_wanted.end()) m_parts.jobs.cancelOf(&wanted->second);
  m_wanted.erase(document);
}

void CellPaths::setVisible(bool isVisible) {
  m_layer->setVisible(isVisible);
}

RobotCellDocument& CellPaths::cellIn(DocumentTab& tab) {
  return static_cast<RobotCellDocument&>(tab.document);
}

bool CellPaths::isUnchanged(DocumentTab& tab, const CellScene& scene, const RobotCellSnapshot& before) {
  const auto now = std::static_pointer_cast<const RobotCellSnapshot>(tab.document.snapshot());
  return scene.holdsFor(*now, *before.plans);
}

RobotCellDocument& CellPaths::cell() const {
  return cellIn(*m_document);
}

const JointValues& CellPaths::seenJoints(const RobotCellDocument& of) const {
  const JointValues& standing = of.joints();
  return m_shownJoints && m_shownJoints->size() == standing.size() ? *m_shownJoints : standing;
}

CellPlacement CellPaths::seenPlacement() const {
  const CellPlacement standing = cell().placement();
  return {standing.plans, standing.bodies, standing.robot, seenJoints()};
}

const CellPlans& CellPaths::plans() const {
  static const CellPlans kNothing;
  return m_document ? *cell().plans() : kNothing;
}

const NamedTarget* CellPaths::target() const {
  const PlanTree::Entry entry = m_tree->current();
  return entry.kind == PlanTree::Entry::Kind::Target ? plans().target(entry.name) : nullptr;
}

const NamedFrame* CellPaths::frame() const {
  const PlanTree::Entry entry = m_tree->current();
  return entry.kind == PlanTree::Entry::Kind::Frame ? plans().frame(entry.name) : nullptr;
}

const RobotPath* CellPaths::path() const {
  const PlanTree::Entry entry = m_tree->current();
  const bool isOfPath = entry.kind == PlanTree::Entry::Kind::Path || entry.kind == PlanTree::Entry::Kind::Waypoint;
  const RobotPath* const found = isOfPath                    ? plans().path(entry.name)
                                 : plans().paths.size() == 1 ? &plans().paths.front()
                                                             : nullptr;
  return found && isSameArm(cell().robot(), found->arm, plans().arm) ? found : nullptr;
}

std::shared_ptr<const CheckedPath> CellPaths::checked() const {
  const RobotPath* const present = path();
  return present && scene() ? m_checks.of(*present) : nullptr;
}

void CellPaths::followDocument() {
  verify();
  update();
  showPath();
}

// If several paths are requested one after the other only the last is verified: the others are when they become
// the present path again.
void CellPaths::verify() {
  const RobotPath* const present = path();
  if (present && scene() && present->waypoints.size() >= 2) m_checks.verify(*present);
}

// Shows the path of the tool centre point: straight lines of the tool solid, other motions to a waypoint as travel, and
// collisions in another colour.
void CellPaths::showPath() {
  const auto known = checked();
  const auto scene = m_collisions.scene();
  std::vector<PathPoint> points;
  if (known && scene) {
    const RobotPath& present = *path();
    for (const PathSample& sample : known->metrics.samples) {
      const Vec3 at = (scene->arm.tipPose(sample.values) * plans().tool).translation();
      const std::size_t leg = known->resolved.waypointOf.empty() ? 0 : known->waypointOf(sample.motion);
      const bool isLine = present.waypoints[leg].motion == ProgramMotion::Kind::Linear;
      points.push_back({at, leg, isLine ? PathLine::Look::Feed : PathLine::Look::Travel});
    }
    markCollisions(*known, points);
  }
  auto lines = std::make_shared<const std::vector<PathLine>>(pathPicture(points));
  m_layer->setLines(lines->empty() ? nullptr : lines);
  m_drawn = known;
  emit pathChanged();
}

void CellPaths::update() {
  std::map<std::string, PathStatus> statuses;
  for (const RobotPath& each : plans().paths)
    statuses[each.name] = pathStatusOf(m_checks.stateOf(each), each, cell().displayUnit(), QLocale());
  m_tree->setPlans(plans(), m_document ? &cell().robot() : nullptr, statuses, m_targets.reach(), frameRemarks());
  showSelected();  // it may have another name
  offerActions();
  showDetail();
}

void CellPaths::showSelected() {
  m_targets.setSelected(target() ? target()->name : std::string(), frame() ? frame()->name : std::string());
}

// The list has room for a few words only.
void CellPaths::showDetail() {
  using Kind = PlanTree::Entry::Kind;
  const PlanTree::Entry entry = m_tree->current();
  QString text;
  bool hasLinks = false;
  const RobotPath* const of =
      entry.kind == Kind::Path || entry.kind == Kind::Waypoint ? plans().path(entry.name) : nullptr;
  if (of) {
    const PathStatus status = pathStatusOf(m_checks.stateOf(*of), *of, cell().displayUnit(), QLocale());
    hasLinks = of == path() && !status.collisions.empty();
    text = status.isFree ? status.summary : hasLinks ? linkedDetails(status) : status.details;
  } else if (const auto reach = m_targets.reach().find(entry.name);
             entry.kind == Kind::Target && reach != m_targets.reach().end()) {
    text = reach->second.remark;
  } else if (const auto remarks = frameRemarks(); entry.kind == Kind::Frame && remarks.contains(entry.name)) {
    text = remarks.at(entry.name);
  }
  m_detail->setTextFormat(hasLinks ? Qt::RichText : Qt::PlainText);
  m_detail->setTextInteractionFlags(hasLinks ? Qt::TextBrowserInteraction : Qt::TextSelectableByMouse);
  m_detail->setText(text);
  m_detail->setVisible(!text.isEmpty());
}

void CellPaths::offerActions() {
  using Kind = PlanTree::Entry::Kind;
  const PlanTree::Entry entry = m_tree->current();
  const bool isCell = m_document != nullptr, isSomething = entry.kind != Kind::None;
  const bool isWaypoint = entry.kind == Kind::Waypoint;
  const RobotPath* const present = path();
  const bool isOfOther = !present && (isWaypoint || entry.kind == Kind::Path);
  const QString noCell = tr("Open a robot cell first."), noWaypoint = tr("Select a place of a path first."),
                noPath = isOfOther ? tr("Choose the robot of the path first.") : tr("Select a path first.");
  offer(m_store, isCell, noCell);
  offer(m_storeTarget, isCell, noCell);
  offer(m_storeFrame, isCell, noCell);
  const bool hasEnds = !plans().configurations.empty() || !plans().targets.empty();
  offer(m_plan, isCell && hasEnds,
        isCell ? tr("Store a configuration or a target first: where the path is to begin or end.") : noCell);
  const bool isTarget = entry.kind == Kind::Target, isFrame = entry.kind == Kind::Frame;
  offer(m_workIn, isFrame, tr("Select a frame in the list first."));
  m_workIn.setChecked(isFrame && entry.name == plans().workFrame);
  offer(m_go, entry.kind == Kind::Configuration || isWaypoint || isTarget,
        tr("Select a configuration, a place or a target first."));
  offer(m_choose, entry.kind == Kind::Robot, tr("Select a robot in the list first, in a cell with several."));
  offer(m_again, present && present->waypoints.size() >= 2, noPath);
  offer(m_optimise, present && present->waypoints.size() >= 3,
        present ? tr("There is nothing between the ends of the path.") : noPath);
  offer(m_insert, present != nullptr, noPath);
  offer(m_here, isWaypoint || isTarget || isFrame || entry.kind == Kind::Configuration,
        tr("Select a configuration, a place of a path, a target or a frame first."));
  offer(m_up, isWaypoint && entry.waypoint > 0, noWaypoint);
  offer(m_down, isWaypoint && present && entry.waypoint + 1 < present->waypoints.size(), noWaypoint);
  offer(m_straight, isWaypoint && entry.waypoint > 0, noWaypoint);
  m_straight.setChecked(isWaypoint && present && entry.waypoint < present->waypoints.size() &&
                        present->waypoints[entry.waypoint].motion == ProgramMotion::Kind::Linear);
  offer(m_verify, present && present->waypoints.size() >= 2, noPath);
  offer(m_verifyAll, !plans().paths.empty(), isCell ? tr("The cell has no path yet.") : noCell);
  const auto known = checked();
  const bool isUnderWay = present && m_checks.stateOf(*present).isUnderWay;
  // An unverified path is verified first, with a question.
  offer(m_export, known ? known->isProvenAsWritten() : present && !isUnderWay && present->waypoints.size() >= 2,
        !present     ? noPath
        : isUnderWay ? tr("The path is being verified.")
                     : tr("Only a path that is proven free of collisions is exported."));
  offer(m_import, isCell, noCell);
  offer(m_semantics, isCell, noCell);
  offer(m_pairs, isCell, noCell);
  offer(m_rename, entry.kind == Kind::Configuration || entry.kind == Kind::Path || isTarget || isFrame,
        tr("Select a configuration, a path, a target or a frame first."));
  offer(m_remove, isSomething, tr("Select a configuration, a path, a place, a target, a frame or a robot first."));
}

}  // namespace handwheel
