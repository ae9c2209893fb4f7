// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Changes of the document by the actions for bodies.
#include "base/NumberText.h"
#include "controls/QuantityText.h"
#include "document/OperationText.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/RobotCellDocument.h"
#include "document/scene/BodyChanges.h"
#include "panels/LogModel.h"
#include "scene/MeshGeometry.h"
#include "scene/PrimitiveGeometry.h"
#include "scene/RigidPose.h"
#include "text/ErrorText.h"
#include "tools/cell/BodyPlacing.h"
#include "tools/cell/BodyTip.h"
#include "tools/scene/BodyDragTool.h"
#include "window/CommandLines.h"
#include "window/JobRunner.h"
#include "window/cell/CellBodies.h"
#include "window/documents/DiscardedResult.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileFilters.h"
#include "window/documents/FileLoader.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLocale>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

// "100 × 50 × 25.4 mm"
QString sizeText(const Vec3& size, LengthUnit unit, const QLocale& locale) {
  const auto number = [&](double value) { return locale.toString(value / millimetresPer(unit), 'g', 4); };
  return QStringLiteral("%1 × %2 × %3 %4")
      .arg(number(size.x()), number(size.y()), number(size.z()), unitSymbol(Quantity::Length, unit));
}

constexpr double kNewShape = 100.0;  // mm, each dimension of a new primitive

std::filesystem::path folderOf(const Document& document) {
  return std::filesystem::path(document.file().path).parent_path();
}

// The container that a cell is saved to; a robot description becomes one beside it.
QString containerBeside(const QString& path) {
  const QFileInfo file(path);
  return file.path() + QLatin1Char('/') + file.completeBaseName() + containerEnding();
}

RobotCellSnapshot contentOf(const RobotCellDocument& cell) {
  return static_cast<const RobotCellSnapshot&>(*cell.snapshot());
}

// "body --add part.stl --link", with names quoted for a shell.
std::string stepOf(const OperationValues& values) {
  QString step = QString::fromStdString(bodyOperation().id);
  for (const auto& [name, word] : writtenOptions(values)) {
    step += QStringLiteral(" --") + QString::fromStdString(name);
    if (!word.empty()) step += QLatin1Char(' ') + stepWord(word);
  }
  return step.toStdString();
}

QString undoTextOf(const OperationValues& values, const QString& body) {
  if (values.isSet("add")) return CellBodies::tr("Add %1").arg(body);
  if (values.isSet("from")) return CellBodies::tr("Link %1 to another file").arg(body);
  return values.isSet("update") ? CellBodies::tr("Read the file of %1 again").arg(body)
                                : CellBodies::tr("Unlink the file of %1").arg(body);
}

// A file name of this system as the operation takes it.
std::string operandOf(const QString& path) {
  return QFile::encodeName(QFileInfo(path).absoluteFilePath()).toStdString();
}

}  // namespace

// Returns the bounds in the pose in which a robot is opened, whatever its present joint values. Computed once for each
// robot.
const Box& CellBodies::robotAtRest(const RobotCellSnapshot& content) {
  if (m_measured.lock() != content.robot)
    m_robotAtRest = displayOf(*content.robot, restValues(content.robot->model)).bounds();
  m_measured = content.robot;
  return m_robotAtRest;
}

void CellBodies::placeBeside(BodyId id) {
  const BodyPointer body = cell().bodies().withId(id);
  const bool canStand = body && body->carrier.empty() && !body->geometry->bounds().isEmpty();
  if (!canStand) return;
  const RobotCellSnapshot content = contentOf(cell());
  place(id,
        Pose(Eigen::Translation3d(displacementBeside(boundsOf(*body), robotAtRest(content), content, id)) * body->pose),
        tr("Place %1 beside the others"));
}

// Files have their bodies in their own numbers.
void CellBodies::placeAsInFile(BodyId id) {
  place(id, Pose::Identity(), tr("Place %1 where its file says"));
}

void CellBodies::place(BodyId id, const Pose& pose, const QString& text) {
  const BodyPointer body = cell().bodies().withId(id);
  if (!body) return;
  Body moved = *body;
  moved.pose = pose;
  auto edit = changeBodyEdit(cell().bodies(), std::move(moved));
  if (!edit) return report(cell(), edit.error());
  if (*edit) cell().commit(text.arg(QString::fromStdString(body->name)), std::move(edit).value());
}

// Moves a body from a file that would be inside another object, also in the values. Returns false if it keeps the pose
// of its file.
bool CellBodies::standBeside(const RobotCellSnapshot& content, Body& body, OperationValues& values) {
  if (!values.isSet("add") || values.isSet("at")) return false;
  const Box own = boundsOf(body), &robots = robotAtRest(content);
  if (!isInsideOthers(own, robots, content)) return false;
  Pose beside = body.pose;
  beside.pretranslate(displacementBeside(own, robots, content));
  if (!isRigid(beside)) return false;  // too far away
  body.pose = beside;
  const Vec3 at = beside.translation();
  values.setValid("at", std::vector<double>{at.x(), at.y(), at.z()});
  return true;
}

void CellBodies::addShape(const PrimitiveDescription& primitive) {
  OperationValues values(bodyOperation());
  std::string what = std::string(primitive.id) + ':';
  for (std::size_t i = 0; i < primitive.dimensions.size(); ++i)
    what += (i > 0 ? "," : "") + std::to_string(static_cast<int>(kNewShape));
  values.setValid("add", what);
  const auto geometry =
      PrimitiveGeometry::make(primitive.primitive, std::vector<double>(primitive.dimensions.size(), kNewShape));
  const RobotCellSnapshot content = contentOf(cell());
  const Vec3 at = displacementBeside(geometry.value()->bounds(), robotAtRest(content), content);
  values.setValid("at", std::vector<double>{at.x(), at.y(), at.z()});
  apply(values);
}

void CellBodies::askForFile(const QString& title, const std::function<void(const std::string& path)>& chosen) {
  QFileDialog* const dialog =
      openingDialog(m_parts.window, m_document->document, title, openFilters(m_parts.kinds).join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("addBodyDialog"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, chosen, document = m_document](const QString& path) {
    if (document == m_document) chosen(operandOf(path));
  });
  dialog->open();
}

void CellBodies::setVisible(const std::set<BodyId>& ids, bool visible) {
  auto edit = showBodiesEdit(cell().bodies(), std::vector<BodyId>(ids.begin(), ids.end()), visible);
  if (!edit) return;
  const BodyPointer only = ids.size() == 1 ? cell().bodies().withId(*ids.begin()) : nullptr;
  const QString name = only ? QString::fromStdString(only->name) : QString();
  const QString text = only ? (visible ? tr("Show %1") : tr("Hide %1")).arg(name)
                            : (visible ? tr("Show the bodies") : tr("Hide the bodies"));
  cell().commit(text, std::move(edit));
}

void CellBodies::removeSelected() {
  const std::vector<BodyId> ids(m_selection.bodies().begin(), m_selection.bodies().end());
  if (auto edit = removeBodiesEdit(cell().bodies(), ids))
    cell().commit(removeBodiesText(cell().bodies(), m_selection.bodies()), std::move(edit));
}

void CellBodies::mountSelected() {
  const RobotModel& robot = cell().robot().model;
  const std::uint32_t flange = activeArm(cell().robot(), *cell().plans()).flange;
  auto edit = mountEdit(cell().bodies(), selected()->id, flange, robot);
  if (!edit) return report(cell(), edit.error());
  if (!*edit) return m_parts.log.add(tr("Nothing has changed"));
  const BodyId id = selected()->id;
  const QString name = QString::fromStdString(selected()->name),
                link = QString::fromStdString(robot.links[flange].name);
  cell().commit(tr("Mount %1 on %2").arg(name, link), std::move(edit).value());
  Message said{Message::Weight::Info, tr("%1 was mounted on %2").arg(name, link),
               tr("The tool centre point is where it was; it is a group of fields in the panel.")};
  said.actionText = tr("Tool &centre point at its tip");
  said.action = [this, id, document = m_document] {
    if (document == m_document) setCentreAtTip(id);
  };
  said.about = &m_document->document;
  emit message(said);
}

// Turned as before.
void CellBodies::setCentreAtTip(BodyId id) {
  const BodyPointer body = cell().bodies().withId(id);
  const auto tip = body && isOnFlange(*body) ? tipOf(*body) : std::nullopt;
  if (!tip) return;
  CellPlans changed = *cell().plans();
  changed.tool.translation() = *tip;
  if (auto edit = cell().plansEdit(std::move(changed)))
    cell().commit(tr("Tool centre point at the tip of %1").arg(QString::fromStdString(body->name)), std::move(edit));
}

// kNone: they are taken off the robot. Where they are in the cell does not change.
void CellBodies::carry(const std::set<BodyId>& ids, std::uint32_t link) {
  const RobotModel& robot = cell().robot().model;
  auto edit = carryEdit(cell().bodies(), ids, link, robot, cell().joints());
  if (!edit) return report(cell(), edit.error());
  if (!*edit && link != kNone) return m_parts.log.add(tr("Nothing has changed"));
  const auto count = static_cast<int>(ids.size());
  const BodyPointer only = count == 1 ? cell().bodies().withId(*ids.begin()) : nullptr;
  const QString what = only ? QString::fromStdString(only->name) : tr("%n body(ies)", nullptr, count);
  if (!*edit) {
    Message refused{Message::Weight::Info, tr("Nothing carries %1, as before").arg(what),
                    tr("Only links of robots carry bodies; a body carries none.")};
    refused.advice = tr("Drop it on a link, or on a body that a link carries.");
    refused.about = &m_document->document;
    return emit message(refused);
  }
  cell().commit(link == kNone ? tr("Release %1").arg(what)
                              : tr("Attach %1 to %2").arg(what, QString::fromStdString(robot.links[link].name)),
                std::move(edit).value());
}

void CellBodies::rename(BodyId body, const QString& name) {
  const Status done = cell().setProperty("body." + std::to_string(body) + ".name", name.toStdString());
  if (!done) report(cell(), done.error());
}

void CellBodies::applyToSelected(const char* verb) {
  OperationValues values(bodyOperation());
  values.setValid(verb, selected()->name);
  apply(values);
}

void CellBodies::relinkSelected() {
  askForFile(tr("Link %1 to another file").arg(QString::fromStdString(selected()->name)),
             [this, id = selected()->id](const std::string& path) {
               const BodyPointer body = cell().bodies().withId(id);
               if (!body) return;
               OperationValues values(bodyOperation());
               values.setValid("update", body->name);
               values.setValid("from", path);
               apply(values);
             });
}

// Asks for the unit of the selected body; each choice gives its resulting size.
void CellBodies::askForUnit() {
  const BodyPointer body = selected();
  if (!body) return;
  constexpr LengthUnit kUnits[] = {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch};
  const Vec3 size = body->geometry->bounds().sizes();
  QStringList choices;
  for (const LengthUnit unit : kUnits) {
    choices += tr("%1: the body measures %2")
                   .arg(unitSymbol(Quantity::Length, unit),
                        sizeText(millimetresPer(unit) * size, cell().displayUnit(), QLocale()));
  }
  auto* dialog = new QInputDialog(m_parts.window);
  dialog->setObjectName(QStringLiteral("bodyUnitDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Unit of %1").arg(QString::fromStdString(body->name)));
  dialog->setLabelText(tr("Its numbers are in:"));
  dialog->setComboBoxItems(choices);
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, choices, kUnits = std::to_array(kUnits), id = body->id, document = m_document](const QString& text) {
            const auto chosen = static_cast<std::size_t>(std::max<qsizetype>(0, choices.indexOf(text)));
            if (document == m_document) scale(id, millimetresPer(kUnits[chosen]));
          });
  dialog->open();
}

// About its own origin, as its file would have been read. Large ones take their time.
void CellBodies::scale(BodyId id, double factor) {
  const BodyPointer body = cell().bodies().withId(id);
  if (!body || factor == 1.0) return;
  DocumentTab& tab = *m_document;
  Job job;
  job.name = tr("Scaling %1").arg(QString::fromStdString(body->name));
  job.document = &tab.document;
  job.work = [this, &tab, body, factor, name = job.name](Progress) -> Job::Finish {
    TriangleSoup soup = *body->geometry->surface();
    for (Vec3& point : soup.points) point *= factor;
    const double largest = factor * body->geometry->bounds().sizes().maxCoeff();
    const GeometryPointer scaled =
        isSoundSoup(soup) ? std::make_shared<const MeshGeometry>(std::move(soup)) : GeometryPointer();
    return [this, &tab, body, name, scaled, largest] {
      auto& document = static_cast<RobotCellDocument&>(tab.document);
      const BodyPointer now = document.bodies().withId(body->id);
      if (!now || now->geometry != body->geometry) return emit message(discardedResultMessage(name, document));
      if (!scaled) {
        const std::string most = shownText(MeshGeometry::kLargestCoordinate);
        return report(document, {ErrorCode::ValueOutOfRange, {body->name, shownText(largest), "0", most}, {}, {}});
      }
      Body changed = *now;
      changed.geometry = scaled;
      auto edit = changeBodyEdit(document.bodies(), std::move(changed));
      if (!edit) return report(document, edit.error());
      document.commit(tr("Change the unit of %1").arg(QString::fromStdString(now->name)), std::move(edit).value());
    };
  };
  m_parts.jobs.start(std::move(job));
}

// Reports a new body: its numbers have no unit, or it is not at the position that they give.
void CellBodies::reportAdded(BodyId id, const QString& file, bool hasUnit, bool isBeside) {
  if (hasUnit && !isBeside) return;
  const BodyPointer body = cell().bodies().withId(id);
  const QString name = QString::fromStdString(body->name),
                size = sizeText(body->geometry->bounds().sizes(), cell().displayUnit(), QLocale());
  Message said{Message::Weight::Info, tr("%1 was placed beside the others").arg(name)};
  QStringList details;
  if (!hasUnit) {
    said.weight = Message::Weight::Warning;
    said.title = tr("%1 measures %2").arg(name, size);
    details += tr("%1 has no unit; its numbers were taken as millimetres.").arg(file);
  }
  if (isBeside)
    details += tr("Where its file says, it would be inside something else: it was placed beside the others.");
  said.detail = details.join(QLatin1Char(' '));
  said.about = &m_document->document;
  if (!hasUnit && m_unit.isEnabled()) {
    said.actionText = tr("Choose the unit…");
    said.action = [this, id, document = m_document] {
      if (document != m_document) return;
      m_selection.select(id);
      askForUnit();
    };
  }
  if (isBeside) {
    const bool isFirst = said.actionText.isEmpty();
    (isFirst ? said.actionText : said.otherText) = tr("&Place it where its file says");
    (isFirst ? said.action : said.other) = [this, id, document = m_document] {
      if (document == m_document) placeAsInFile(id);
    };
  }
  emit message(said);
}

// Files are read by a job; all else is done at once.
void CellBodies::apply(const OperationValues& values) {
  if (readsFile(values)) return read(values);
  commit(*m_document, values, bodyChange(values, cell().bodies(), m_parts.kinds, {}));
}

// Another document may be in view when the file has been read, and the bodies may have changed: the edit is made then.
void CellBodies::read(const OperationValues& values) {
  DocumentTab& tab = *m_document;
  Job job;
  const char* const what = values.isSet("add") ? "add" : values.isSet("from") ? "from" : "update";
  const QByteArray source = QByteArray::fromStdString(values.text(what));
  job.name = tr("Reading %1").arg(QFileInfo(QFile::decodeName(source)).fileName());
  job.document = &tab.document;
  job.failed = [this, &tab](const Error& error) { report(tab.document, error); };
  job.work = [this, &tab, &kinds = m_parts.kinds, values, bodies = cell().bodies(),
              folder = folderOf(tab.document)](Progress progress) -> Job::Finish {
    auto body = std::make_shared<Result<ImportedBody>>(bodyFrom(values, bodies, kinds, folder, progress));
    return [this, &tab, placed = values, body]() mutable {
      if (!*body) return report(tab.document, body->error());
      const auto& now = static_cast<const RobotCellDocument&>(tab.document);
      // It is only moved where that is said and seen.
      const bool isBeside = &tab == m_document && standBeside(contentOf(now), (*body)->body, placed);
      commit(tab, placed, bodyChange(placed, now.bodies(), std::move(*body).value()), isBeside);
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellBodies::commit(DocumentTab& tab, const OperationValues& values, Result<BodyChange> change, bool isBeside) {
  auto& document = static_cast<RobotCellDocument&>(tab.document);
  if (!change) return report(document, change.error());
  const QString path = document.path();
  const bool isAsInFile = !path.isEmpty() && !document.isModified();
  FileLoader::logFindings(change->file, m_parts.log);
  if (!change->edit) return m_parts.log.add(tr("Nothing has changed"));
  const BodyId next = document.bodies().freeId();
  const QString text = undoTextOf(values, QString::fromStdString(change->name));
  document.commit(text, std::move(change->edit));
  m_parts.log.add(text, isAsInFile ? ownCommand(path, stepOf(values), containerBeside(path)) : QString());
  if (!values.isSet("add") || &tab != m_document) return;
  m_selection.select(next);
  emit added(next, readsFile(values));
  const QFileInfo source(QFile::decodeName(QByteArray::fromStdString(values.text("add"))));
  reportAdded(next, source.fileName(), change->file.hasUnit, isBeside);
}

void CellBodies::report(const Document& document, const Error& error) {
  if (error.code == ErrorCode::Cancelled) return;
  emit message({Message::Weight::Error,
                tr("The bodies were not changed"),
                errorSentence(error),
                errorAdvice(error),
                {},
                {},
                {},
                {},
                &document});
}

}  // namespace handwheel
