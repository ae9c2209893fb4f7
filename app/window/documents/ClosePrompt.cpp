// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/ClosePrompt.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <utility>

namespace handwheel {

namespace {
struct ClosePromptWords {
  Q_DECLARE_TR_FUNCTIONS(ClosePrompt)
};
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

}  // namespace handwheel
