// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/RobotCellUi.h"

#include "controls/ScrolledPanel.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellImport.h"
#include "document/cell/CellProperties.h"
#include "document/cell/RobotCellDocument.h"
#include "document/cell/RobotCellKind.h"
#include "document/cell/WaypointProperties.h"
#include "document/cell/path/RateProperties.h"
#include "document/scene/BodyDisplay.h"
#include "document/scene/BodyProperties.h"
#include "fidelity/Cases.h"
#include "panels/bodies/BodyList.h"
#include "theme/Icons.h"
#include "theme/Theme.h"
#include "tools/cell/BodyPlacing.h"
#include "viewport/Viewport.h"
#include "viewport/surface/PartsLayer.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/cell/BodyVisibility.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/tools/ToolHost.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace handwheel {

RobotCellUi::RobotCellUi(const WindowContext& window, RobotCellKind& kind)
    : RigidPartsUi(window, {}),
      m_bodies(window, this),
      m_collisions(window, this),
      m_contacts(new CellContactMarks(window, this)),
      m_targets(window, m_collisions, this),
      m_robots(
          window, [this] { return selectedRobot(); }, this),
      m_reach(window, m_collisions, this),
      m_toolCamera(window, this),
      m_paths(
          window, m_collisions, m_targets, m_robots, [this] { return m_bodies.selected(); }, this),
      m_pathDock(window, m_paths, this),
      m_proximity(window, m_collisions, this),
      m_surfaces(window.jobs, this),
      m_guides(window.jobs, m_collisions, this),
      m_panel(makePanel()) {
  const auto follow = [&kind, &choice = window.fidelity] {
    kind.setShapeSides(static_cast<std::uint32_t>(choice.values().of(shapeSidesSetting())));
  };
  connect(&window.fidelity, &FidelityChoice::changed, this, follow);
  follow();
  connect(&m_bodies, &CellBodies::message, this, &RobotCellUi::say);
  connect(&m_paths, &CellPaths::message, this, &RobotCellUi::say);
  connect(&m_robots, &CellRobots::message, this, &RobotCellUi::say);
  connect(&m_robots, &CellRobots::added, this, &RobotCellUi::showRobots);
  connect(&m_pathDock, &PathDock::partsShown, this, &RobotCellUi::showReplay);
  connect(&m_collisions, &CellCollisions::prepared, this, [this, &tools = window.tools] {
    show();
    tools.refresh();
  });
  connect(&m_paths, &CellPaths::rowChanged, this, [this] { followRow(m_paths.tree()->hasFocus()); });
  connect(&m_paths, &CellPaths::pathChanged, this, [this] {
    if (m_showsRow && this->document()) refreshPanel();
  });
  // Also one that was selected before.
  connect(m_paths.tree(), &QTreeWidget::itemClicked, this, [this] { followRow(true); });
  connect(&m_bodies, &CellBodies::selectionChanged, this, [this, &tools = window.tools] {
    m_showsRow = m_bodies.selection().empty();
    markSelected(false);
    refreshPanel();
    tools.refresh();
  });
  connect(&m_bodies, &CellBodies::chosen, this, [this](BodyId body) { reveal(body, false); });
  connect(&m_bodies, &CellBodies::added, this, [this](BodyId body, bool) { reveal(body, true); });
  connect(&m_surfaces, &PartSurfaces::prepared, this, [&tools = window.tools] { tools.refresh(); });
  connect(&m_guides, &PathGuides::prepared, this, [&tools = window.tools] { tools.refresh(); });
  connect(&window.viewport, &Viewport::clicked, this, &RobotCellUi::select);
  constexpr int kFieldsMs = 100;  // a path is played with many more pictures a second than numbers can be read
  m_replayFields.setSingleShot(true);
  m_replayFields.setInterval(kFieldsMs);
  connect(&m_replayFields, &QTimer::timeout, this, [this] { refreshPanel(); });
  m_clock.start();
}

// The list of the bodies, and below it the fields of the selected one or the joints.
QWidget* RobotCellUi::makePanel() {
  auto* bodies = new QWidget(parts().window);
  auto* heading = new QLabel(tr("Bodies"), bodies);
  heading->setProperty("strong", true);
  auto* adding = new QMenu(bodies);
  adding->addActions(m_bodies.adding());
  auto* add = new QToolButton(bodies);
  add->setObjectName(QStringLiteral("addBodyButton"));
  add->setText(tr("Add"));
  add->setIcon(icon(QStringLiteral("add-mesh")));
  add->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  add->setPopupMode(QToolButton::InstantPopup);
  add->setMenu(adding);
  auto* line = new QHBoxLayout;
  line->setContentsMargins(12, 8, 8, 0);
  line->addWidget(heading, 1);
  line->addWidget(add);
  auto* column = new QVBoxLayout(bodies);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(line);
  column->addWidget(m_bodies.list(), 1);
  auto* plans = new QWidget(parts().window);
  auto* plansHeading = new QLabel(tr("Planning"), plans);
  plansHeading->setProperty("strong", true);
  auto* plansLine = new QHBoxLayout;
  plansLine->setContentsMargins(12, 8, 8, 0);
  plansLine->addWidget(plansHeading, 1);
  plansLine->addWidget(m_robots.box());
  for (QAction* const action : m_paths.buttons()) {
    auto* button = new QToolButton(plans);
    button->setObjectName(action->objectName() + QStringLiteral("Button"));
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    plansLine->addWidget(button);
  }
  auto* plansColumn = new QVBoxLayout(plans);
  plansColumn->setContentsMargins(0, 0, 0, 0);
  plansColumn->addLayout(plansLine);
  plansColumn->addWidget(m_paths.tree(), 1);
  // The height is fixed, so that the rows above do not move with the description of the selected row.
  auto* known = new ScrolledPanel(m_paths.detail(), ScrolledPanel::Directions::Vertical, plans);
  known->setObjectName(QStringLiteral("planDetailArea"));
  constexpr int kLines = 3;
  known->setFixedHeight(kLines * plans->fontMetrics().lineSpacing() + 12);
  plansColumn->addWidget(known);
  auto* panel = new QSplitter(Qt::Vertical, parts().window);
  panel->setObjectName(QStringLiteral("cellPanel"));
  panel->setChildrenCollapsible(false);
  panel->addWidget(bodies);
  panel->addWidget(plans);
  panel->addWidget(RigidPartsUi::panel());
  panel->setStretchFactor(1, 2);
  panel->setStretchFactor(2, 2);
  panel->setSizes({110, 360, 270});  // shares
  return panel;
}

void RobotCellUi::setDocument(DocumentTab* document) {
  m_dragged.reset();
  m_pathDock.setDocument(document);
  m_contacts->clearAll();
  m_bodies.setDocument(document);
  m_robots.setDocument(document);
  m_collisions.setDocument(document);
  m_proximity.setDocument(document);
  m_targets.setDocument(document);
  m_reach.setDocument(document);
  m_toolCamera.setDocument(nullptr);  // before the camera of the document is kept
  m_paths.setDocument(document);
  m_surfaces.clear();
  m_guides.clear();
  RigidPartsUi::setDocument(document);
  m_toolCamera.setDocument(document);
  if (document) connect(&document->document, &Document::changed, this, &RobotCellUi::lookAgain);
}

// A message is about the state of its document: it goes with the next change of that, and where a newer one tells of
// the same. An error stays beside another one.
void RobotCellUi::say(Message message) {
  const Document* const about = message.about;
  if (about) {
    const bool isNews = message.weight == Message::Weight::Info;
    SaidLast& last = m_said[about];
    ++last.number;
    if (isNews) last.news = last.number;
    last.title = message.title;
    message.isOver = [this, about, isNews, title = message.title, number = last.number, at = about->revision()] {
      const auto now = m_said.find(about);
      if (now == m_said.end() || about->revision() != at) return true;
      const SaidLast& newest = now->second;
      return newest.news > number || (newest.number > number && (isNews || newest.title == title));
    };
  }
  emit KindUi::message(message);
}

void RobotCellUi::showReplay(const std::shared_ptr<const DisplayModel>& model,
                             const std::vector<CellCollision>& collisions) {
  showPast(model);
  m_toolCamera.follow(model.get());
  constexpr auto kReplay = CellContactMarks::Source::Replay;
  const bool wasReplayed = std::exchange(m_isReplayed, model != nullptr);
  if (model) {
    m_contacts->show(kReplay, collisions);
    if (!m_replayFields.isActive()) m_replayFields.start();
  } else {
    m_contacts->clear(kReplay);
    m_replayFields.stop();
    if (wasReplayed) refreshPanel();
  }
}

// Ends a replay: the robot keeps its displayed joint values.
void RobotCellUi::takeShownPose() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  const JointValues joints = m_paths.seenJoints(cell);
  m_pathDock.close();
  if (auto edit = cell.jointEdit(joints)) cell.commit(tr("Go to where the path was shown"), std::move(edit));
}

// One that was added may stand outside the view.
void RobotCellUi::showRobots() {
  parts().viewport.fit();
}

void RobotCellUi::begin(const QString&) {
  askForLibraryRobot(parts().window, tr("New cell"), this, [this](const char* id) {
    OpenedFile opened;
    opened.kind = parts().kinds.withId("cell");
    opened.content = cellOf(*libraryTable(id));
    parts().openDocument(std::move(opened));
  });
}

// Grouped by what a planner works on; what is for the selected row of any kind stands below.
QList<QAction*> RobotCellUi::menu() {
  const std::pair<QString, QList<QAction*>> groups[] = {
      {tr("&Robots"), m_robots.all() + QList<QAction*>{m_paths.choosing(), m_reach.action(), m_toolCamera.action()}},
      {tr("&Bodies"), m_bodies.all()},
      {tr("C&onfigurations, targets and frames"), m_paths.ofConfigurations()},
      {tr("P&aths"), m_paths.ofPaths()},
      {tr("Verif&ication"),
       m_paths.ofVerification() + QList<QAction*>{m_pathDock.action(), m_contacts->action(), m_proximity.action()}},
      {tr("Pro&grams"), m_paths.ofPrograms()}};
  QList<QAction*> entries;
  for (const auto& [title, actions] : groups) {
    auto* const menu = new QMenu(title, parts().window);
    menu->addActions(actions);
    entries += menu->menuAction();
  }
  return entries + m_paths.ofRows();
}

QList<QAction*> RobotCellUi::toolBar() {
  return m_paths.buttons() + QList<QAction*>{m_pathDock.action()};
}

void RobotCellUi::refreshVisibility() {
  RigidPartsUi::refreshVisibility();
  if (!document()) return;
  m_paths.setVisible(document()->visible);
  m_targets.setVisible(document()->visible);
  m_reach.setVisible(document()->visible);
  m_contacts->setVisible(document()->visible);
}

// Collisions have a colour of their own, and marks at the contacts.
DisplayModel RobotCellUi::displayed(const Document& document) const {
  DisplayModel model = RigidPartsUi::displayed(document);
  m_contacts->show(CellContactMarks::Source::Document,
                   m_collisions.mark(model, static_cast<const RobotCellDocument&>(document).joints()));
  return model;
}

void RobotCellUi::forget(DocumentTab* document) {
  m_trials.erase(document);
  m_said.erase(&document->document);
  m_paths.forget(document);
}

// A body that is dragged is in the document when it is let go; its fields show meanwhile where it is.
void RobotCellUi::showPreview(const ToolPreview& preview) {
  RigidPartsUi::showPreview(preview);
  m_toolCamera.follow(preview.replaced.get());
  if (!preview.replaced) m_contacts->clear(CellContactMarks::Source::Tool);
  std::optional<Body> dragged;
  for (const DisplayPart& part :
       document() && preview.replaced ? preview.replaced->parts : std::vector<DisplayPart>()) {
    const auto id = bodyOfPart(part.name);
    const auto& cell = static_cast<const RobotCellDocument&>(document()->document);
    const BodyPointer body = id ? cell.bodies().withId(*id) : nullptr;
    if (!body || carrierOf(*body, cell.robot().model) != kNone) continue;  // it moves with the robot
    if (part.pose.matrix() == body->pose.matrix()) continue;
    dragged = *body;
    dragged->pose = part.pose;
  }
  if (!dragged && !m_dragged) return;
  m_dragged = std::move(dragged);
  refreshPanel();
}

// The selected one only: there may be very many.
std::optional<Body> RobotCellUi::shownBody(const Document& document) const {
  const auto id = m_bodies.selection().body();
  if (!id) return std::nullopt;
  if (m_dragged && m_dragged->id == *id) return m_dragged;
  const BodyPointer body = static_cast<const RobotCellDocument&>(document).bodies().withId(*id);
  return body ? std::optional(*body) : std::nullopt;
}

std::vector<Property> RobotCellUi::listedProperties(const Document& document) const {
  const auto body = shownBody(document);
  return static_cast<const RobotCellDocument&>(document).propertiesWith(body ? std::span(&*body, 1)
                                                                             : std::span<const Body>());
}

// Shows the latest selection. A row with fields replaces the body; a path only if the user chooses it, as one that was
// planned meanwhile is also selected.
void RobotCellUi::followRow(bool isChosen) {
  if (!document()) return;
  using Kind = PlanTree::Entry::Kind;
  const Kind kind = m_paths.tree()->current().kind;
  if (kind == Kind::Waypoint || kind == Kind::Robot || (kind == Kind::Path && isChosen)) m_bodies.selection().clear();
  m_showsRow = kind == Kind::Target || kind == Kind::Frame || m_bodies.selection().empty();
  refreshPanel();
  parts().tools.refresh();
}

std::map<std::string, bool> RobotCellUi::foldingGroups(const Document& document) const {
  const auto& cell = static_cast<const RobotCellDocument&>(document);
  const std::vector<RobotArm>& robots = cell.robot().arms;
  if (robots.size() < 2) return {};
  std::map<std::string, bool> groups;
  for (const RobotArm& robot : robots) {
    const bool isSelected = selectedRobot() == robot.name;
    groups[robot.name] = isSelected || robot == activeArm(cell.robot(), *cell.plans());
  }
  return groups;
}

bool RobotCellUi::takeEdit(const std::string& id, const PropertyValue& value, bool stillDragging) {
  // The other joints stay as they are seen.
  if (m_paths.showsOtherJoints() && (id.starts_with("joint.") || id.starts_with("tool."))) takeShownPose();
  return m_paths.takeProcessEdit(id, value, stillDragging);
}

std::vector<Property> RobotCellUi::panelProperties(const Document& document) const {
  const auto& cell = static_cast<const RobotCellDocument&>(document);
  const NamedTarget* const target = m_showsRow ? m_paths.target() : nullptr;
  const NamedFrame* const frame = m_showsRow ? m_paths.frame() : nullptr;
  if (target || frame) {
    std::vector<Property> own =
        target ? targetProperties(*target, cell.placement()) : frameProperties(*frame, cell.placement());
    if (auto chosen = cell.property("frame")) own.push_back(*std::move(chosen));
    return own;
  }
  const auto body = m_showsRow ? std::nullopt : shownBody(document);
  if (body) return cell.propertiesOfBody(*body);
  const PlanTree::Entry entry = m_paths.tree()->current();
  std::vector<Property> first = m_paths.resultProperties();
  for (Property& each : m_paths.processProperties()) first.push_back(std::move(each));
  if (const RobotPath* const path = cell.plans()->path(entry.name);
      entry.kind == PlanTree::Entry::Kind::Waypoint && path)
    first = waypointProperties(*path, entry.waypoint);
  std::vector<Property> all = cellProperties(cell.robot(), m_paths.seenJoints(cell), *cell.plans());
  const std::string base = "robot." + selectedRobot() + '.';
  std::erase_if(all, [&](const Property& each) {
    return !each.id.starts_with("joint") && !each.id.starts_with(base) && !each.id.starts_with("tcp.") &&
           !isRateProperty(each.id) && each.group != "Tool" && each.id != "frame";
  });
  // The base of the selected robot, then its joints.
  const auto end = std::stable_partition(all.begin(), all.end(),
                                         [&](const Property& each) { return each.group == selectedRobot(); });
  std::stable_partition(all.begin(), end, [&](const Property& each) { return each.id.starts_with(base); });
  all.insert(all.begin(), first.begin(), first.end());
  return all;
}

// Empty: the selected row is none of a robot.
std::string RobotCellUi::selectedRobot() const {
  const PlanTree::Entry entry = m_paths.tree()->current();
  return entry.kind == PlanTree::Entry::Kind::Robot ? entry.name : std::string();
}

// In a cell with one robot its fields are there whenever nothing else is selected.
void RobotCellUi::selectRobot(std::uint32_t link) {
  const CellRobot& robots = static_cast<const RobotCellDocument&>(document()->document).robot();
  const std::uint32_t robot = armsOfLinks(robots.model, robots.arms)[link];
  m_bodies.selection().clear();
  if (robot == kNone) return;
  if (robots.arms.size() > 1)
    m_paths.tree()->select({PlanTree::Entry::Kind::Robot, robots.arms[robot].name});
  else if (m_paths.target() || m_paths.frame())
    m_paths.tree()->setCurrentItem(nullptr);
}

// A click beside the bodies deselects them.
void RobotCellUi::select(const Pick& pick) {
  if (!document() || bodyOfPart(partOf(pick))) return;
  m_bodies.selection().clear();
  const auto& cell = static_cast<const RobotCellDocument&>(document()->document);
  if (const std::uint32_t link = linkOfPart(cell.robot(), partOf(pick)); link != kNone) selectRobot(link);
}

// Returns the menu for the object under the pointer: a body is selected, but nothing is deselected.
QMenu* RobotCellUi::menuAt(const QPointF& position) {
  const auto body = bodyOfPart(partOf(parts().viewport.pickAt(position)));
  if (body && !m_bodies.selection().bodies().contains(*body)) m_bodies.selection().select(*body);
  return &m_bodies.menu();
}

void RobotCellUi::markSelected(bool isCovered) {
  std::set<std::string> names;
  for (BodyId id : m_bodies.selection().bodies()) names.insert(partOfBody(id));
  m_isCovered = isCovered && !names.empty();
  layer().setSelected(names, m_isCovered);
}

// The part that covered it may be gone.
void RobotCellUi::lookAgain() {
  const auto shown = m_isCovered ? shownBody(document()->document) : std::nullopt;
  const BodyPointer body = shown ? placedBody(shown->id) : nullptr;
  if (body) markSelected(visibilityOf(*body, parts().viewport) == BodyVisibility::Covered);
}

// The body as it stands in the view.
BodyPointer RobotCellUi::placedBody(BodyId id) const {
  const auto& cell = static_cast<const RobotCellDocument&>(document()->document);
  return inFrameOfBase(cell.bodies(), cell.robot().model, cell.joints()).withId(id);
}

// One that is chosen in the list, or new, is seen: the view goes there, and what covers it becomes translucent.
void RobotCellUi::reveal(BodyId id, bool isNew) {
  const BodyPointer body = placedBody(id);
  if (!body || !body->visible || body->geometry->bounds().isEmpty()) return;
  Viewport& view = parts().viewport;
  if (visibilityOf(*body, view) == BodyVisibility::Outside)
    isNew ? view.fit() : view.flyTo(boundsOf(*body), Vec3::Zero());
  const bool isCovered = visibilityOf(*body, view) == BodyVisibility::Covered;
  markSelected(isCovered);
  if (!isCovered || !isNew) return;
  say({Message::Weight::Info,
       tr("%1 is inside another object").arg(QString::fromStdString(body->name)),
       tr("It is at the position given in its file; everything else is transparent while it is selected."),
       tr("Type another position in the panel."),
       tr("&Place it beside the others"),
       [this, id, tab = document()] {
         if (tab == document()) m_bodies.placeBeside(id);
       },
       {},
       {},
       &document()->document});
}

std::vector<StartAction> RobotCellUi::startActions() const {
  return {
      {QStringLiteral("openCellSample"), tr("Open the sample robot &cell"),
       tr("Open a robot in front of a block on a table, with a path along its edge"), panelIcon(),
       QStringLiteral("robot-cell.handwheel"),
       StartTile{QStringLiteral("cellTile"), panelIcon(), tr("Robot cell"),
                 tr("Opens a sample cell. Plan a path from left to right, or lead the robot along an edge by hand.")}},
      {QStringLiteral("openRobotSample"), tr("Open the sample &robot"), tr("Open the sample robot arm"), panelIcon(),
       QStringLiteral("robot-arm.urdf")},
      {QStringLiteral("newBuiltInCell"),
       tr("&New cell with a built-in robot…"),
       tr("Create a cell with a robot of the library, from its manufacturer's data"),
       panelIcon(),
       {},
       {},
       true}};
}

Suggestion RobotCellUi::suggestion() {
  if (!document() || document()->document.history()->count() > 0) return {};
  const CellRobot& robot = static_cast<const RobotCellDocument&>(document()->document).robot();
  return {panelIcon(), themeColours(currentTheme()).accent,
          tr("Robot %1: %Ln joint(s) that move.", nullptr, static_cast<int>(robot.model.dofs.size()))
              .arg(QString::fromStdString(robot.model.name)),
          tr("Drag a link with the mouse, or the whole arm with Shift. Type angles in the list of joints. Add bodies "
             "beside the robot in the panel."),
          panelActions()};
}

QString RobotCellUi::statistics() const {
  if (!document()) return {};
  const auto& cell = static_cast<const RobotCellDocument&>(document()->document);
  const QString joints = tr("%Ln joint(s)", nullptr, static_cast<int>(cell.robot().model.dofs.size()));
  if (cell.bodies().empty()) return joints;
  return tr("%1, %2").arg(joints, tr("%Ln body(ies)", nullptr, static_cast<int>(cell.bodies().size())));
}

QString RobotCellUi::openedText(const DocumentTab& opened) const {
  const RobotModel& robot = static_cast<const RobotCellDocument&>(opened.document).robot().model;
  return tr("Opened %1: robot %2 with %3 and %4")
      .arg(opened.document.name(), QString::fromStdString(robot.name),
           tr("%n link(s)", nullptr, static_cast<int>(robot.links.size())),
           tr("%n joint(s) that move", nullptr, static_cast<int>(robot.dofs.size())));
}

}  // namespace handwheel
