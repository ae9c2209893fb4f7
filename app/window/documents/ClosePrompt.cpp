// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/ClosePrompt.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {
struct ClosePromptWords {
  Q_DECLARE_TR_FUNCTIONS(ClosePrompt)
};

constexpr int kMostRows = 10;  // documents that are visible without scrolling

QListWidget* listOf(const QStringList& names, QWidget* parent) {
  auto* list = new QListWidget(parent);
  list->setObjectName(QStringLiteral("closePromptList"));
  list->setAccessibleName(ClosePromptWords::tr("Documents to save"));
  for (const QString& name : names) {
    auto* item = new QListWidgetItem(name, list);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Checked);
    item->setToolTip(name);
  }
  list->setCurrentRow(0);
  const int rows = std::min(static_cast<int>(names.size()), kMostRows);
  list->setMinimumHeight(rows * list->sizeHintForRow(0) + 2 * list->frameWidth() + 2);
  return list;
}

QList<CloseAnswer> answersOf(const QListWidget& list) {
  QList<CloseAnswer> answers;
  for (int row = 0; row < list.count(); ++row) {
    const bool isChecked = list.item(row)->checkState() == Qt::Checked;
    answers << (isChecked ? CloseAnswer::Save : CloseAnswer::Discard);
  }
  return answers;
}

// The words of the button say what it does with the boxes as they are.
void followBoxes(const QListWidget& list, QPushButton& save) {
  const qsizetype checked = answersOf(list).count(CloseAnswer::Save);
  save.setEnabled(checked > 0);
  save.setText(checked == list.count() ? ClosePromptWords::tr("&Save all") : ClosePromptWords::tr("&Save the checked"));
}

QLabel* wrapped(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  return label;
}

}  // namespace

void askBeforeClosing(QWidget* window, const QString& name, std::function<void(CloseAnswer)> then) {
  auto* box = new QMessageBox(window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName(QStringLiteral("closePrompt"));
  box->setWindowTitle(ClosePromptWords::tr("Unsaved changes"));
  box->setIconPixmap(icon(QStringLiteral("save"), themeColours(currentTheme()).accent).pixmap(QSize(40, 40)));
  box->setText(ClosePromptWords::tr("Save the changes to %1?").arg(name));
  box->setInformativeText(ClosePromptWords::tr("They will be lost if you do not save them."));
  box->setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  box->setDefaultButton(QMessageBox::Save);
  QObject::connect(box, &QMessageBox::finished, window, [box, then = std::move(then)] {
    const auto button = box->standardButton(box->clickedButton());
    then(button == QMessageBox::Save      ? CloseAnswer::Save
         : button == QMessageBox::Discard ? CloseAnswer::Discard
                                          : CloseAnswer::Cancel);
  });
  box->open();
}

void askBeforeClosing(QWidget* window, const QStringList& names, std::function<void(QList<CloseAnswer>)> then) {
  auto* dialog = new QDialog(window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setObjectName(QStringLiteral("closeAllPrompt"));
  dialog->setWindowTitle(ClosePromptWords::tr("Unsaved changes"));
  auto* list = listOf(names, dialog);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, dialog);
  QPushButton* const save = buttons->addButton(QString(), QDialogButtonBox::AcceptRole);
  QPushButton* const discard =
      buttons->addButton(ClosePromptWords::tr("&Discard all"), QDialogButtonBox::DestructiveRole);
  save->setObjectName(QStringLiteral("closePromptSave"));
  discard->setObjectName(QStringLiteral("closePromptDiscard"));
  save->setDefault(true);
  auto* column = new QVBoxLayout(dialog);
  QLabel* const question = wrapped(
      ClosePromptWords::tr("Save the changes to %n document(s)?", nullptr, static_cast<int>(names.size())), dialog);
  question->setProperty("strong", true);
  column->addWidget(question);
  column->addWidget(list, 1);
  column->addWidget(wrapped(ClosePromptWords::tr("The changes to those that are not checked will be lost."), dialog));
  column->addWidget(buttons);
  followBoxes(*list, *save);
  QObject::connect(list, &QListWidget::itemChanged, save, [list, save] { followBoxes(*list, *save); });
  QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  QObject::connect(discard, &QPushButton::clicked, dialog, [dialog, list] {
    for (int row = 0; row < list->count(); ++row) list->item(row)->setCheckState(Qt::Unchecked);
    dialog->accept();
  });
  QObject::connect(dialog, &QDialog::finished, window, [list, then = std::move(then)](int result) {
    then(result == QDialog::Accepted ? answersOf(*list) : QList<CloseAnswer>(list->count(), CloseAnswer::Cancel));
  });
  dialog->open();
}

}  // namespace handwheel
