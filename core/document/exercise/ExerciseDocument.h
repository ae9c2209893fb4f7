// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/exercise/ExerciseSnapshot.h"

namespace handwheel {

// Document of an exercise, or of a student's copy of one.
class ExerciseDocument : public Document {
  Q_OBJECT

 public:
  // The content of `opened` must be an ExerciseSnapshot with a subject.
  explicit ExerciseDocument(OpenedFile opened, QObject* parent = nullptr);

  const ExerciseSnapshot& exercise() const { return *m_exercise; }

  SnapshotPointer snapshot() const override { return m_exercise; }
  // Returns the properties of exerciseProperties(), then those of every document.
  std::vector<Property> properties() const override;
  // Returns an edit that changes a property. Errors: Fixed for a student's copy, and the errors of
  // withExerciseProperty().
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

  // Replaces the value of the document, as one undo step.
  void change(const QString& text, ExerciseSnapshot exercise);
  // Replaces the value of the document as a phase of a gesture. Changes of the same `part` in a gesture are merged into
  // one undo step.
  void change(const QString& text, ExerciseSnapshot exercise, std::string part, DragPhase gesture);

 private:
  friend class ExerciseEdit;

  std::shared_ptr<const ExerciseSnapshot> m_exercise;
};

// An edit that replaces the value of an exercise. Versions of the document share the task, the solution and the work.
class ExerciseEdit : public Edit {
 public:
  // property: the property that the edit changes. Edits of the same property within a gesture are merged. If `property`
  // is empty, the edit is never merged.
  explicit ExerciseEdit(ExerciseSnapshot exercise, std::string property = {});

  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const ExerciseSnapshot> m_exercise;
  std::string m_property;
};

}  // namespace handwheel
