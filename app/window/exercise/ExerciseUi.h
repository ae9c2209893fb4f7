// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/kinds/RigidPartsUi.h"

#include <QAction>

class QStackedWidget;

namespace handwheel {

class ClassView;
class ExerciseDocument;
class ExerciseEditor;
class ExerciseLesson;
class RunningAttempt;
struct ExerciseSnapshot;

// The user interface of exercises: the teacher's editor, a student's page, and marking.
class ExerciseUi : public RigidPartsUi {
  Q_OBJECT

 public:
  explicit ExerciseUi(const WindowContext& window);

  void setDocument(DocumentTab* document) override;
  std::vector<StartAction> startActions() const override;
  QString panelTitle() const override { return tr("Exercise"); }
  QString panelIcon() const override { return QStringLiteral("kind-exercise"); }
  QWidget* panel() override;
  QString menuTitle() const override { return tr("E&xercise"); }
  QList<QAction*> menu() override;
  QList<QAction*> toolBar() override;
  std::vector<ToolDescriptor> tools() override { return {measureParts()}; }
  NextStep nextStep() override;
  QString openedText(const DocumentTab& document) const override;

 private:
  ExerciseDocument* current() const;
  std::shared_ptr<const ExerciseSnapshot> snapshot() const;
  void buildActions();
  void refresh();
  void openContent(const ExerciseSnapshot& content);
  void takeWork(bool asTarget);
  void chooseSubmissions();
  void mark(const QStringList& paths);
  void chooseFile(const QString& title, const QString& filter, const QString& suffix,
                  const std::function<void(const QString& path)>& chosen);
  void writeClass(bool asTable);
  void report(const QString& title, const Error& error);

  QStackedWidget* m_pages;
  ExerciseEditor* m_editor;
  ExerciseLesson* m_student;
  RunningAttempt* m_attempt;
  QStringList m_marked;  // paths of the submissions in the table
  QAction *m_begin, *m_preview, *m_solution, *m_target, *m_mark;
};

}  // namespace handwheel
