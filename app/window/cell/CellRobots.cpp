// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/cell/CellRobots.h"

#include "document/cell/CellArms.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellImport.h"
#include "document/cell/RobotCellDocument.h"
#include "document/cell/RobotChanges.h"
#include "panels/LogModel.h"
#include "robot/dh/DhTable.h"
#include "text/ErrorText.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileLoader.h"

#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

std::shared_ptr<const RobotCellSnapshot> snapshotOfCell(const Document& document) {
  return std::static_pointer_cast<const RobotCellSnapshot>(document.snapshot());
}

Box boundsOf(const RobotCellSnapshot& cell, const JointValues& joints) {
  return displayOf(*cell.robot, joints, cell.bodies).bounds();
}

// Beside all that is there, along x.
Pose freePose(const RobotCellSnapshot& cell, const RobotCellSnapshot& robot) {
  const Box there = boundsOf(cell, cell.joints), own = boundsOf(robot, robot.joints);
  Pose base = Pose::Identity();
  if (!there.isEmpty() && !own.isEmpty()) base.translation().x() = std::ceil(there.max().x() - own.min().x());
  return base;
}

}  // namespace

void askForLibraryRobot(QWidget* window, const QString& title, QObject* receiver,
                        const std::function<void(const char* id)>& chosen) {
  QStringList titles;
  for (const LibraryRobot& robot : robotLibrary()) titles += QString::fromUtf8(robot.title);
  auto* dialog = new QInputDialog(window);
  dialog->setObjectName(QStringLiteral("builtInRobotDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  dialog->setLabelText(CellRobots::tr("Robot:"));
  dialog->setComboBoxItems(titles);
  QObject::connect(dialog, &QInputDialog::textValueSelected, receiver, [chosen, titles](const QString& text) {
    chosen(robotLibrary()[static_cast<std::size_t>(std::max<qsizetype>(0, titles.indexOf(text)))].id);
  });
  dialog->open();
}

CellRobots::CellRobots(const WindowContext& parts, std::function<std::string()> selected, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_selected(std::move(selected)),
      m_add(tr("Add a robot from a &file…"), this),
      m_addBuiltIn(tr("Add a bu&ilt-in robot…"), this),
      m_remove(tr("Remo&ve the robot"), this),
      m_box(new QComboBox(parts.window)) {
  prepare(m_add, "addRobot", nullptr,
          tr("Add another robot to the cell, by its URDF or a table after Denavit and Hartenberg"));
  prepare(m_addBuiltIn, "addBuiltInRobot", nullptr, tr("Add another robot to the cell from the library"));
  prepare(m_remove, "removeRobot", nullptr,
          tr("Remove the selected robot, or else the one to plan for, with its configurations and paths"));
  m_box->setObjectName(QStringLiteral("armBox"));
  m_box->setAccessibleName(tr("Robot to plan for"));
  m_box->setToolTip(tr("The robot to plan for; the others stay where they are"));
  connect(&m_add, &QAction::triggered, this, &CellRobots::askForFile);
  connect(&m_addBuiltIn, &QAction::triggered, this, &CellRobots::askForBuiltIn);
  connect(&m_remove, &QAction::triggered, this, [this] {
    const std::string name = m_selected();
    remove(armNumber(cell().robot(), name) && !name.empty() ? name : activeArm(cell().robot(), *cell().plans()).name);
  });
  connect(m_box, &QComboBox::activated, this, [this](int index) { choose(m_box->itemText(index).toStdString()); });
  update();
}

void CellRobots::setDocument(DocumentTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  if (document) connect(&document->document, &Document::changed, this, &CellRobots::update);
  update();
}

RobotCellDocument& CellRobots::cell() const {
  return static_cast<RobotCellDocument&>(m_document->document);
}

void CellRobots::update() {
  const QSignalBlocker quiet(m_box);
  const QString noCell = tr("Open a robot cell first.");
  const bool isCell = m_document != nullptr;
  const bool areSeveral = isCell && cell().robot().arms.size() > 1;
  offer(m_add, isCell, noCell);
  offer(m_addBuiltIn, isCell, noCell);
  offer(m_remove, areSeveral, isCell ? tr("It is the only robot of the cell.") : noCell);
  m_box->setVisible(areSeveral);
  m_box->clear();
  if (!isCell) return;
  for (const RobotArm& arm : cell().robot().arms) m_box->addItem(QString::fromStdString(arm.name));
  m_box->setCurrentIndex(static_cast<int>(activeArmNumber(cell().robot(), *cell().plans())));
}

void CellRobots::choose(const std::string& name) {
  if (!m_document) return;
  Result<CellPlans> plans = withArmChosen(cell().robot(), *cell().plans(), name);
  if (!plans) return report(cell(), plans.error());
  if (auto edit = cell().plansEdit(std::move(plans).value()))
    cell().commit(tr("Plan for %1").arg(QString::fromStdString(name)), std::move(edit));
}

void CellRobots::remove(const std::string& name) {
  const auto number = m_document ? armNumber(cell().robot(), name) : std::nullopt;
  if (!number) return;
  Result<RobotCellSnapshot> changed = withRobotRemoved(*snapshotOfCell(cell()), *number);
  if (!changed) return report(cell(), changed.error());
  const auto before = cell().plans();
  const std::size_t configurations = before->configurations.size() - changed->plans->configurations.size();
  const std::size_t paths = before->paths.size() - changed->plans->paths.size();
  cell().commit(tr("Remove the robot %1").arg(QString::fromStdString(name)),
                cell().robotsEdit(std::move(changed).value()));
  emit message(
      {Message::Weight::Info,
       tr("%1 was removed").arg(QString::fromStdString(name)),
       tr("%1 configurations and %2 paths were removed with it. Undo restores them.").arg(configurations).arg(paths),
       {},
       {},
       {},
       {},
       {},
       &m_document->document});
}

void CellRobots::askForFile() {
  QFileDialog* const dialog = openingDialog(m_parts.window, m_document->document, tr("Add a robot"),
                                            tr("Robots (*.urdf *.dh.json);;All files (*)"));
  dialog->setObjectName(QStringLiteral("addRobotDialog"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (document != m_document) return;
    const std::string name = QFile::encodeName(path).toStdString();
    const DocumentKind* const kind = m_parts.kinds.withId("cell");
    add(QFileInfo(path).fileName(), [kind, name](Progress progress) {
      Result<OpenedFile> imported = kind->import(name, {}, progress);
      if (imported) return imported;
      Error error = imported.error();
      if (error.subject.empty()) error.subject = name;
      return Result<OpenedFile>(std::move(error));
    });
  });
  dialog->open();
}

void CellRobots::askForBuiltIn() {
  askForLibraryRobot(m_parts.window, tr("Add a robot"), this, [this, document = m_document](const char* id) {
    if (document != m_document) return;
    add(QString::fromUtf8(id), [id](Progress) -> Result<OpenedFile> {
      OpenedFile opened;
      opened.content = cellOf(*libraryTable(id));
      return opened;
    });
  });
}

// Another document may be in view when the robot has been read, and the cell may have changed: it is added to what is
// there then.
void CellRobots::add(const QString& what, Reading reading) {
  DocumentTab& tab = *m_document;
  Job job;
  job.name = tr("Reading %1").arg(what);
  job.document = &tab.document;
  job.failed = [this, &tab](const Error& error) { report(tab.document, error); };
  job.work = [this, &tab, reading = std::move(reading)](Progress progress) -> Job::Finish {
    auto read = std::make_shared<Result<OpenedFile>>(reading(progress));
    return [this, &tab, read] {
      if (!*read) return report(tab.document, read->error());
      FileLoader::logFindings(read->value().file, m_parts.log);
      addTo(tab, std::static_pointer_cast<const RobotCellSnapshot>(read->value().content));
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellRobots::addTo(DocumentTab& tab, const std::shared_ptr<const RobotCellSnapshot>& robot) {
  auto& document = static_cast<RobotCellDocument&>(tab.document);
  const auto now = snapshotOfCell(document);
  Result<RobotCellSnapshot> changed = withRobotAdded(*now, {robot, {}, freePose(*now, *robot)});
  if (!changed) return report(document, changed.error());
  const QString text = tr("Add the robot %1").arg(QString::fromStdString(changed->robot->arms.back().name));
  document.commit(text, document.robotsEdit(std::move(changed).value()));
  m_parts.log.add(text);
  if (&tab == m_document) emit added();
}

void CellRobots::report(const Document& document, const Error& error) {
  if (error.code == ErrorCode::Cancelled) return;
  emit message({Message::Weight::Error,
                tr("The robots were not changed"),
                errorSentence(error),
                errorAdvice(error),
                {},
                {},
                {},
                {},
                &document});
}

}  // namespace handwheel
