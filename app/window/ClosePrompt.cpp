// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ClosePrompt.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace handwheel {

namespace {
struct Text {
  Q_DECLARE_TR_FUNCTIONS(ClosePrompt)
};
}  // namespace

CloseAnswer askBeforeClosing(QWidget* window, const QString& name) {
  QMessageBox box(window);
  box.setObjectName(QStringLiteral("closePrompt"));
  box.setWindowTitle(Text::tr("Unsaved changes"));
  box.setIconPixmap(icon(QStringLiteral("save"), themeColours(currentTheme()).accent).pixmap(QSize(40, 40)));
  box.setText(Text::tr("Save the changes to %1?").arg(name));
  box.setInformativeText(Text::tr("Without saving they are lost."));
  box.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return CloseAnswer::Save;
    case QMessageBox::Discard:
      return CloseAnswer::Discard;
    default:
      return CloseAnswer::Cancel;
  }
}

}  // namespace handwheel
