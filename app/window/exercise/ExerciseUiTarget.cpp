// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The target of an exercise: from a file, from the work that was begun, in round sizes. Each is one undo step.
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "text/NoteText.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/exercise/ExerciseUi.h"
#include "window/exercise/RoundTargetDialog.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

namespace handwheel {

void ExerciseUi::askForTarget() {
  QStringList patterns;
  for (const std::string& ending : current()->exercise().subject->targetEndings())
    patterns << QLatin1Char('*') + QString::fromStdString(ending);
  auto* dialog = new QFileDialog(parts().window, tr("Import a target"), QFileInfo(current()->path()).path(),
                                 tr("Turned parts (%1)").arg(patterns.join(QLatin1Char(' '))));
  dialog->setObjectName(QStringLiteral("exerciseTargetDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, owner = document()](const QString& path) { importTarget(owner, path); });
  dialog->open();
}

void ExerciseUi::importTarget(DocumentTab* owner, const QString& path) {
  if (!parts().tabs.contains(owner)) return;
  const QString name = QFileInfo(path).fileName();
  Job job;
  job.name = tr("Reading %1").arg(name);
  job.owner = owner;
  job.failed = [this, name](const Error& error) {
    if (error.code != ErrorCode::Cancelled) report(tr("%1 was not taken as the target").arg(name), error);
  };
  job.work = [this, owner, path, name, exercise = static_cast<ExerciseDocument&>(owner->document).exercise(),
              failed = job.failed](Progress progress) -> Job::Finish {
    const auto imported =
        exercise.subject->withImportedTarget(*exercise.task, QFile::encodeName(path).toStdString(), progress);
    if (!imported) return [failed, error = imported.error()] { failed(error); };
    return [this, owner, name, before = exercise.task, made = *imported] {
      changeTarget(owner, tr("Import target"), before, made.task);
      QStringList notes;
      for (const Note& note : made.notes) notes << noteText(note);
      parts().log.add(tr("Target read from %1").arg(name));
      emit message({notes.isEmpty() ? Message::Weight::Info : Message::Weight::Warning,
                    tr("%1 is the target now").arg(name), notes.join(QLatin1Char(' ')),
                    tr("“Marks” says what is measured of it.")});
    };
  };
  parts().jobs.start(std::move(job));
}

// Where the task was changed in the meantime it stays as it is.
void ExerciseUi::changeTarget(DocumentTab* owner, const QString& text, const TaskPointer& before,
                              const TaskPointer& made) {
  if (!parts().tabs.contains(owner)) return;
  auto& exercise = static_cast<ExerciseDocument&>(owner->document);
  ExerciseSnapshot changed = exercise.exercise();
  if (changed.task != before) return;
  changed.task = made;
  exercise.change(text, std::move(changed));
}

// Lines and arcs are fitted to all of the part.
void ExerciseUi::takeTarget(const SnapshotPointer& work) {
  Job job;
  job.name = tr("Taking the target");
  job.owner = document();
  job.failed = [this](const Error& error) {
    if (error.code != ErrorCode::Cancelled) report(tr("The target was not taken"), error);
  };
  job.work = [this, work, before = snapshot(), owner = document(), failed = job.failed](Progress) -> Job::Finish {
    const Result<TaskPointer> task = before->subject->withTarget(*before->task, *work);
    if (!task) return [failed, error = task.error()] { failed(error); };
    return [this, owner, before, made = *task] { changeTarget(owner, tr("Take the target"), before->task, made); };
  };
  parts().jobs.start(std::move(job));
}

void ExerciseUi::askToRound() {
  const auto before = snapshot();
  auto* dialog = new RoundTargetDialog(*before->subject, before->task, parts().pool, parts().window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &RoundTargetDialog::chosen, current(), [this, before, owner = document()](const TaskPointer& task) {
    changeTarget(owner, tr("Round the target"), before->task, task);
  });
  dialog->open();
}

}  // namespace handwheel
