// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/ThreadDialog.h"

#include "controls/QuantityText.h"
#include "machining/thread/ThreadGroove.h"
#include "text/ErrorText.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

ThreadDialog::ThreadDialog(const WorkpieceSnapshot& workpiece, LengthUnit unit, QWidget* parent)
    : QDialog(parent),
      m_workpiece(workpiece),
      m_values(threadOperation()),
      m_unit(unit),
      m_list(new PropertyList(this)),
      m_remark(new QLabel(this)) {
  setObjectName(QStringLiteral("threadDialog"));
  setWindowTitle(tr("Thread"));
  constexpr double kUsual = 20.0;  // mm, at the upper end
  const double upper = workpiece.stock.position + workpiece.stock.length;
  m_values.setValid("from", PropertyValue(std::max(workpiece.stock.position, upper - kUsual)));
  m_values.setValid("to", PropertyValue(upper));
  auto* layout = new QVBoxLayout(this);
  m_list->setLengthUnit(unit);
  m_list->setMinimumSize(420, 300);
  layout->addWidget(m_list);
  m_remark->setWordWrap(true);
  m_remark->setObjectName(QStringLiteral("threadRemark"));
  layout->addWidget(m_remark);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  m_cut = buttons->addButton(tr("&Cut"), QDialogButtonBox::AcceptRole);
  m_cut->setObjectName(QStringLiteral("cutThread"));
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &ThreadDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_list, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    const std::string problem = m_values.set(id, value);
    if (!problem.empty()) m_list->refuse(id, value, QString::fromStdString(problem));
    showValues();
  });
  showValues();
}

void ThreadDialog::showValues() {
  std::vector<Property> properties;
  for (const Parameter& parameter : threadOperation().parameters) {
    properties.push_back(parameter.property);
    properties.back().value = *m_values.value(parameter.id());
  }
  m_list->setProperties(properties);
  const Result<TurningPass> pass = threadPass(m_workpiece, m_values);
  m_cut->setEnabled(pass.hasValue());
  if (!pass) return m_remark->setText(errorSentence(pass.error()));
  const double bottom = 2.0 * ThreadGroove::of(*pass).front().deepest();
  const bool isIso = m_values.number("depth") == 0.0;
  m_remark->setText((isIso ? tr("ISO metric profile: the bottom of the groove is at a diameter of %1.")
                           : tr("The bottom of the groove is at a diameter of %1."))
                        .arg(quantityText(bottom, Quantity::Length, m_unit, QLocale())));
}

void ThreadDialog::accept() {
  const Result<TurningPass> pass = threadPass(m_workpiece, m_values);
  if (!pass) return;
  emit chosen(*pass);
  QDialog::accept();
}

}  // namespace handwheel
