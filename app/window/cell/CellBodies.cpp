// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellBodies.h"

#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "panels/bodies/BodyList.h"
#include "scene/MeshGeometry.h"
#include "scene/PrimitiveGeometry.h"
#include "window/ActionToolTip.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTab.h"
#include "window/kinds/KindPanel.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

CellBodies::CellBodies(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_list(new BodyList(parts.window)),
      m_shapes(new QMenu(tr("Add a &shape"), parts.window)),
      m_add(tr("&Add a body from a file…"), this),
      m_link(tr("Add a body &linked to a file…"), this),
      m_rename(tr("Re&name the body"), this),
      m_unit(tr("Choose the &unit of its numbers…"), this),
      m_beside(tr("&Place it beside the others"), this),
      m_mount(tr("&Mount the body on the tool flange"), this),
      m_tip(tr("Tool &centre point at its tip"), this),
      m_release(tr("Take the body off the &robot"), this),
      m_remove(tr("&Remove the body"), this),
      m_hide(tr("&Hide the body"), this),
      m_showAll(tr("Show all &bodies"), this),
      m_update(tr("Read the linked file a&gain"), this),
      m_relink(tr("Link to an&other file…"), this),
      m_unlink(tr("Unlink the &file"), this),
      m_menu(new QMenu(parts.window)) {
  prepare(m_add, "addBody", "add-mesh", tr("Add the shape of another file beside the robot"));
  prepare(m_link, "linkBody", nullptr,
          tr("Add the shape of another file and link to the file, to read it again when it has changed"));
  prepare(m_rename, "renameBody", nullptr, tr("Give the selected body another name, in the list"));
  prepare(m_unit, "bodyUnit", nullptr,
          tr("Specify the unit of the numbers of its file: STL, OBJ, PLY and OFF have none and are taken as mm"));
  prepare(m_beside, "placeBeside", nullptr,
          tr("Put the selected body in front of the robot and of all other bodies, on the floor"));
  prepare(m_mount, "mountBody", nullptr,
          tr("Attach the selected body to the robot as a tool, with its origin at the flange"));
  prepare(m_tip, "centreAtTip", nullptr,
          tr("Put the tool centre point in the middle of what reaches farthest along the Z axis of the flange"));
  prepare(m_release, "releaseBody", nullptr, tr("Detach the selected body from the robot and leave it where it is"));
  prepare(m_remove, "removeBody", nullptr, tr("Remove the selected bodies from the cell"));
  prepare(m_hide, "hideBody", "eye-off", tr("Hide the selected bodies from view and touch"));
  prepare(m_showAll, "showBodies", "eye", tr("Show all bodies that are hidden"));
  prepare(m_update, "updateBody", nullptr, tr("Read the file that the selected body is linked to again"));
  prepare(m_relink, "relinkBody", nullptr, tr("Use the shape of another file; name, position and colour are kept"));
  prepare(m_unlink, "unlinkBody", nullptr, tr("Keep the selected body as it is, without a link to its file"));
  addShapes();
  m_menu->setObjectName(QStringLiteral("bodyMenu"));
  m_menu->addActions(all());
  connectActions();
  connectList();
  update();
}

void CellBodies::connectActions() {
  connect(&m_add, &QAction::triggered, this, [this] {
    askForFile(tr("Add a body"), [this](const std::string& path) {
      OperationValues values(bodyOperation());
      values.setValid("add", path);
      apply(values);
    });
  });
  connect(&m_link, &QAction::triggered, this, [this] {
    askForFile(tr("Add a linked body"), [this](const std::string& path) {
      OperationValues values(bodyOperation());
      values.setValid("add", path);
      values.setValid("link", true);
      apply(values);
    });
  });
  connect(&m_rename, &QAction::triggered, this, [this] {
    showKindPanel(m_parts);
    m_list->setFocus();
    m_list->edit(m_list->currentIndex().siblingAtColumn(BodyModel::Name));
  });
  connect(&m_unit, &QAction::triggered, this, &CellBodies::askForUnit);
  connect(&m_beside, &QAction::triggered, this, [this] { placeBeside(selected()->id); });
  connect(&m_mount, &QAction::triggered, this, &CellBodies::mountSelected);
  connect(&m_tip, &QAction::triggered, this, [this] { setCentreAtTip(selected()->id); });
  connect(&m_release, &QAction::triggered, this, [this] { carry({selected()->id}, kNone); });
  connect(&m_remove, &QAction::triggered, this, &CellBodies::removeSelected);
  connect(&m_update, &QAction::triggered, this, [this] { applyToSelected("update"); });
  connect(&m_relink, &QAction::triggered, this, &CellBodies::relinkSelected);
  connect(&m_unlink, &QAction::triggered, this, [this] { applyToSelected("unlink"); });
  connect(&m_hide, &QAction::triggered, this, [this] { setVisible(m_selection.bodies(), false); });
  connect(&m_showAll, &QAction::triggered, this, [this] {
    std::set<BodyId> ids;
    for (const BodyPointer& body : cell().bodies()) ids.insert(body->id);
    setVisible(ids, true);
  });
}

void CellBodies::connectList() {
  m_selection.whenChanged([this] {
    update();
    emit selectionChanged();
  });
  connect(m_list, &BodyList::selected, this, [this](const std::set<BodyId>& bodies) {
    m_selection.selectAll(bodies);
    if (m_selection.body()) emit chosen(*m_selection.body());
  });
  connect(m_list, &BodyList::renameRequested, this, &CellBodies::rename);
  connect(m_list, &BodyList::removalRequested, this, &CellBodies::removeSelected);
  connect(m_list, &BodyList::visibilityRequested, this, &CellBodies::setVisible);
  connect(m_list, &BodyList::carrierRequested, this, [this](const std::set<BodyId>& bodies, const QString& carrier) {
    carry(bodies, carrier.isEmpty() ? kNone : linkNamed(cell().robot().model, carrier.toStdString()));
  });
  connect(m_list, &QWidget::customContextMenuRequested, this,
          [this](const QPoint& position) { m_menu->popup(m_list->viewport()->mapToGlobal(position)); });
}

void CellBodies::addShapes() {
  for (const PrimitiveDescription& primitive : primitives()) {
    auto* action = new QAction(QCoreApplication::translate("Property", primitive.label), this);
    prepare(*action, (std::string("add-") + primitive.id).c_str(), nullptr,
            tr("Add a body of this shape beside the robot"));
    connect(action, &QAction::triggered, this, [this, &primitive] { addShape(primitive); });
    m_shapes->addAction(action);
  }
}

QList<QAction*> CellBodies::adding() {
  return {&m_add, &m_link, m_shapes->menuAction()};
}

QList<QAction*> CellBodies::all() {
  return adding() + QList<QAction*>{&m_rename, &m_unit, &m_beside,  &m_mount,  &m_tip,    &m_release,
                                    &m_remove, &m_hide, &m_showAll, &m_update, &m_relink, &m_unlink};
}

void CellBodies::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  m_selection.clear();
  if (document) connect(&document->document, &Document::changed, this, &CellBodies::update);
  update();
}

RobotCellDocument& CellBodies::cell() const {
  return static_cast<RobotCellDocument&>(m_document->document);
}

BodyPointer CellBodies::selected() const {
  return m_document && m_selection.body() ? cell().bodies().withId(*m_selection.body()) : nullptr;
}

bool CellBodies::isOnFlange(const Body& body) const {
  return carrierOf(body, cell().robot().model) == activeArm(cell().robot(), *cell().plans()).flange;
}

void CellBodies::update() {
  const BodySet bodies = m_document ? cell().bodies() : BodySet();
  m_selection.keepOnly(bodies);  // calls this again when some were removed
  QStringList carriers;
  for (const handwheel::Link& link : m_document ? cell().robot().model.links : std::vector<handwheel::Link>())
    carriers += QString::fromStdString(link.name);
  m_list->setBodies(bodies, carriers);
  m_list->setSelected(m_selection.bodies());
  const QString noCell = tr("Open a robot cell first.");
  for (QAction* action : adding() + m_shapes->actions()) offer(*action, m_document != nullptr, noCell);
  const auto isVisible = [&](BodyId id) { return bodies.withId(id)->visible; };
  const bool isAnyVisible = std::any_of(m_selection.bodies().begin(), m_selection.bodies().end(), isVisible);
  const auto isHidden = [](const BodyPointer& body) { return !body->visible; };
  const QString noBody = tr("Select a body first, in the view or in the list.");
  offer(m_remove, !m_selection.empty(), noBody);
  offer(m_hide, isAnyVisible, m_selection.empty() ? noBody : tr("It is hidden."));
  offer(m_showAll, std::any_of(bodies.begin(), bodies.end(), isHidden), tr("No body is hidden."));
  const BodyPointer body = selected();
  const QString noSingleBody = m_selection.empty() ? noBody : tr("Select one body only.");
  for (QAction* action : {&m_rename, &m_mount}) offer(*action, body != nullptr, noSingleBody);
  const bool isMesh = body && dynamic_cast<const MeshGeometry*>(body->geometry.get());
  offer(m_unit, isMesh && !body->link,
        !body    ? noSingleBody
        : isMesh ? tr("Unlink the file first: it is read again with its own numbers.")
                 : tr("Only bodies from mesh files have numbers without a unit."));
  offer(m_beside, body && body->carrier.empty(), body ? tr("A link of the robot carries it.") : noSingleBody);
  const bool isTool = body && isOnFlange(*body);
  offer(m_tip, isTool, body ? tr("The flange does not carry it.") : noSingleBody);
  offer(m_release, body && !body->carrier.empty(), body ? tr("The robot does not carry it.") : noSingleBody);
  offer(m_relink, body != nullptr, noSingleBody);
  const QString noLink = body ? tr("The body is not linked to a file.") : m_relink.property(kDisabledReason).toString();
  for (QAction* action : {&m_update, &m_unlink}) offer(*action, body && body->link, noLink);
}

}  // namespace handwheel
