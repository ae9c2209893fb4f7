// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/exercise/ExerciseDocument.h"

#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseProperties.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

// "⌀30 h10, Nominal size (mm)": as the panel has it.
std::string shownName(const Property& property) {
  const auto words = [](const std::string& text, bool isEnglish) {
    return isEnglish ? QCoreApplication::translate("Property", text.c_str()).toStdString() : text;
  };
  return words(property.group, property.groupTranslated) + ", " + words(property.label, property.translated);
}

// Returns an error about a property, without ids that the window never shows.
Error inWords(Error error, const Property& property) {
  if (error.arguments.empty()) return error;
  if (error.code == ErrorCode::ElementMalformed) error.code = ExerciseError::FieldRefused;
  if (error.code == ExerciseError::FieldRefused || error.code == ErrorCode::ValueOutOfRange)
    error.arguments.front() = shownName(property);
  return error;
}

}  // namespace

ExerciseDocument::ExerciseDocument(OpenedFile opened, QObject* parent)
    : Document(*opened.kind, std::move(opened.file), parent),
      m_exercise(std::static_pointer_cast<const ExerciseSnapshot>(opened.content)) {}

std::vector<Property> ExerciseDocument::properties() const {
  std::vector<Property> all = exerciseProperties(*m_exercise);
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

Result<std::unique_ptr<Edit>> ExerciseDocument::propertyEdit(const std::string& id, const PropertyValue& value) const {
  const std::vector<Property> own = exerciseProperties(*m_exercise);
  const auto found = std::find_if(own.begin(), own.end(), [&](const Property& each) { return each.id == id; });
  if (found == own.end()) return Document::propertyEdit(id, value);
  if (m_exercise->isForStudents) return Error{ExerciseError::Fixed, {}, {}, {}};
  if (found->value == value) return std::unique_ptr<Edit>();
  Result<ExerciseSnapshot> changed = withExerciseProperty(*m_exercise, id, value);
  if (!changed) return inWords(changed.error(), *found);
  return std::unique_ptr<Edit>(std::make_unique<ExerciseEdit>(std::move(changed.value()), id));
}

void ExerciseDocument::change(const QString& text, ExerciseSnapshot exercise) {
  commit(text, std::make_unique<ExerciseEdit>(std::move(exercise)));
}

void ExerciseDocument::change(const QString& text, ExerciseSnapshot exercise, std::string part, DragPhase gesture) {
  commit(text, std::make_unique<ExerciseEdit>(std::move(exercise), std::move(part)), gesture);
}

ExerciseEdit::ExerciseEdit(ExerciseSnapshot exercise, std::string property)
    : m_exercise(std::make_shared<const ExerciseSnapshot>(std::move(exercise))), m_property(std::move(property)) {}

void ExerciseEdit::exchange(Document& document) {
  auto& owner = static_cast<ExerciseDocument&>(document);
  std::swap(owner.m_exercise, m_exercise);
  owner.wasChanged();
}

bool ExerciseEdit::absorb(const Edit& later) {
  const auto* edit = dynamic_cast<const ExerciseEdit*>(&later);
  return edit && !m_property.empty() && edit->m_property == m_property;
}

// Counts the texts, which versions do not share.
std::size_t ExerciseEdit::bytes() const {
  const Exercise& exercise = m_exercise->exercise;
  std::size_t sum = sizeof *this + sizeof *m_exercise + exercise.text.size();
  for (const ExerciseStep& step : exercise.steps) {
    sum += sizeof step + step.text.size();
    for (const std::string& hint : step.hints) sum += hint.size();
  }
  return sum + exercise.criteria.size() * 2 * sizeof(MarkingCriterion);
}

}  // namespace handwheel
