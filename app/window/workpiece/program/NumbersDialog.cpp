// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/NumbersDialog.h"

#include "controls/NumberField.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

NumbersDialog::NumbersDialog(const QString& title, const QString& intro, const QString& button,
                             std::vector<Number> numbers, QWidget* parent)
    : QDialog(parent) {
  setWindowTitle(title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* column = new QVBoxLayout(this);
  auto* text = new QLabel(intro, this);
  text->setWordWrap(true);
  column->addWidget(text);
  auto* form = new QFormLayout;
  for (const Number& each : numbers) {
    auto* field = new NumberField(this);
    field->setObjectName(QString::fromLatin1(each.name));
    field->setQuantity(Quantity::Number, LengthUnit::Millimetre);
    field->setRange(each.least, each.largest);
    field->setValue(each.value);
    field->setLabel(each.label);
    field->setToolTip(each.tip);
    form->addRow(QStringLiteral("%1, %2").arg(each.label, each.unit), field);
    m_fields.push_back(field);
  }
  column->addLayout(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* const make = buttons->addButton(button, QDialogButtonBox::AcceptRole);
  make->setObjectName(QStringLiteral("numbersAccept"));
  make->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    std::vector<double> values;
    for (const NumberField* field : m_fields) {
      if (!field->problem().isEmpty()) return;  // it is shown below the field
      values.push_back(field->value());
    }
    emit chosen(values);
    accept();
  });
}

}  // namespace handwheel
