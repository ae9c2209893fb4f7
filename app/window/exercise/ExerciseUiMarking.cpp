// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Marking the submissions of a class, and writing the results.
#include "document/AtomicFile.h"
#include "document/exercise/ExerciseDocument.h"
#include "document/exercise/ShippedExercises.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "report/exercise/MarkingWords.h"
#include "text/ErrorText.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileSaver.h"
#include "window/exercise/ExerciseEditor.h"
#include "window/exercise/ExerciseUi.h"
#include "window/exercise/SubmissionsView.h"
#include "window/kinds/KindPanel.h"
#include "window/kinds/SuggestedName.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>

namespace handwheel {

namespace {

std::string markProblem(const Error& error) {
  return errorSentence(error).toStdString();
}

}  // namespace

void ExerciseUi::chooseSubmissions() {
  auto* dialog = new QFileDialog(parts().window, tr("Mark what was handed in"), QString(),
                                 tr("Submissions (%1)").arg(QStringLiteral("*.handwheel")));
  dialog->setObjectName(QStringLiteral("markDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  beginInFolderOf(*dialog, QStringLiteral("handedIn"));
  connect(dialog, &QFileDialog::filesSelected, this, &ExerciseUi::mark);
  dialog->open();
}

// The result is that of its exercise, whichever document is shown by then.
void ExerciseUi::mark(const QStringList& paths) {
  if (!current()) return;
  Job job;
  job.name = tr("Marking");
  job.document = &document()->document;
  job.work = [this, paths, scheme = snapshot(), &kinds = parts().kinds, owner = document()](Progress progress) {
    auto marked = std::make_shared<std::vector<ReportedWork>>();
    const double share = 1.0 / static_cast<double>(paths.size());
    const std::uint64_t mark = schemeMark(*scheme);
    for (int i = 0; i < paths.size() && !progress.cancelled(); ++i)
      marked->push_back(markFile(*scheme, mark, QFile::encodeName(paths[i]).toStdString(), kinds, markProblem,
                                 progress.part(i * share, (i + 1) * share)));
    if (progress.cancelled()) return Job::Finish();
    return Job::Finish([this, marked, owner] { takeMarked(owner, std::move(*marked)); });
  };
  parts().jobs.start(std::move(job));
}

// More works are added; a file that is marked again replaces its row. One undo step.
void ExerciseUi::takeMarked(DocumentTab* owner, std::vector<ReportedWork> works) {
  if (!parts().tabs.contains(owner) || works.empty()) return;
  auto& exercise = static_cast<ExerciseDocument&>(owner->document);
  ExerciseSnapshot changed = exercise.exercise();
  changed.marked = std::make_shared<const MarkedSubmissions>(
      withMarked(changed.marked ? *changed.marked : MarkedSubmissions(), works));
  exercise.change(tr("Mark"), std::move(changed));
  if (owner != document()) return;
  m_editor->setCurrentWidget(m_editor->classView());
  if (!parts().isPanelVisible()) parts().showPanel->trigger();
  raiseKindPanel(parts());
  reportMarked(works);
}

void ExerciseUi::removeWorks(const std::vector<std::size_t>& works) {
  if (!current() || !m_shownClass) return;
  MarkedSubmissions left;
  for (std::size_t i = 0; i < m_shownClass->size(); ++i)
    if (std::find(works.begin(), works.end(), i) == works.end()) left.push_back((*m_shownClass)[i]);
  ExerciseSnapshot changed = current()->exercise();
  changed.marked = left.empty() ? nullptr : std::make_shared<const MarkedSubmissions>(std::move(left));
  current()->change(tr("Remove from the class"), std::move(changed));
}

// Called after each change of the exercise, few of which concern the class or its report.
void ExerciseUi::showClass() {
  const ExerciseSnapshot& exercise = current()->exercise();
  const Exercise shown = inLanguage(exercise);
  std::string scheme = std::to_string(schemeMark(shown)) + shown.title + '\n' + shown.text;
  for (const MarkingCriterion& c : shown.criteria) scheme += '\n' + c.name;
  const bool isSameScheme = scheme == m_shownScheme && exercise.task == m_shownTask;
  if (exercise.marked == m_shownClass && (!m_shownClass || isSameScheme)) return;
  m_shownClass = exercise.marked;
  m_shownTask = exercise.task;
  m_shownScheme = std::move(scheme);
  m_editor->classView()->setReport(submissionsReportOf(exercise));
}

// Reports the results in short: the table is in the panel.
void ExerciseUi::reportMarked(const std::vector<ReportedWork>& works) {
  const QLocale locale;
  std::vector<const ReportedWork*> marked;
  for (const ReportedWork& work : works) {
    if (work.row.problem.empty()) marked.push_back(&work);
  }
  const auto count = static_cast<int>(marked.size()), failed = static_cast<int>(works.size()) - count;
  QStringList details;
  if (count == 1) {
    const SubmissionRow& row = marked.front()->row;
    details += tr("%1: %2 of %3.")
                   .arg(QString::fromStdString(row.attempt.student), locale.toString(row.marking.points),
                        locale.toString(row.marking.of));
  } else if (count > 1) {
    const auto byPoints = [](const ReportedWork* a, const ReportedWork* b) {
      return a->row.marking.points < b->row.marking.points;
    };
    const auto [least, most] = std::minmax_element(marked.begin(), marked.end(), byPoints);
    details += tr("From %1 to %2 of %3.")
                   .arg(locale.toString((*least)->row.marking.points), locale.toString((*most)->row.marking.points),
                        locale.toString((*most)->row.marking.of));
  }
  if (failed > 0) details += tr("%Ln file(s) could not be marked; the table says why.", nullptr, failed);
  Message done{failed > 0 ? Message::Weight::Warning : Message::Weight::Info, tr("%Ln work(s) marked", nullptr, count),
               details.join(QLatin1Char(' '))};
  done.about = &document()->document;
  emit message(done);
}

void ExerciseUi::chooseFile(const QString& title, const QString& filter, const QString& name, const QString& suffix,
                            const std::function<void(const QString& path)>& chosen) {
  auto* dialog = new QFileDialog(parts().window, title, QString(), filter);
  dialog->setObjectName(QStringLiteral("classFileDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(suffix);
  beginInFolderOf(*dialog, QStringLiteral("classReports"));
  dialog->selectFile(fileNameOf({name}, suffix));
  connect(dialog, &QFileDialog::fileSelected, this, chosen);
  dialog->open();
}

// Plots and pages of a class take seconds.
void ExerciseUi::startWriting(ClassFile what, const QString& path) {
  Job job;
  job.name = tr("Writing %1").arg(QFileInfo(path).fileName());
  job.document = &document()->document;
  job.lane = Job::Lane::Saving;
  job.resource = path;
  const auto failed = [this, path](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return emit message(FileSaver::cancelledMessage(path));
    report(tr("%1 could not be saved").arg(QFileInfo(path).fileName()), error);
  };
  job.failed = failed;
  const SubmissionsView& view = *m_editor->classView();
  job.work = [this, asTable = what == ClassFile::Table, path, failed,
              marked = what == ClassFile::Comparison ? view.comparedReport()
                                                     : view.shownReport()](Progress progress) -> Job::Finish {
    const std::filesystem::path file = QFile::encodeName(path).toStdString();
    SubmissionTable table(marked.exercise);
    for (const ReportedWork& work : marked.works) table.add(work.row);
    const Status written = asTable ? writeFileAtomically(file, table.csv(translatedHeading), progress)
                                   : writeReport(marked, file, progress);
    if (!written) return [failed, error = written.error()] { failed(error); };
    return [this, path] {
      parts().log.add(tr("Saved %1").arg(QFileInfo(path).fileName()));
      emit message({Message::Weight::Info, tr("Saved %1").arg(QFileInfo(path).fileName()),
                    tr("It is in the folder %1.").arg(QFileInfo(path).absolutePath())});
    };
  };
  parts().jobs.start(std::move(job));
}

void ExerciseUi::writeClass(ClassFile what) {
  if (!current()) return;
  const auto write = [this, what](const QString& path) { startWriting(what, path); };
  const QString title = QString::fromStdString(inLanguage(current()->exercise()).title);
  if (what == ClassFile::Table) {
    chooseFile(tr("Save the table"), tr("Table (%1)").arg(QStringLiteral("*.csv")), tr("%1, class").arg(title),
               QStringLiteral("csv"), write);
  } else {
    chooseFile(what == ClassFile::Report ? tr("Save the report") : tr("Save the comparison"),
               tr("Report (%1)").arg(QStringLiteral("*.html *.pdf")),
               what == ClassFile::Report ? tr("%1, report").arg(title) : tr("%1, comparison").arg(title),
               QStringLiteral("html"), write);
  }
}

}  // namespace handwheel
