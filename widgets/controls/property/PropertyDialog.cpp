// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/property/PropertyDialog.h"

#include "text/ErrorText.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace handwheel {

PropertyDialog::PropertyDialog(const Text& text, Shown shown, Change change, QWidget* parent)
    : QDialog(parent),
      m_shown(std::move(shown)),
      m_change(std::move(change)),
      m_intro(new QLabel(text.intro, this)),
      m_list(new PropertyList(this)) {
  setWindowTitle(text.title);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* column = new QVBoxLayout(this);
  m_intro->setObjectName(QStringLiteral("propertiesIntro"));
  m_intro->setWordWrap(true);
  column->addWidget(m_intro);
  m_list->setMinimumSize(460, 170);
  column->addWidget(m_list, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* const done = buttons->addButton(text.button, QDialogButtonBox::AcceptRole);
  done->setObjectName(QStringLiteral("propertiesAccept"));
  done->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(m_list, &PropertyList::edited, this, &PropertyDialog::edit);
  m_list->setProperties(m_shown());
}

void PropertyDialog::addView(QWidget* view) {
  static_cast<QVBoxLayout*>(layout())->insertWidget(layout()->indexOf(m_list), view);
}

void PropertyDialog::edit(const std::string& id, const PropertyValue& value) {
  const Status changed = m_change(id, value);
  if (!changed) m_list->refuse(id, value, errorSentence(changed.error()));
  m_list->setProperties(m_shown());
}

// A field that loses the focus while it is deleted commits its text, when the functions no longer exist.
PropertyDialog::~PropertyDialog() {
  m_list->disconnect(this);
}

}  // namespace handwheel
