// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The actions that read and write programs of controllers.
#include "document/FileBytes.h"
#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "robot/program/PathFile.h"
#include "tools/cell/PathExport.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/documents/DocumentTab.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

namespace handwheel {

void CellPaths::askForProgram() {
  if (!checked()) return;
  QStringList filters;
  for (const auto& post : posts())
    filters += QStringLiteral("%1 (*%2)").arg(QLatin1String(post->title()), QLatin1String(post->ending()));
  const QString folder = QFileInfo(m_document->document.path()).path();
  auto* dialog = new QFileDialog(
      m_parts.window, tr("Export a robot program"),
      folder + QLatin1Char('/') + QString::fromStdString(path()->name).replace(QLatin1Char(' '), QLatin1Char('_')),
      filters.join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("exportProgramDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, filters](const QString& file) {
    const qsizetype chosen = std::max<qsizetype>(0, filters.indexOf(dialog->selectedNameFilter()));
    const Post& post = *posts()[static_cast<std::size_t>(chosen)];
    const QString ending = QLatin1String(post.ending());
    exportProgram(post, file.endsWith(ending, Qt::CaseInsensitive) ? file : file + ending);
  });
  dialog->open();
}

// Checking and reading back takes long for long paths.
void CellPaths::exportProgram(const Post& post, const QString& file) {
  const auto scene = m_collisions.scene();
  const auto known = checked();
  if (!scene || !known || !path()) return;
  Job job;
  job.name = tr("Writing %1").arg(QFileInfo(file).fileName());
  job.owner = this;
  job.failed = [this](const Error& error) { report(error); };
  job.work = [this, scene, known, plans = cell().plans(), path = *path(), &post, file](Progress) -> Job::Finish {
    auto written = writeProgram(*scene, *plans, path, *known, post, QFile::encodeName(file).toStdString());
    return [this, &post, file, written = std::move(written)] {
      if (!m_document) return;
      if (!written) return report(written.error());
      reportWritten(*written, post, file);
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellPaths::reportWritten(const WrittenProgram& written, const Post& post, const QString& file) {
  const QLocale locale;
  QString detail = tr("%Ln motion(s), read back within %1 mm.", nullptr, static_cast<int>(written.check.motions))
                       .arg(locale.toString(written.check.distance, 'g', 2));
  if (written.exactStops > 0) {
    detail += QLatin1Char(' ') + tr("%Ln blend(s) became exact stops, as their zones are not free everywhere.", nullptr,
                                    static_cast<int>(written.exactStops));
  }
  const bool isOther = !written.otherRobot.empty();
  if (isOther) {
    detail += QLatin1Char(' ') + tr("%1 is not the language of the controller of this robot, %2.")
                                     .arg(QLatin1String(post.title()), QString::fromStdString(written.otherRobot));
  }
  emit message({isOther ? Message::Weight::Warning : Message::Weight::Info,
                tr("%1 was written").arg(QFileInfo(file).fileName()),
                detail,
                {},
                {},
                {},
                {},
                {},
                &m_document->document});
}

// Poses are reached by inverse kinematics, one after the other.
void CellPaths::importProgram(const QString& file) {
  const auto scene = m_collisions.scene();
  if (!scene) return reportUnprepared();
  Job job;
  job.name = tr("Opening %1").arg(QFileInfo(file).fileName());
  job.owner = this;
  job.failed = [this](const Error& error) { report(error); };
  job.work = [this, scene, content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot()),
              file](Progress progress) -> Job::Finish {
    const std::string name = QFile::encodeName(file).toStdString();
    const Result<std::string> bytes = readFileHead(name, Post::kLargestText);
    const Post* const post = postForEnding(name);
    Result<RobotPath> read =
        !bytes ? Result<RobotPath>(bytes.error())
        : post ? pathFromProgram(*scene, *content, *post, *bytes, progress)
               : readPath(*bytes, content->robot->model, content->joints, dofsOfArm(*content->robot, scene->armNumber));
    return [this, content, file, name, read = std::move(read)]() mutable {
      if (!m_document || content->robot.get() != &cell().robot()) return;
      if (!read) {
        Error error = read.error();
        error.subject = name;
        return report(error);
      }
      CellPlans changed = plans();
      read->arm = content->plans->arm;
      read->name = changed.freePathName(QFileInfo(file).completeBaseName().toStdString());
      const PlanTree::Entry entry{PlanTree::Entry::Kind::Path, read->name};
      changed.paths.push_back(std::move(read).value());
      commit(tr("Open %1").arg(QFileInfo(file).fileName()), std::move(changed));
      m_tree->select(entry);
    };
  };
  m_parts.jobs.start(std::move(job));
}

}  // namespace handwheel
