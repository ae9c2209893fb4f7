// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseDocument.h"

#include <QPointer>
#include <QTabWidget>
#include <optional>

class QLabel;
class QListWidget;
class QMenu;
class QToolButton;

namespace handwheel {

class SubmissionsView;
class PropertyList;
class InstructionEditor;

// The panel in which a teacher prepares an exercise. It has pages for the task, the marking scheme, the steps, and the
// class.
class ExerciseEditor : public QTabWidget {
  Q_OBJECT

 public:
  explicit ExerciseEditor(QWidget* parent = nullptr);

  // Sets the document to edit; null: none. The panel follows its changes.
  void setDocument(ExerciseDocument* document);
  void refresh();
  SubmissionsView* classView() const { return m_class; }
  // Adds buttons below the task for commands that make the target.
  void showTargetActions(const QList<QAction*>& actions);

 private:
  // A list of rows with the properties of the selected row below the list.
  struct Rows {
    QWidget* page = nullptr;
    QListWidget* list = nullptr;
    PropertyList* properties = nullptr;
    QToolButton* remove = nullptr;
    QToolButton *up = nullptr, *down = nullptr;
    QLabel* sum = nullptr;  // shows the sum over all rows
  };
  Rows makeRows(const QString& name, const QString& addTip, const std::function<void(QToolButton*)>& setUpAdding);
  void fillRows(Rows& rows, const QStringList& names, const std::vector<Property>& properties,
                const std::function<std::string(int)>& prefix);
  using Move = ExerciseSnapshot (*)(ExerciseSnapshot, std::size_t row, bool isUp);
  void connectMoves(Rows& rows, const QString& text, Move moved);
  void addCriterion(std::size_t figure);
  void addSizes(QMenu& menu);
  void makeInstructionEditor();
  void toggleMark(const std::string& id);
  void addHint();
  void changeHint(std::size_t hint, const std::string& text);
  void removeHint(std::size_t hint);
  // Returns the exercise with changed hints of the shown step. Returns nothing if no step is shown.
  std::optional<ExerciseSnapshot> withHints(const std::function<void(std::vector<std::string>&)>& changing) const;
  std::string partOfHint(std::size_t hint) const;
  void change(const QString& text, ExerciseSnapshot exercise);

  QPointer<ExerciseDocument> m_document;
  PropertyList* m_task;
  QWidget* m_taskPage;
  Rows m_criteria, m_steps;
  InstructionEditor* m_step;
  SubmissionsView* m_class;
};

}  // namespace handwheel
