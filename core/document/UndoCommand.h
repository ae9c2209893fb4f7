// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/Property.h"

#include <QUndoCommand>
#include <optional>

namespace handwheel {

// An undo step of a document, which applies an edit.
class UndoCommand : public QUndoCommand {
 public:
  // Values of the property that the edit changes.
  struct Values {
    PropertyValue before;
    PropertyValue after;
  };

  UndoCommand(Document& document, const QString& text, std::unique_ptr<Edit> edit, std::optional<Values> values = {})
      : QUndoCommand(text), m_document(document), m_edit(std::move(edit)), m_values(std::move(values)) {}

  // Returns the edit as a step of "handwheel edit"; empty if it cannot be written as a step.
  const std::string& step() const { return m_step; }
  void setStep(std::string step) { m_step = std::move(step); }

  // Sets the number of the gesture that the edit belongs to. Edits of the same gesture may become one undo step.
  void setStroke(int stroke) { m_stroke = stroke; }
  int stroke() const { return m_stroke; }

  void redo() override { m_edit->exchange(m_document); }
  void undo() override { m_edit->exchange(m_document); }
  int id() const override { return 1; }  // the same for all commands; mergeWith() decides if two commands merge
  bool mergeWith(const QUndoCommand* later) override;

  const Edit& edit() const { return *m_edit; }

 private:
  Document& m_document;
  std::unique_ptr<Edit> m_edit;
  std::optional<Values> m_values;
  std::string m_step;
  int m_stroke = 0;
};

}  // namespace handwheel
