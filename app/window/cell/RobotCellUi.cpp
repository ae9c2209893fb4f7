// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/RobotCellUi.h"

#include "collision/ProximityFidelity.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellImport.h"
#include "document/cell/PlaceProperties.h"
#include "document/cell/RobotCellDocument.h"
#include "document/cell/RobotCellKind.h"
#include "document/scene/BodyDisplay.h"
#include "document/scene/BodyProperties.h"
#include "fidelity/Cases.h"
#include "panels/bodies/BodyList.h"
#include "robot/arm/IkFidelity.h"
#include "theme/Icons.h"
#include "theme/Theme.h"
#include "tools/cell/ArmWaysTool.h"
#include "tools/cell/CellTool.h"
#include "tools/cell/FaceSnapTool.h"
#include "tools/cell/ProcessTool.h"
#include "viewport/Viewport.h"
#include "viewport/surface/PartsLayer.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/cell/BodySight.h"
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

namespace handwheel {

RobotCellUi::RobotCellUi(const WindowContext& window, RobotCellKind& kind)
    : RigidPartsUi(window, {"Joints", "Tool"}),
      m_bodies(window, this),
      m_collisions(window, this),
      m_targets(window, m_collisions, this),
      m_robots(
          window,
          [this] {
            const PlanTree::Entry entry = m_paths.tree()->current();
            return entry.kind == PlanTree::Entry::Kind::Robot ? entry.name : std::string();
          },
          this),
      m_reach(window, m_collisions, this),
      m_toolCamera(window, this),
      m_paths(
          window, m_collisions, m_targets, m_robots, [this] { return m_bodies.selected(); }, this),
      m_pathDock(window, m_paths, this),
      m_surfaces(window.jobs, this),
      m_guides(window.jobs, m_collisions, this),
      m_panel(makePanel()) {
  const auto follow = [&kind, &choice = window.fidelity] {
    kind.setShapeSides(static_cast<std::uint32_t>(choice.values().of(shapeSidesSetting())));
  };
  connect(&window.fidelity, &FidelityChoice::changed, this, follow);
  follow();
  connect(&m_bodies, &CellBodies::message, this, &KindUi::message);
  connect(&m_paths, &CellPaths::message, this, &KindUi::message);
  connect(&m_robots, &CellRobots::message, this, &KindUi::message);
  connect(&m_pathDock, &PathDock::partsShown, this, [this](const std::shared_ptr<const DisplayModel>& model) {
    showPast(model);
    m_toolCamera.follow(model.get());
  });
  connect(&m_collisions, &CellCollisions::prepared, this, [this, &tools = window.tools] {
    show();
    tools.refresh();
  });
  connect(&m_paths, &CellPaths::rowChanged, this, [this] {
    m_showsTarget = m_paths.target() != nullptr;
    refreshPanel();
  });
  connect(&m_bodies, &CellBodies::selectionChanged, this, [this, &tools = window.tools] {
    m_showsTarget = false;
    markSelected(false);
    refreshPanel();
    tools.refresh();
  });
  connect(&m_bodies, &CellBodies::chosen, this, [this](BodyId body) { reveal(body, false); });
  connect(&m_bodies, &CellBodies::added, this, [this](BodyId body, bool) { reveal(body, true); });
  connect(&m_surfaces, &PartSurfaces::prepared, this, [&tools = window.tools] { tools.refresh(); });
  connect(&m_guides, &PathGuides::prepared, this, [&tools = window.tools] { tools.refresh(); });
  connect(&window.viewport, &Viewport::clicked, this, &RobotCellUi::select);
  connect(m_paths.tree(), &PlanTree::currentChanged, this, [this] {
    if (!this->document()) return;
    if (m_paths.tree()->current().kind == PlanTree::Entry::Kind::Place) m_bodies.selection().clear();
    refreshPanel();
  });
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
  auto* panel = new QSplitter(Qt::Vertical, parts().window);
  panel->setObjectName(QStringLiteral("cellPanel"));
  panel->setChildrenCollapsible(false);
  panel->addWidget(bodies);
  panel->addWidget(plans);
  panel->addWidget(RigidPartsUi::panel());
  panel->setStretchFactor(1, 2);
  panel->setStretchFactor(2, 2);
  panel->setSizes({160, 260, 320});  // shares
  return panel;
}

void RobotCellUi::setDocument(DocumentTab* document) {
  m_dragged.reset();
  m_pathDock.setDocument(document);
  m_bodies.setDocument(document);
  m_robots.setDocument(document);
  m_collisions.setDocument(document);
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

void RobotCellUi::begin(const QString&) {
  askForLibraryRobot(parts().window, tr("New cell"), this, [this](const char* id) {
    OpenedFile opened;
    opened.kind = parts().kinds.withId("cell");
    opened.content = cellOf(*libraryTable(id));
    parts().openDocument(std::move(opened));
  });
}

QList<QAction*> RobotCellUi::menu() {
  return m_robots.all() + m_bodies.all() + m_paths.all() +
         QList<QAction*>{m_pathDock.action(), m_reach.action(), m_toolCamera.action()};
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
}

// What collides where the robot stands has a colour of its own.
DisplayModel RobotCellUi::displayed(const Document& document) const {
  DisplayModel model = RigidPartsUi::displayed(document);
  m_collisions.mark(model, static_cast<const RobotCellDocument&>(document).joints());
  return model;
}

void RobotCellUi::forget(DocumentTab* document) {
  m_tries.erase(document);
  m_paths.forget(document);
  parts().jobs.cancelOf(document);
}

// A body that is dragged is in the document when it is let go; its fields show meanwhile where it is.
void RobotCellUi::showPreview(const ToolPreview& preview) {
  RigidPartsUi::showPreview(preview);
  m_toolCamera.follow(preview.replaced.get());
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

std::vector<Property> RobotCellUi::panelProperties(const Document& document) const {
  if (const NamedTarget* const target = m_showsTarget ? m_paths.target() : nullptr)
    return RobotCellDocument::propertiesOfTarget(*target);
  if (const auto body = shownBody(document))
    return static_cast<const RobotCellDocument&>(document).propertiesOfBody(*body);
  std::vector<Property> all = RigidPartsUi::panelProperties(document);
  std::ptrdiff_t ofBase = 0;
  const PlanTree::Entry entry = m_paths.tree()->current();
  if (entry.kind == PlanTree::Entry::Kind::Robot) {
    for (Property& each : listedProperties(document)) {
      if (each.id.starts_with("robot." + entry.name + '.')) all.insert(all.begin() + ofBase++, std::move(each));
    }
  }
  const RobotPath* const path = static_cast<const RobotCellDocument&>(document).plans()->path(entry.name);
  if (entry.kind != PlanTree::Entry::Kind::Place || !path) return all;
  const std::vector<Property> place = placeProperties(*path, entry.place);
  all.insert(all.begin(), place.begin(), place.end());
  return all;
}

// A click beside the bodies deselects them.
void RobotCellUi::select(const Pick& pick) {
  if (document() && !bodyOfPart(partOf(pick))) m_bodies.selection().clear();
}

// Of what is under the pointer: a body gets selected, but nothing is deselected.
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

// What covered it may be gone.
void RobotCellUi::lookAgain() {
  const auto shown = m_isCovered ? shownBody(document()->document) : std::nullopt;
  const BodyPointer body = shown ? placedBody(shown->id) : nullptr;
  if (body) markSelected(sightOf(*body, parts().viewport) == BodySight::Covered);
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
  if (sightOf(*body, view) == BodySight::Outside) isNew ? view.fit() : view.flyTo(boundsOf(*body), Vec3::Zero());
  const bool isCovered = sightOf(*body, view) == BodySight::Covered;
  markSelected(isCovered);
  if (!isCovered || !isNew) return;
  emit message({Message::Weight::Info,
                tr("%1 is inside another object").arg(QString::fromStdString(body->name)),
                tr("It is at the position given in its file; everything else is transparent while it is selected."),
                tr("Type another position in the panel."),
                {},
                {},
                {},
                {},
                &document()->document});
}

std::vector<StartAction> RobotCellUi::startActions() const {
  return {
      {QStringLiteral("openCellSample"), tr("Open the sample robot &cell"),
       tr("Open a robot before a block on a table, with a path along its edge"), panelIcon(),
       QStringLiteral("robot-cell.handwheel"),
       StartTile{QStringLiteral("cellTile"), panelIcon(), tr("Robot cell"),
                 tr("Opens a sample cell. Plan a path from left to right, or lead the robot along an edge by hand.")}},
      {QStringLiteral("openRobotSample"), tr("Open the sample &robot"), tr("Open the sample robot arm"), panelIcon(),
       QStringLiteral("robot-arm.urdf")},
      {QStringLiteral("newBuiltInCell"),
       tr("&New cell with a built-in robot…"),
       tr("Begin a cell with a robot of the library, by its makers' tables"),
       panelIcon(),
       {},
       {},
       true}};
}

std::vector<ToolDescriptor> RobotCellUi::tools() {
  ToolDescriptor joints{QStringLiteral("jointTool"),
                        tr("Move &joints by hand"),
                        tr("Drag the links of the robot, and the bodies beside it"),
                        QStringLiteral("hand"),
                        QKeySequence(Qt::Key_J),
                        [this] { return handTool(); },
                        "joints",
                        CellTool::keys()};
  joints.isDefault = true;
  const ToolDescriptor process{QStringLiteral("processTool"),
                               tr("&Process path along a curve"),
                               tr("Choose an edge or a section of a part for the robot's tool to work along"),
                               QStringLiteral("boundary"),
                               QKeySequence(Qt::Key_X),
                               [this] { return processTool(); },
                               "process",
                               ProcessTool::keys()};
  const ToolDescriptor lead{QStringLiteral("leadTool"),
                            tr("&Lead the robot by hand"),
                            tr("Lead the robot's tool; the arm follows, never through anything"),
                            QStringLiteral("lead"),
                            QKeySequence(Qt::SHIFT | Qt::Key_J),
                            [this] { return leadTool(); },
                            "lead",
                            LeadTool::keys()};
  const ToolDescriptor ways{QStringLiteral("armWaysTool"),
                            tr("&Choose the arm's configuration"),
                            tr("See all ways in which the arm reaches a pose of its tool: shoulder, elbow and wrist"),
                            QStringLiteral("arm-ways"),
                            QKeySequence(Qt::SHIFT | Qt::Key_K),
                            [this] { return armWaysTool(); },
                            "ways",
                            ArmWaysTool::keys()};
  const ToolDescriptor place{QStringLiteral("placeTool"),
                             tr("Place a body with &handles"),
                             tr("Move and turn the selected body along and about axes"),
                             QStringLiteral("axes"),
                             QKeySequence(Qt::SHIFT | Qt::Key_W),
                             [this] { return placeTool(); },
                             "place",
                             PlaceTool::keys()};
  const ToolDescriptor snap{QStringLiteral("faceSnapTool"),
                            tr("Lay a body &face to face"),
                            tr("Lay a body with one of its faces on a face of another"),
                            QStringLiteral("face-to-face"),
                            QKeySequence(Qt::SHIFT | Qt::Key_B),
                            [this] { return faceSnapTool(); },
                            "snap",
                            FaceSnapTool::keys()};
  return {joints, lead, ways, place, snap, process, measureParts()};
}

std::optional<RobotCellPick> RobotCellUi::pickCell(const Ray& ray) const {
  const Pick hit = parts().viewport.pickAlong(ray.origin, ray.direction);
  const std::string part = partOf(hit);
  return part.empty() ? std::nullopt : std::optional(RobotCellPick{part, hit.point});
}

std::unique_ptr<Tool> RobotCellUi::processTool() {
  const auto& cell = static_cast<const RobotCellDocument&>(document()->document);
  ProcessServices services;
  services.pick = [this](const Ray& ray) { return pickCell(ray); };
  services.surface = [this](const BodyPointer& body) { return m_surfaces.of(body); };
  services.plan = [this, &cell](const OperationValues& values) {
    const BodyPointer part = cell.bodies().withId(static_cast<BodyId>(std::stoul(values.text("part"))));
    const auto surface = part ? m_surfaces.of(part) : nullptr;
    if (surface) m_paths.planProcess(values, surface);
  };
  return std::make_unique<ProcessTool>(cell, std::move(services));
}

std::unique_ptr<Tool> RobotCellUi::leadTool() {
  LeadServices services;
  services.scene = [this] { return m_collisions.scene(); };
  services.mark = [this](DisplayModel& shown, const JointValues& joints) { m_collisions.mark(shown, joints); };
  services.addPlace = [this] { m_paths.addPlace(); };
  services.time = [this] { return 1e-3 * static_cast<double>(m_clock.elapsed()); };
  services.tolerance = parts().fidelity.values().of(proximityToleranceSetting());
  services.ikTolerance = parts().fidelity.values().of(ikToleranceSetting());
  services.tries = &m_tries[document()];
  services.guide = [this](const std::string& path) {
    return m_guides.of(path, static_cast<const RobotCellDocument&>(document()->document).plans());
  };
  return std::make_unique<LeadTool>(static_cast<RobotCellDocument&>(document()->document), std::move(services));
}

std::unique_ptr<Tool> RobotCellUi::armWaysTool() {
  ArmWaysServices services;
  services.scene = [this] { return m_collisions.scene(); };
  services.mark = [this](DisplayModel& shown, const JointValues& joints) { m_collisions.mark(shown, joints); };
  return std::make_unique<ArmWaysTool>(static_cast<RobotCellDocument&>(document()->document), std::move(services));
}

PlaceServices RobotCellUi::placeServices() {
  PlaceServices services;
  services.pick = [this](const Ray& ray) { return pickCell(ray); };
  services.mark = [this](DisplayModel& shown, const Body& moved) {
    m_collisions.mark(shown, static_cast<const RobotCellDocument&>(document()->document).joints(), &moved);
  };
  return services;
}

std::unique_ptr<Tool> RobotCellUi::placeTool() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  return std::make_unique<PlaceTool>(cell, m_bodies.selection(), placeServices());
}

std::unique_ptr<Tool> RobotCellUi::faceSnapTool() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  return std::make_unique<FaceSnapTool>(cell, m_bodies.selection(), placeServices());
}

std::unique_ptr<Tool> RobotCellUi::handTool() {
  auto& cell = static_cast<RobotCellDocument&>(document()->document);
  const auto pick = [this](const Ray& ray) { return pickCell(ray); };
  const auto mark = [this](DisplayModel& shown, const JointValues& joints, const Body* moved) {
    m_collisions.mark(shown, joints, moved);
  };
  return std::make_unique<CellTool>(cell, m_bodies.selection(), pick, mark);
}

NextStep RobotCellUi::nextStep() {
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
