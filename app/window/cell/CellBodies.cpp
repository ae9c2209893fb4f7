// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellBodies.h"

#include "document/OperationText.h"
#include "document/cell/RobotCellDocument.h"
#include "document/scene/BodyChanges.h"
#include "panels/LogModel.h"
#include "scene/PrimitiveGeometry.h"
#include "text/ErrorText.h"
#include "window/ActionToolTip.h"
#include "window/CommandLines.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileFilters.h"
#include "window/documents/FileLoader.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

namespace handwheel {

namespace {

constexpr double kNewShape = 100.0;  // mm, each dimension of a new primitive

std::filesystem::path folderOf(const Document& document) {
  return std::filesystem::path(document.file().path).parent_path();
}

// The container that a cell is saved to; a robot description becomes one beside it.
QString containerBeside(const QString& path) {
  const QFileInfo file(path);
  return file.path() + QLatin1Char('/') + file.completeBaseName() + containerEnding();
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

QString undoTextOf(const OperationValues& values) {
  if (values.isSet("add")) return CellBodies::tr("Add a body");
  if (values.isSet("remove")) return CellBodies::tr("Remove a body");
  return values.isSet("update") ? CellBodies::tr("Read the linked file again")
                                : CellBodies::tr("Forget the linked file");
}

}  // namespace

CellBodies::CellBodies(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_shapes(new QMenu(tr("Add a &shape"), parts.window)),
      m_add(tr("&Add a body from a file…"), this),
      m_link(tr("Add a body &linked to a file…"), this),
      m_remove(tr("&Remove the body"), this),
      m_hide(tr("&Hide the body"), this),
      m_showAll(tr("Show all &bodies"), this),
      m_update(tr("Read the linked file a&gain"), this),
      m_unlink(tr("&Forget the linked file"), this) {
  prepare(m_add, "addBody", "add-mesh", tr("Put the shape of another file beside the robot"));
  prepare(m_link, "linkBody", nullptr, tr("The same, and remember the file, to read it again when it has changed"));
  prepare(m_remove, "removeBody", nullptr, tr("Remove the selected body from the cell"));
  prepare(m_hide, "hideBody", "eye-off", tr("Neither show nor feel the selected body"));
  prepare(m_showAll, "showBodies", "eye", tr("Show all bodies that are hidden"));
  prepare(m_update, "updateBody", nullptr, tr("Read the file that the selected body is linked to once more"));
  prepare(m_unlink, "unlinkBody", nullptr, tr("Keep the selected body as it is, whatever becomes of its file"));
  connect(&m_add, &QAction::triggered, this, [this] { askForFile(false); });
  connect(&m_link, &QAction::triggered, this, [this] { askForFile(true); });
  connect(&m_remove, &QAction::triggered, this, [this] { applyToSelected("remove"); });
  connect(&m_update, &QAction::triggered, this, [this] { applyToSelected("update"); });
  connect(&m_unlink, &QAction::triggered, this, [this] { applyToSelected("unlink"); });
  connect(&m_hide, &QAction::triggered, this, [this] { setVisible({selected()->id}, false, tr("Hide a body")); });
  connect(&m_showAll, &QAction::triggered, this, [this] {
    std::vector<BodyId> ids;
    for (const BodyPointer& body : cell().bodies()) ids.push_back(body->id);
    setVisible(ids, true, tr("Show all bodies"));
  });
  m_selection.whenChanged([this] {
    update();
    emit selectionChanged();
  });
  addShapes();
  update();
}

void CellBodies::addShapes() {
  for (const PrimitiveDescription& primitive : primitives()) {
    auto* action = new QAction(QCoreApplication::translate("Property", primitive.label), this);
    prepare(*action, (std::string("add-") + primitive.id).c_str(), nullptr, tr("Put such a body beside the robot"));
    connect(action, &QAction::triggered, this, [this, &primitive] { addShape(primitive); });
    m_shapes->addAction(action);
  }
}

QList<QAction*> CellBodies::all() {
  return {&m_add, &m_link, m_shapes->menuAction(), &m_remove, &m_hide, &m_showAll, &m_update, &m_unlink};
}

void CellBodies::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  m_selection.select(std::nullopt);
  if (document) connect(&document->document, &Document::changed, this, &CellBodies::update);
  update();
}

RobotCellDocument& CellBodies::cell() const {
  return static_cast<RobotCellDocument&>(m_document->document);
}

BodyPointer CellBodies::selected() const {
  return m_document && m_selection.body() ? cell().bodies().withId(*m_selection.body()) : nullptr;
}

void CellBodies::update() {
  const BodyPointer body = selected();
  if (!body && m_selection.body()) return m_selection.select(std::nullopt);  // it was removed
  for (QAction* action : {&m_add, &m_link, m_shapes->menuAction()}) action->setEnabled(m_document != nullptr);
  for (QAction* action : m_shapes->actions()) action->setEnabled(m_document != nullptr);  // they are commands, too
  m_showAll.setEnabled(m_document && !cell().bodies().empty());
  m_remove.setEnabled(body != nullptr);
  m_hide.setEnabled(body && body->visible);
  for (QAction* action : {&m_update, &m_unlink}) action->setEnabled(body && body->link);
}

// Beside all that is shown, on its level.
void CellBodies::addShape(const PrimitiveDescription& primitive) {
  const Document& document = m_document->document;
  const Box bounds = document.kind().display(*document.snapshot()).bounds();
  OperationValues values(bodyOperation());
  std::string what = std::string(primitive.id) + ':';
  for (std::size_t i = 0; i < primitive.dimensions.size(); ++i)
    what += (i > 0 ? "," : "") + std::to_string(static_cast<int>(kNewShape));
  values.setValid("add", what);
  const auto geometry =
      PrimitiveGeometry::make(primitive.primitive, std::vector<double>(primitive.dimensions.size(), kNewShape));
  const Box own = geometry.value()->bounds();
  if (!bounds.isEmpty())
    values.setValid(
        "at", std::vector<double>{std::ceil(bounds.max().x() - own.min().x()), 0.0, bounds.min().z() - own.min().z()});
  apply(values);
}

void CellBodies::askForFile(bool isLinked) {
  auto* dialog = new QFileDialog(m_parts.window, isLinked ? tr("Add a linked body") : tr("Add a body"),
                                 QFileInfo(m_document->document.path()).path(),
                                 openFilters(m_parts.kinds).join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("addBodyDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, isLinked, document = m_document](const QString& path) {
    if (document != m_document) return;
    OperationValues values(bodyOperation());
    values.setValid("add", QFile::encodeName(QFileInfo(path).absoluteFilePath()).toStdString());
    values.setValid("link", isLinked);
    apply(values);
  });
  dialog->open();
}

void CellBodies::setVisible(const std::vector<BodyId>& ids, bool visible, const QString& text) {
  if (auto edit = showBodiesEdit(cell().bodies(), ids, visible)) cell().commit(text, std::move(edit));
}

void CellBodies::applyToSelected(const char* verb) {
  OperationValues values(bodyOperation());
  values.setValid(verb, selected()->name);
  apply(values);
}

// Files are read by a job; all else is done at once.
void CellBodies::apply(const OperationValues& values) {
  const bool reads = values.isSet("update") || (values.isSet("add") && values.text("add").starts_with('/'));
  if (reads) return applyAfterReading(values);
  Result<BodyChange> change = bodyChange(values, cell().bodies(), m_parts.kinds, {});
  if (!change) return report(change.error());
  commit(values, std::move(change).value());
}

void CellBodies::applyAfterReading(const OperationValues& values) {
  Job job;
  job.name = undoTextOf(values);
  job.owner = m_document;
  job.failed = [this, document = m_document](const Error& error) {
    if (document == m_document) report(error);
  };
  job.work = [this, document = m_document, values, bodies = cell().bodies(),
              folder = folderOf(m_document->document)](Progress progress) -> Job::Finish {
    auto change = std::make_shared<Result<BodyChange>>(bodyChange(values, bodies, m_parts.kinds, folder, progress));
    return [this, document, values, bodies, change] {
      if (document != m_document) return;
      if (!*change) return report(change->error());
      if (cell().bodies() != bodies) return applyAfterReading(values);  // it came too late
      commit(values, std::move(*change).value());
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellBodies::commit(const OperationValues& values, BodyChange change) {
  const QString path = cell().path();
  const bool isAsInFile = !path.isEmpty() && !cell().isModified();
  FileLoader::logFindings(change.file, m_parts.log);
  if (!change.edit) return m_parts.log.add(tr("Nothing has changed"));
  const BodyId next = cell().bodies().freeId();
  const QString text = undoTextOf(values);
  cell().commit(text, std::move(change.edit));
  if (values.isSet("add")) m_selection.select(next);
  m_parts.log.add(text, isAsInFile ? ownCommand(path, stepOf(values), containerBeside(path)) : QString());
}

void CellBodies::report(const Error& error) {
  if (error.code == ErrorCode::Cancelled) return;
  emit message({Message::Weight::Error,
                tr("The bodies stay as they are"),
                errorSentence(error),
                errorAdvice(error),
                {},
                {},
                {},
                {},
                &m_document->document});
}

}  // namespace handwheel
