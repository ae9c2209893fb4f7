// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/property/PropertyRow.h"

#include "controls/property/PropertyRows.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QVBoxLayout>

namespace handwheel {

PropertyRow::PropertyRow(QWidget* parent) : QWidget(parent), m_label(new QLabel(this)), m_problem(new QLabel(this)) {
  m_label->setWordWrap(true);
  m_problem->setObjectName(QStringLiteral("propertyProblem"));
  m_problem->setProperty("bad", true);
  m_problem->setWordWrap(true);
}

PropertyRow* PropertyRow::make(const Property& property, LengthUnit unit, QWidget* parent) {
  PropertyRow* row = nullptr;
  switch (kindOf(property)) {
    case Kind::Number:
      row = new NumberRow(parent);
      break;
    case Kind::Switch:
      row = new SwitchRow(parent);
      break;
    case Kind::Text:
      row = new TextRow(parent);
      break;
    case Kind::LongText:
      row = new LongTextRow(parent);
      break;
    case Kind::Suggested:
      row = new SuggestedTextRow(parent);
      break;
    case Kind::Colour:
      row = new ColourRow(parent);
      break;
    case Kind::Choice:
      row = new ChoiceRow(parent);
      break;
    case Kind::List:
      row = new ListRow(parent);
      break;
    case Kind::ReadOnly:
      row = new ReadOnlyRow(parent);
      break;
  }
  row->m_id = property.id;
  row->m_kind = kindOf(property);
  row->setObjectName(QStringLiteral("property/") + QString::fromStdString(property.id));
  row->showProperty(property, unit);
  return row;
}

bool PropertyRow::fits(const Property& property) const {
  return property.id == m_id && kindOf(property) == m_kind;
}

void PropertyRow::showProperty(const Property& property, LengthUnit unit) {
  const QString label = property.translated ? translated(property.label) : QString::fromStdString(property.label);
  m_label->setText(label);
  setLabel(label);
  m_remark = translated(property.problem);
  if (!m_isKept) m_refusal.clear();
  showValue(property, unit);
  showRemark();
}

void PropertyRow::refuse(const PropertyValue& entered, const QString& reason) {
  m_refusal = reason;
  m_isKept = keep(entered);
  showRemark();
}

void PropertyRow::forgetRefusal() {
  m_refusal.clear();
  m_isKept = false;
  showRemark();
}

void PropertyRow::showRemarkOutside() {
  m_isRemarkOutside = true;
  showRemark();
}

QString PropertyRow::namedRemark() const {
  return remark().isEmpty() ? QString() : tr("%1: %2").arg(m_label->text(), remark());
}

void PropertyRow::showRemark() {
  const bool isChanged = m_problem->text() != remark();
  m_problem->setText(remark());
  m_problem->setVisible(!m_isRemarkOutside && !remark().isEmpty());
  if (m_isRemarkOutside) markBad(*m_label, !remark().isEmpty());
  if (isChanged) emit remarkChanged();
}

void PropertyRow::markBad(QWidget& widget, bool isBad) {
  if (widget.property("bad").toBool() == isBad) return;
  widget.setProperty("bad", isBad);
  widget.style()->unpolish(&widget);
  widget.style()->polish(&widget);
}

PropertyRow::Kind PropertyRow::kindOf(const Property& property) {
  if (!property.editable) return Kind::ReadOnly;
  const bool isText = std::holds_alternative<std::string>(property.value), hasChoices = !property.choices.empty();
  if (hasChoices && isText) return Kind::Suggested;
  if (hasChoices) return property.continuous ? Kind::List : Kind::Choice;
  if (std::holds_alternative<bool>(property.value)) return Kind::Switch;
  if (!isText) return Kind::Number;
  // Properties for whole sentences.
  if (property.id == "text" || property.id.ends_with(".text")) return Kind::LongText;
  return property.id.ends_with(".colour") ? Kind::Colour : Kind::Text;
}

QString PropertyRow::translated(const std::string& english) {
  return english.empty() ? QString() : QCoreApplication::translate("Property", english.c_str());
}

void PropertyRow::arrange(QWidget* editor, bool besideLabel, QWidget* below, QWidget* after) {
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  m_label->setVisible(besideLabel);
  if (besideLabel) line->addWidget(m_label, kLabelStretch, Qt::AlignTop);
  line->addWidget(editor, kEditorStretch);
  if (after) line->addWidget(after);
  m_label->setMinimumHeight(editor->sizeHint().height());
  m_label->setBuddy(editor);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addLayout(line);
  if (below) column->addWidget(below);
  column->addWidget(m_problem);
}

}  // namespace handwheel
