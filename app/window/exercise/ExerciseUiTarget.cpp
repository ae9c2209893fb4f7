// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The target of an exercise: from a file, from the work that was begun, in round sizes. Each is one undo step.
#include "controls/property/PropertyDialog.h"
#include "document/exercise/ExerciseDocument.h"
#include "document/exercise/ExerciseRows.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "text/NoteText.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/exercise/ExerciseUi.h"
#include "window/exercise/RoundTargetDialog.h"
#include "window/kinds/TargetPlacementView.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QPointer>

namespace handwheel {

void ExerciseUi::askForTarget() {
  QStringList patterns;
  const ExerciseSubject& subject = *current()->exercise().subject;
  for (const std::string& ending : subject.targetEndings())
    patterns << QLatin1Char('*') + QString::fromStdString(ending);
  auto* dialog = new QFileDialog(parts().window, tr("Import a target"), QString(),
                                 (subject.isTurned() ? tr("Turned parts (%1)") : tr("Parts to be drilled (%1)"))
                                     .arg(patterns.join(QLatin1Char(' '))));
  dialog->setObjectName(QStringLiteral("exerciseTargetDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  beginInFolderOf(*dialog, QStringLiteral("targets"));
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, owner = document()](const QString& path) { importTarget(owner, path); });
  dialog->open();
}

void ExerciseUi::importTarget(DocumentTab* owner, const QString& path) {
  if (!parts().tabs.contains(owner)) return;
  const QString name = QFileInfo(path).fileName();
  Job job;
  job.name = tr("Reading %1").arg(name);
  job.document = &owner->document;
  job.failed = [this, name](const Error& error) {
    if (error.code != ErrorCode::Cancelled) report(tr("%1 was not taken as the target").arg(name), error);
  };
  job.work = [this, owner, path, name, exercise = static_cast<ExerciseDocument&>(owner->document).exercise(),
              failed = job.failed](Progress progress) -> Job::Finish {
    const auto imported =
        exercise.subject->withImportedTarget(*exercise.task, QFile::encodeName(path).toStdString(), {}, progress);
    if (!imported) return [failed, error = imported.error()] { failed(error); };
    return [this, owner, name, before = exercise.task, made = *imported] { askForPosition(owner, name, before, made); };
  };
  parts().jobs.start(std::move(job));
}

// The dialog changes its own copy of the task.
void ExerciseUi::askForPosition(DocumentTab* owner, const QString& name, const TaskPointer& before,
                                const ExerciseSubject::ImportedTask& imported) {
  if (!parts().tabs.contains(owner)) return;
  const auto task = std::make_shared<TaskPointer>(imported.task);
  const ExerciseSubject& subject = *static_cast<ExerciseDocument&>(owner->document).exercise().subject;
  // The notes concern the position that is in the fields at that time.
  const auto intro = [task, &subject, ofFile = imported.notes] {
    QStringList notes;
    for (const std::vector<Note>& of : {subject.fitNotes(**task), ofFile})
      for (const Note& note : of) notes << noteText(note);
    if (const auto ends = subject.endsNote(**task)) notes << noteText(*ends);
    return notes.join(QLatin1Char('\n'));
  };
  const auto shownDialog = std::make_shared<QPointer<PropertyDialog>>();
  auto* view = new TargetPlacementView;
  const auto showPosition = [task, &subject, intro, shownDialog, view] {
    if (!*shownDialog) return;
    (*shownDialog)->setIntro(intro());
    view->setPicture(subject.targetPicture(**task));
  };
  auto* dialog = new PropertyDialog(
      {tr("Where the target lies"), intro(), tr("&Import")},
      [task, &subject, group = imported.positionGroup] {
        std::vector<Property> shown = subject.properties(**task);
        std::erase_if(shown, [&](const Property& each) { return each.group != group; });
        return shown;
      },
      [task, &subject, showPosition](const std::string& id, const PropertyValue& value) -> Status {
        Result<TaskPointer> changed = subject.withProperty(**task, id, value);
        if (!changed) return changed.error();
        *task = std::move(*changed);
        showPosition();
        return Done{};
      },
      parts().window);
  *shownDialog = dialog;
  dialog->addView(view);
  connect(view, &TargetPlacementView::turned, dialog, [task, &subject, showPosition, dialog] {
    Result<TaskPointer> turned = subject.withTurnedTarget(**task);
    if (!turned) return;  // there is no picture of it, and no button
    *task = std::move(*turned);
    showPosition();
    dialog->refresh();
  });
  showPosition();
  dialog->setObjectName(QStringLiteral("targetPlaceDialog"));
  dialog->setModal(true);
  connect(dialog, &QDialog::accepted, this, [this, owner, name, before, task, isTurned = subject.isTurned()] {
    if (!changeTarget(owner, tr("Import target"), before, *task)) {
      emit message({Message::Weight::Warning, tr("%1 was not taken as the target").arg(name),
                    tr("The exercise was changed meanwhile."), tr("Import the target again.")});
      return;
    }
    parts().log.add(tr("Target read from %1").arg(name));
    Message taken{Message::Weight::Info,
                  tr("%1 is the target now").arg(name),
                  {},
                  isTurned ? tr("“Task” shows where it lies in the bar, “Criteria” what is measured.")
                           : tr("“Task” has the planned path and the forbidden region, “Criteria” what is measured.")};
    sayWhileTarget(std::move(taken), owner, *task);
  });
  dialog->open();
}

// Changes nothing if the task was changed in the meantime.
bool ExerciseUi::changeTarget(DocumentTab* owner, const QString& text, const TaskPointer& before,
                              const TaskPointer& made) {
  if (!parts().tabs.contains(owner)) return false;
  auto& exercise = static_cast<ExerciseDocument&>(owner->document);
  ExerciseSnapshot changed = exercise.exercise();
  if (changed.task != before) return false;
  changed.task = made;
  exercise.change(text, std::move(changed));
  return true;
}

// Lines and arcs are fitted to all of the part.
void ExerciseUi::takeTarget(const SnapshotPointer& work) {
  Job job;
  job.name = tr("Taking the target");
  job.document = &document()->document;
  job.failed = [this](const Error& error) {
    if (error.code != ErrorCode::Cancelled) report(tr("The target was not taken"), error);
  };
  job.work = [this, work, before = snapshot(), owner = document(), failed = job.failed](Progress) -> Job::Finish {
    const Result<TaskPointer> task = before->subject->withTarget(*before->task, *work);
    if (!task) return [failed, error = task.error()] { failed(error); };
    return [this, owner, before, made = *task] {
      if (changeTarget(owner, tr("Take the target"), before->task, made)) sayOffTarget(owner, made);
    };
  };
  parts().jobs.start(std::move(job));
}

// The sizes that are marked stay where they are measured, which is said.
void ExerciseUi::turnTarget() {
  const auto before = snapshot();
  const Result<TaskPointer> turned = before->subject->withTurnedTarget(*before->task);
  if (!turned) return report(tr("The target was not turned"), turned.error());
  changeTarget(document(), tr("Turn the target end for end"), before->task, *turned);
  Message done{Message::Weight::Info, tr("The target lies the other way round now")};
  if (const auto ends = before->subject->endsNote(**turned)) done.detail = noteText(*ends);
  done.advice = tr("“Criteria” are measured at the places where they were: look at them.");
  sayWhileTarget(std::move(done), document(), *turned);
}

// Marks that were made for another target cannot be met by one who turns this one.
void ExerciseUi::sayOffTarget(DocumentTab* owner, const TaskPointer& task) {
  if (offTargetNote(static_cast<ExerciseDocument&>(owner->document).exercise()))
    sayWhileTarget({Message::Weight::Warning, tr("The exercise has another target now")}, owner, task);
}

// Undo makes it untrue. Marks that do not fit the target are named.
void ExerciseUi::sayWhileTarget(Message said, DocumentTab* owner, const TaskPointer& task) {
  if (const auto off = offTargetNote(static_cast<ExerciseDocument&>(owner->document).exercise())) {
    said.weight = Message::Weight::Warning;
    said.detail += (said.detail.isEmpty() ? QString() : QStringLiteral(" ")) + noteText(*off);
  }
  said.about = &owner->document;
  said.isOver = [exercise = QPointer<const ExerciseDocument>(static_cast<ExerciseDocument*>(&owner->document)), task] {
    return !exercise || exercise->exercise().task != task;
  };
  emit message(said);
}

void ExerciseUi::askToRound() {
  const auto before = snapshot();
  auto* dialog = new RoundTargetDialog(*before->subject, before->task, parts().pool, parts().window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RoundTargetDialog::chosen, current(), [this, before, owner = document()](const TaskPointer& task) {
    if (changeTarget(owner, tr("Round the target"), before->task, task)) sayOffTarget(owner, task);
  });
  dialog->open();
}

}  // namespace handwheel
