// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The actions that read and write programs of controllers.
#include "document/FileBytes.h"
#include "document/cell/CellArms.h"
#include "document/cell/RobotCellDocument.h"
#include "robot/program/PathFile.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/cell/PathRemark.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileDialogs.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>

namespace handwheel {

namespace {

// As the name of a file.
QString fileNameOf(const std::string& path) {
  QString name = QString::fromStdString(path);
  for (QChar& each : name) {
    if (!each.isLetterOrNumber() && !QStringLiteral("-_.").contains(each)) each = QLatin1Char('_');
  }
  return name;
}

QString filterOf(const Post& post) {
  return QStringLiteral("%1 (*%2)").arg(QLatin1String(post.title()), QLatin1String(post.ending()));
}

const Post& postOf(const QString& filter) {
  const auto found =
      std::find_if(posts().begin(), posts().end(), [&](const auto& post) { return filterOf(*post) == filter; });
  return found == posts().end() ? *posts().front() : **found;
}

// The name with the ending of the post, in place of that of another.
QString withEnding(const QString& file, const Post& post) {
  const Post* const other = postForEnding(file.toStdString());
  const qsizetype ending = other ? static_cast<qsizetype>(std::string_view(other->ending()).size()) : 0;
  return file.chopped(ending) + QLatin1String(post.ending());
}

}  // namespace

// A path that was not verified as it is now, or that leads past its part, is first said to be so.
void CellPaths::requestProgram() {
  const RobotPath* const present = path();
  if (!present) return;
  const QString name = QString::fromStdString(present->name);
  const auto known = checked();
  Message asked{.weight = Message::Weight::Warning, .title = tr("%1 is outdated").arg(name)};
  asked.about = &m_document->document;
  // About that path, whichever is selected when it is answered.
  const auto answer = [this, document = m_document,
                       row = PlanTree::Entry{PlanTree::Entry::Kind::Path, present->name}](std::function<void()> what) {
    return [this, document, row, what = std::move(what)] {
      if (document != m_document) return;
      m_tree->select(row);
      what();
    };
  };
  if (!known) {
    const PathRemark remark = remarkOf(m_checks.stateOf(*present), *present, cell().displayUnit(), QLocale());
    asked.title = tr("%1 is not proven as it is now").arg(name);
    asked.detail = remark.text;
    asked.advice = tr("Only what is proven free of collisions is exported.");
    asked.actionText = m_verify.text();
    asked.action = answer([this] { m_verify.trigger(); });
  } else if (!known->partMoved.empty()) {
    asked.detail = tr("It leads along the curve where %1 was when it was planned: the tool does not meet it any more.")
                       .arg(QString::fromStdString(known->partMoved));
    asked.actionText = tr("Plan it again");
    asked.action = answer([this] { m_again.trigger(); });
    asked.otherText = tr("Export it as it is");
    asked.other = answer([this] { askForProgram(OutdatedPath::Write); });
  } else {
    return askForProgram(OutdatedPath::Refuse);
  }
  emit message(asked);
}

void CellPaths::askForProgram(OutdatedPath outdated) {
  const auto prepared = scene();
  if (!checked() || !prepared) return;
  QStringList filters;
  for (const auto& post : posts()) filters += filterOf(*post);
  const Post& usual = usualPost(prepared->plannedArm());
  auto* dialog = new QFileDialog(m_parts.window, tr("Export a robot program"), folderFor(m_document->document),
                                 filters.join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("exportProgramDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setLabelText(QFileDialog::LookIn, tr("Save in:"));
  dialog->selectNameFilter(filterOf(usual));
  dialog->setDefaultSuffix(QLatin1String(usual.ending()));
  dialog->selectFile(withEnding(fileNameOf(path()->name), usual));
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    const Post& post = postOf(filter);
    dialog->setDefaultSuffix(QLatin1String(post.ending()));
    const QStringList files = dialog->selectedFiles();
    if (!files.isEmpty()) dialog->selectFile(withEnding(QFileInfo(files.front()).fileName(), post));
  });
  connect(dialog, &QFileDialog::fileSelected, this, [this, dialog, outdated](const QString& file) {
    rememberFolder(file);
    exportAs(file, postOf(dialog->selectedNameFilter()), outdated);
  });
  dialog->open();
}

// The ending of the file tells the language; only a name without one gets that of the chosen type.
void CellPaths::exportAs(const QString& file, const Post& chosen, OutdatedPath outdated) {
  if (const Post* const post = postForEnding(file.toStdString())) return exportProgram(*post, file, outdated);
  const QString whole = withEnding(file, chosen);
  if (!QFileInfo::exists(whole)) return exportProgram(chosen, whole, outdated);
  emit message(
      {Message::Weight::Warning,  // the dialog has asked about another name
       tr("%1 is there already").arg(QFileInfo(whole).fileName()),
       tr("The name had no extension of a robot language, so that of %1 was added.").arg(QLatin1String(chosen.title())),
       {},
       tr("Replace it"),
       [this, whole, &chosen, outdated, document = m_document] {
         if (document == m_document) exportProgram(chosen, whole, outdated);
       },
       {},
       {},
       &m_document->document});
}

// Checking and reading back takes long for long paths.
void CellPaths::exportProgram(const Post& post, const QString& file, OutdatedPath outdated) {
  const auto scene = m_collisions.scene();
  const auto known = checked();
  if (!scene || !known || !path()) return;
  Job job;
  job.name = tr("Writing %1").arg(QFileInfo(file).fileName());
  job.owner = this;
  job.failed = [this](const Error& error) { report(error); };
  job.work = [this, scene, known, plans = cell().plans(), path = *path(), &post, file,
              outdated](Progress) -> Job::Finish {
    auto written = writeProgram(*scene, *plans, path, *known, post, QFile::encodeName(file).toStdString(), outdated);
    return [this, &post, file, partMoved = known->partMoved, written = std::move(written)] {
      if (!m_document) return;
      if (!written) return report(written.error());
      reportWritten(*written, post, file, QString::fromStdString(partMoved));
    };
  };
  m_parts.jobs.start(std::move(job));
}

void CellPaths::reportWritten(const WrittenProgram& written, const Post& post, const QString& file,
                              const QString& partMoved) {
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
  if (!partMoved.isEmpty()) {
    detail += QLatin1Char(' ') +
              tr("It follows the curve at the former position of %1: a comment of the program says so.").arg(partMoved);
  }
  emit message({isOther || !partMoved.isEmpty() ? Message::Weight::Warning : Message::Weight::Info,
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
