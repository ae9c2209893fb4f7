// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The actions that read and write programs of controllers.
#include "document/cell/RobotCellDocument.h"
#include "robot/posts/PostErrors.h"
#include "text/ErrorText.h"
#include "tools/cell/path/DefaultClearance.h"
#include "tools/cell/path/ProgramRemarks.h"
#include "window/JobRunner.h"
#include "window/cell/CellPaths.h"
#include "window/cell/PathStatus.h"
#include "window/documents/DiscardedResult.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileSaver.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <span>

namespace handwheel {

namespace {

// Returns the name of a path as a file name.
QString fileNameOf(const std::string& path) {
  QString name = QString::fromStdString(path);
  for (QChar& each : name) {
    if (!each.isLetterOrNumber() && !QStringLiteral("-_.").contains(each)) each = QLatin1Char('_');
  }
  return name;
}

QString filterOf(const PostProcessor& post) {
  return QStringLiteral("%1 (*%2)").arg(QLatin1String(post.title()), QLatin1String(post.ending()));
}

const PostProcessor& postOf(const QString& filter) {
  const auto found =
      std::find_if(posts().begin(), posts().end(), [&](const auto& post) { return filterOf(*post) == filter; });
  return found == posts().end() ? *posts().front() : **found;
}

// The post whose ending ends like the name: ".json" is that of ".program.json". None: null.
const PostProcessor* postForSuffix(const QString& file) {
  const std::string suffix = '.' + QFileInfo(file).suffix().toLower().toStdString();
  const auto found = std::find_if(posts().begin(), posts().end(), [&](const auto& post) {
    return suffix.size() > 1 && std::string_view(post->ending()).ends_with(suffix);
  });
  return found == posts().end() ? nullptr : found->get();
}

// Returns the name with the ending of the post instead of that of another one.
QString withEnding(const QString& file, const PostProcessor& post) {
  qsizetype ending = 0;
  if (const PostProcessor* const whole = postForEnding(file.toStdString()))
    ending = static_cast<qsizetype>(std::string_view(whole->ending()).size());
  else if (postForSuffix(file))
    ending = QFileInfo(file).suffix().size() + 1;
  return file.chopped(ending) + QLatin1String(post.ending());
}

}  // namespace

// A path that was not verified as it is now, or that leads past its part or a target, is first said to be so.
void CellPaths::requestProgram() {
  const RobotPath* const present = path();
  if (!present) return;
  if (!scene()) return reportUnprepared();  // nothing is known of any path
  const QString name = QString::fromStdString(present->name);
  const auto known = checked();
  Message asked{.weight = Message::Weight::Warning, .title = tr("%1 is outdated").arg(name)};
  asked.about = &m_document->document;
  // About that path, whichever is selected when it is answered.
  const auto answer = [this, document = m_document, of = present->name](std::function<void()> what) {
    return [this, document, of, what = std::move(what)] {
      if (document == m_document && choosePath(of)) what();
    };
  };
  asked.isOver = [this, document = m_document, of = present->name, isKnown = known != nullptr] {
    const RobotPath* const now = static_cast<RobotCellDocument&>(document->document).plans()->path(of);
    if (!now) return true;
    if (document != m_document) return false;  // its state is looked at while it is shown
    const auto found = m_checks.of(*now);
    return found && (!isKnown || !found->outdated.isAny());
  };
  if (!known) {
    const PathStatus status = pathStatusOf(m_checks.stateOf(*present), *present, cell().displayUnit(), QLocale());
    asked.title = tr("%1 is not proven as it is now").arg(name);
    asked.detail = status.text;
    asked.advice = tr("Only what is proven free of collisions is exported.");
    asked.actionText = m_verify.text();
    asked.action = answer([this] { m_verify.trigger(); });
  } else if (known->outdated.isAny()) {
    asked.detail = outdatedSentences(known->outdated).join(QLatin1Char(' '));
    asked.actionText = tr("Plan it again");
    asked.action = answer([this] { m_again.trigger(); });
    asked.otherText = tr("Export it as it is");
    asked.other = answer([this] { askForProgram(OutdatedPath::Write); });
  } else {
    return askForProgram(OutdatedPath::Refuse);
  }
  emit message(asked);
}

// Selects a path; false: it is not there any more, or not of the robot that is planned for, which was reported.
bool CellPaths::choosePath(const std::string& name) {
  m_tree->select({PlanTree::Entry::Kind::Path, name});
  if (path() && path()->name == name) return true;
  const bool isOfOther = plans().path(name) != nullptr;
  Message gone{.weight = Message::Weight::Warning,
               .title = (isOfOther ? tr("%1 is a path of another robot") : tr("%1 is not in the plan any more"))
                            .arg(QString::fromStdString(name)),
               .detail = tr("Nothing was done.")};
  if (isOfOther) gone.advice = tr("Choose the robot of the path first.");
  gone.about = &m_document->document;
  emit message(gone);
  return false;
}

void CellPaths::askForProgram(OutdatedPath outdated) {
  const auto prepared = scene();
  if (!prepared) return reportUnprepared();
  if (!checked()) return requestProgram();  // it has changed since
  QStringList filters;
  const PostProcessor* first = nullptr;
  for (const auto& post : posts()) {
    if (!canBeWritten(*prepared, *post)) continue;  // it has a rail, say
    filters += filterOf(*post);
    if (!first) first = post.get();
  }
  const PostProcessor& ofMaker = usualPost(prepared->plannedArm());
  const PostProcessor& usual = canBeWritten(*prepared, ofMaker) || !first ? ofMaker : *first;
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
    const PostProcessor& post = postOf(filter);
    dialog->setDefaultSuffix(QLatin1String(post.ending()));
    const QStringList files = dialog->selectedFiles();
    if (!files.isEmpty()) dialog->selectFile(withEnding(QFileInfo(files.front()).fileName(), post));
  });
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, dialog, request = ProgramRequest{*path(), outdated}](const QString& file) {
            rememberFolder(file);
            exportAs(file, postOf(dialog->selectedNameFilter()), request);
          });
  dialog->open();
}

// The ending of the file decides on the language; only a name without one gets that of the chosen type.
void CellPaths::exportAs(const QString& file, const PostProcessor& ofType, const ProgramRequest& request) {
  if (const PostProcessor* const post = postForEnding(file.toStdString())) return exportProgram(*post, file, request);
  const PostProcessor* const meant = postForSuffix(file);
  const PostProcessor& chosen = meant ? *meant : ofType;
  const QString whole = withEnding(file, chosen);
  if (!QFileInfo::exists(whole)) return exportProgram(chosen, whole, request);
  emit message(
      {Message::Weight::Warning,  // the dialog has asked about another name
       tr("%1 is there already").arg(QFileInfo(whole).fileName()),
       tr("The name had no extension of a robot language, so that of %1 was added.").arg(QLatin1String(chosen.title())),
       {},
       tr("Replace it"),
       [this, whole, &chosen, request, document = m_document] {
         if (document == m_document && choosePath(request.path.name)) exportProgram(chosen, whole, request);
       },
       {},
       {},
       &m_document->document});
}

// Checking and reading back takes long for long paths.
void CellPaths::exportProgram(const PostProcessor& post, const QString& file, const ProgramRequest& request) {
  if (!m_document) return;
  const auto scene = m_collisions.scene();
  if (!scene) return reportUnprepared();
  if (!path() || !(*path() == request.path)) return reportNotWritten(request.path.name);
  if (const Status possible = canBeWritten(*scene, post); !possible) return report(m_document, possible.error());
  const auto known = checked();
  if (!known) return requestProgram();
  DocumentTab& tab = *m_document;
  Job job;
  job.name = tr("Writing %1").arg(QFileInfo(file).fileName());
  job.lane = Job::Lane::Saving;
  job.document = &tab.document;
  job.resource = file;
  // A file that is being written comes to its end, also when its document was closed meanwhile.
  const auto stillOpen = [this, of = &tab]() -> const DocumentTab* { return m_parts.tabs.contains(of) ? of : nullptr; };
  job.failed = [this, stillOpen, file](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return emit message(FileSaver::cancelledMessage(file));
    report(stillOpen(), error);
  };
  job.work = [this, stillOpen, scene, known, plans = cell().plans(), request, &post, file,
              frameData = m_declareFrame.isChecked() ? FrameData::InProgram
                                                     : FrameData::AtController](Progress) -> Job::Finish {
    const std::vector<std::size_t> leftOut = linesLeftOut(request.path, request.choices);
    auto written = writeProgram(*scene, *plans, chosen(request.path, request.choices), *known, post,
                                QFile::encodeName(file).toStdString(), {request.outdated, frameData, leftOut});
    return [this, stillOpen, &post, file, known, request, leftOut, written = std::move(written)] {
      if (!written) return reportRefused(stillOpen(), written.error(), post, file, request);
      reportWritten(stillOpen(), *written, post, file, *known, leftOut.size());
    };
  };
  m_parts.jobs.start(std::move(job));
}

// It is another one than that which was to be written.
void CellPaths::reportNotWritten(const std::string& path) {
  Message changed{.weight = Message::Weight::Warning,
                  .title = tr("%1 was not exported").arg(QString::fromStdString(path)),
                  .detail = tr("The path was changed since its export was asked for."),
                  .advice = tr("Export it again.")};
  changed.about = &m_document->document;
  emit message(changed);
}

void CellPaths::reportRefused(const DocumentTab* tab, const Error& error, const PostProcessor& post,
                              const QString& file, const ProgramRequest& request) {
  const bool areLines = error.code == PostError::LinesOfOther;
  if (!tab || (!areLines && error.code != PostError::NoCorners)) return report(tab, error);
  ProgramRequest changed = request;
  (areLines ? changed.choices.withoutLines : changed.choices.cornersAsStops) = true;
  Message refused{.weight = Message::Weight::Warning,
                  .title = tr("%1 was not exported").arg(QString::fromStdString(request.path.name)),
                  .detail = errorSentence(error),
                  .advice = errorAdvice(error),
                  .actionText = areLines ? tr("Write it without these lines") : tr("Write exact stops instead")};
  refused.action = [this, changed, &post, file, tab] {
    if (tab == m_document && choosePath(changed.path.name)) exportProgram(post, file, changed);
  };
  refused.about = &tab->document;
  emit message(refused);
}

void CellPaths::reportWritten(const DocumentTab* tab, const WrittenProgram& written, const PostProcessor& post,
                              const QString& file, const CheckedPath& checked, std::size_t leftOut) {
  const QLocale locale;
  QString detail = tr("%Ln motion(s), read back within %1 mm.", nullptr, static_cast<int>(written.check.motions))
                       .arg(locale.toString(written.check.distance, 'g', 2));
  if (written.exactStops > 0) {
    detail +=
        QLatin1Char(' ') + tr("%Ln blend(s) became exact stops, as not every way within their zones is proven free.",
                              nullptr, static_cast<int>(written.exactStops));
  }
  if (written.stopsOfLanguage > 0) {
    detail += QLatin1Char(' ') + tr("%Ln blend(s) became exact stops, as %1 has none there; the program takes about "
                                    "%2 s.",
                                    nullptr, static_cast<int>(written.stopsOfLanguage))
                                     .arg(QLatin1String(post.title()), locale.toString(written.seconds, 'f', 1));
  }
  if (leftOut > 0) {
    detail +=
        QLatin1Char(' ') + tr("%Ln line(s) of the opened program, as outputs and waiting, were left out: the head "
                              "of the program has their numbers.",
                              nullptr, static_cast<int>(leftOut));
  }
  if (!written.smaller.empty()) {
    detail +=
        QLatin1Char(' ') +
        tr("%Ln blend(s) became smaller: a blend has half of the shorter motion beside it at most, and only where it "
           "is proven free.",
           nullptr, static_cast<int>(written.smaller.size()));
  }
  if (const QString pairs = notCheckedText(checked.notChecked); !pairs.isEmpty())
    detail += QLatin1Char(' ') + tr("Not checked, as they may touch: %1.").arg(pairs);
  if (!written.frame.empty())
    detail += QLatin1Char(' ') + tr("Its places are in the frame %1.").arg(QString::fromStdString(written.frame));
  const bool isOther = !written.otherRobot.empty();
  if (isOther) {
    detail += QLatin1Char(' ') + tr("%1 is not the language of the controller of this robot, %2.")
                                     .arg(QLatin1String(post.title()), QString::fromStdString(written.otherRobot));
  }
  const OutdatedReasons& outdated = checked.outdated;
  for (const QString& reason : outdatedSentences(outdated)) detail += QLatin1Char(' ') + reason;
  if (outdated.isAny()) detail += QLatin1Char(' ') + tr("A comment of the program says so.");
  emit message({isOther || outdated.isAny() || leftOut > 0 ? Message::Weight::Warning : Message::Weight::Info,
                tr("%1 was written").arg(QFileInfo(file).fileName()),
                detail,
                {},
                {},
                {},
                {},
                {},
                tab ? &tab->document : nullptr});
}

// Poses are reached by inverse kinematics, one after the other.
void CellPaths::importProgram(const QString& file) {
  const auto scene = m_collisions.scene();
  if (!scene) return reportUnprepared();
  DocumentTab& tab = *m_document;
  Job job;
  job.name = tr("Opening %1").arg(QFileInfo(file).fileName());
  job.document = &tab.document;
  job.failed = [this, &tab](const Error& error) { report(&tab, error); };
  job.work = [this, &tab, scene, name = job.name,
              content = std::static_pointer_cast<const RobotCellSnapshot>(cell().snapshot()),
              file](Progress progress) -> Job::Finish {
    Result<ProgramPath> read = pathFromFile(*scene, *content, QFile::encodeName(file).toStdString(), progress);
    return [this, &tab, content, file, name, read = std::move(read)]() mutable {
      if (content->robot.get() != &cellIn(tab).robot()) return emit message(discardedResultMessage(name, tab.document));
      if (!read) return report(&tab, read.error());
      CellPlans changed = *cellIn(tab).plans();
      const QStringList remarks = programRemarks(*read, content->plans->tool);
      RobotPath& path = read->path;
      path.name = changed.freePathName(QFileInfo(file).completeBaseName().toStdString());
      const double offered = defaultClearance(cellIn(tab).robot(), changed);
      path.clearance = changed.ownClearance(path.clearance.value_or(offered));
      const PlanTree::Entry entry{PlanTree::Entry::Kind::Path, path.name};
      const TakenFrames frames =
          takeProgram(std::move(read).value(), cellIn(tab).robot(), cellIn(tab).placement(), changed);
      commit(tab, tr("Open %1").arg(QFileInfo(file).fileName()), std::move(changed));
      select(tab, entry);
      reportOpened(tab, file, frames, remarks);
    };
  };
  m_parts.jobs.start(std::move(job));
}

// Says nothing if the waypoints are relative to the base of the robot, and the path follows the program exactly.
void CellPaths::reportOpened(DocumentTab& tab, const QString& file, const TakenFrames& frames,
                             const QStringList& remarks) {
  const auto listed = [](const std::vector<std::string>& names) {
    QStringList list;
    for (const std::string& name : names) list += QString::fromStdString(name);
    return list.join(QStringLiteral(", "));
  };
  QStringList detail = remarks;
  if (!frames.made.empty()) detail += tr("Its frames are in the cell now: %1.").arg(listed(frames.made));
  if (!frames.used.empty()) detail += tr("It is in frames of the cell: %1.").arg(listed(frames.used));
  if (!frames.leftOut.empty())
    detail += tr("There are too many frames in the cell for these: %1.").arg(listed(frames.leftOut));
  if (detail.isEmpty()) return;
  // One that is worked in need not be chosen.
  const std::string worksIn = cellIn(tab).plans()->workFrame;
  const auto isOther = [&](const std::string& frame) { return frame != worksIn; };
  const bool hasOther = std::ranges::any_of(frames.made, isOther) || std::ranges::any_of(frames.used, isOther);
  const bool isSound = remarks.isEmpty() && frames.leftOut.empty();
  Message opened{
      .weight = isSound ? Message::Weight::Info : Message::Weight::Warning,
      .title = tr("%1 was opened").arg(QFileInfo(file).fileName()),
      .detail = detail.join(QLatin1Char(' ')),
      .advice = hasOther ? tr("To write programs in one of its frames again, choose to work in it.") : QString()};
  opened.about = &tab.document;
  emit message(opened);
}

}  // namespace handwheel
