// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/exercise/MarkingReport.h"
#include "window/kinds/RigidPartsUi.h"

#include <QAction>

class QStackedWidget;

namespace handwheel {

class SubmissionsView;
class ExerciseDocument;
class ExerciseEditor;
class ExerciseLesson;
class RunningAttempt;

// The user interface of exercises: the teacher's editor, a student's page, and marking.
class ExerciseUi : public RigidPartsUi {
  Q_OBJECT

 public:
  explicit ExerciseUi(const WindowContext& window);

  void setDocument(DocumentTab* document) override;
  std::vector<StartAction> startActions() const override;
  void begin(const QString& startAction) override;
  QString panelTitle() const override { return tr("Exercise"); }
  QString panelIcon() const override { return QStringLiteral("kind-exercise"); }
  QWidget* panel() override;
  QString menuTitle() const override { return tr("E&xercise"); }
  QList<QAction*> menu() override;
  QList<QAction*> toolBar() override;
  std::vector<ToolDescriptor> tools() override { return {measureParts()}; }
  Suggestion suggestion() override;
  std::optional<Ray> sectionAxis() const override { return Ray{Vec3::Zero(), Vec3::UnitZ()}; }  // the axis of turning
  QString openedText(const DocumentTab& document) const override;
  QString suggestedName(const DocumentTab& document) const override;

 protected:
  DisplayModel displayed(const Document& document) const override;
  bool isOfLathe() const override;

 private:
  ExerciseDocument* current() const;
  std::shared_ptr<const ExerciseSnapshot> snapshot() const;
  void buildActions();
  void refresh();
  void openStudentCopy();
  void takeWork(bool asTarget);
  void openSolution();
  void takeTarget(const SnapshotPointer& work);
  void askForTarget();
  void importTarget(DocumentTab* owner, const QString& path);
  void askForPosition(DocumentTab* owner, const QString& name, const TaskPointer& before,
                      const ExerciseSubject::ImportedTask& imported);
  // Returns false if the target is unchanged.
  bool changeTarget(DocumentTab* owner, const QString& text, const TaskPointer& before, const TaskPointer& made);
  void turnTarget();
  // Shows a message that is removed as soon as the exercise has another task.
  void sayOffTarget(DocumentTab* owner, const TaskPointer& task);
  void sayWhileTarget(Message said, DocumentTab* owner, const TaskPointer& task);
  void askToRound();
  void chooseSubmissions();
  void mark(const QStringList& paths);
  void takeMarked(DocumentTab* owner, std::vector<ReportedWork> works);
  void reportMarked(const std::vector<ReportedWork>& works);
  void removeWorks(const std::vector<std::size_t>& works);
  void showClass();
  // Asks for a file and calls `chosen` with its path. name: the suggested name without extension.
  void chooseFile(const QString& title, const QString& filter, const QString& name, const QString& suffix,
                  const std::function<void(const QString& path)>& chosen);
  enum class ClassFile { Report, Table, Comparison };
  void writeClass(ClassFile what);
  void startWriting(ClassFile what, const QString& path);
  void report(const QString& title, const Error& error);

  QStackedWidget* m_pages;
  ExerciseEditor* m_editor;
  ExerciseLesson* m_student;
  RunningAttempt* m_attempt;
  // The class that is shown, and the other values that its table and report depend on.
  std::shared_ptr<const MarkedSubmissions> m_shownClass;
  std::string m_shownScheme;
  TaskPointer m_shownTask;
  // The shown model, and the data from which it was made.
  mutable DisplayModel m_displayed;
  mutable TaskPointer m_displayedTask;
  mutable SnapshotPointer m_displayedWork;
  QAction *m_begin, *m_preview, *m_solution, *m_openSolution, *m_import, *m_target, *m_turn, *m_round, *m_mark;
};

}  // namespace handwheel
