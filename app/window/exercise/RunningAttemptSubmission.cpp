// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Handing in the work on an exercise.
#include "document/exercise/ExerciseDocument.h"
#include "document/exercise/Submission.h"
#include "panels/MessageBar.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileSaver.h"
#include "window/exercise/ReasonText.h"
#include "window/exercise/RunningAttempt.h"
#include "window/kinds/SuggestedName.h"

#include <QFile>
#include <QFileDialog>
#include <algorithm>

namespace handwheel {

namespace {

// Returns the reasons why figures of the work could not be measured, each once, with the names of the marks before it.
QStringList unmeasured(const Exercise& exercise, const Marking& marking) {
  std::vector<std::pair<QString, QStringList>> reasons;
  for (const Mark& mark : marking.marks) {
    if (mark.verdict != Verdict::NotMeasured || mark.remark.text.empty()) continue;
    const QString reason = exerciseText(mark.remark);
    auto same = std::find_if(reasons.begin(), reasons.end(), [&](const auto& each) { return each.first == reason; });
    if (same == reasons.end()) same = reasons.insert(same, {reason, {}});
    const MarkingCriterion* const c = exercise.find(mark.criterion);
    same->second += QString::fromStdString(c && !c->name.empty() ? c->name : mark.criterion);
  }
  QStringList sentences;
  for (const auto& [reason, names] : reasons) sentences += names.join(QStringLiteral(", ")) + ": " + reason;
  return sentences;
}

}  // namespace

void RunningAttempt::handIn() {
  auto* dialog = new QFileDialog(m_parts.window, tr("Hand in"), QString(),
                                 tr("Handwheel documents (%1)").arg(QStringLiteral("*.handwheel")));
  dialog->setObjectName(QStringLiteral("handInDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("handwheel"));
  beginInFolderOf(*dialog, QStringLiteral("handIn"));
  const Work* const work = current();
  if (work)
    dialog->selectFile(fileNameOf(
        {QString::fromStdString(inLanguage(*work->exercise).title), QString::fromStdString(work->attempt.student)},
        QStringLiteral("handwheel")));
  connect(dialog, &QFileDialog::fileSelected, this, &RunningAttempt::writeSubmission);
  dialog->open();
}

// It is handed in once the file is there, and not before.
void RunningAttempt::writeSubmission(const QString& path) {
  Work* const work = current();
  if (!work) return;
  if (m_parts.tabs.withPath(path)) {
    emit message({Message::Weight::Error, tr("It could not be handed in"),
                  tr("%1 is open, and would be replaced.").arg(QFileInfo(path).fileName()),
                  tr("Choose another name for the file.")});
    return;
  }
  work->tab->document.settle();
  tick();
  Job job;
  job.name = tr("Handing in");
  job.document = &work->tab->document;
  job.lane = Job::Lane::Saving;
  job.resource = path;
  const auto failed = [this, path](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return emit message(FileSaver::cancelledMessage(path));
    fail(tr("It could not be handed in"), error);
  };
  job.failed = failed;
  job.work = [this, path, failed, tab = work->tab, exercise = work->exercise, content = work->tab->document.snapshot(),
              attempt = work->attempt, kind = m_parts.kinds.withId("exercise"),
              recordings = work->tab->document.file().recordings](Progress progress) -> Job::Finish {
    const Result<ExerciseSnapshot> made = handedIn(*exercise, content, attempt);
    // Before the file, so that nothing is waited for when it is there.
    const Marking marking = made ? markWork(*exercise, *content, attempt, progress.part(0.0, 0.5)) : Marking();
    const QStringList missing = progress.cancelled() ? QStringList() : unmeasured(exercise->exercise, marking);
    OpenedFile opened = DocumentKinds::blank(*kind);
    opened.file.recordings = recordings;
    const std::filesystem::path file = QFile::encodeName(path).toStdString();
    const Result<WrittenFile> written = made ? saveDocument(*kind, opened.file, *made, file, progress.part(0.5, 1.0))
                                             : Result<WrittenFile>(made.error());
    if (!written) return [failed, error = written.error()] { failed(error); };
    return [this, path, tab, student = QString::fromStdString(attempt.student), missing] {
      Message handed{Message::Weight::Info, tr("Handed in by %1").arg(student),
                     tr("The work is in %1.").arg(QFileInfo(path).absoluteFilePath()),
                     tr("Give that file to your teacher.")};
      if (!missing.isEmpty()) {
        handed.weight = Message::Weight::Warning;
        handed.detail +=
            QLatin1Char(' ') + tr("Some of it cannot be measured: %1").arg(missing.join(QStringLiteral("; ")));
        handed.advice = tr("Give that file to your teacher, or go on with the work and hand it in once more.");
      }
      // The message is about the student's document and must not show beside the exercise.
      if (m_parts.tabs.contains(tab)) handed.about = &tab->document;
      emit message(handed);
    };
  };
  m_parts.jobs.start(std::move(job));
}

}  // namespace handwheel
