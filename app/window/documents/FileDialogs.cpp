// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/FileDialogs.h"

#include "document/Document.h"
#include "window/documents/Samples.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace handwheel {

namespace {
const auto kFolderKey = QStringLiteral("lastFolder");
}

QString lastFolder() {
  return QSettings().value(kFolderKey, QDir::homePath()).toString();
}

void rememberFolder(const QString& path) {
  QSettings().setValue(kFolderKey, QFileInfo(path).absolutePath());
}

QString folderFor(const Document& document) {
  const QFileInfo file(document.path());
  const bool isOwn = !document.path().isEmpty() && file.absoluteDir().exists() && !isSample(file);
  return isOwn ? file.absolutePath() : lastFolder();
}

void beginInFolderOf(QFileDialog& dialog, const QString& purpose) {
  const QString key = QStringLiteral("folders/") + purpose;
  const auto isThere = [](const QString& folder) { return !folder.isEmpty() && QFileInfo(folder).isDir(); };
  QString folder = QSettings().value(key).toString();
  if (!isThere(folder)) folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  dialog.setDirectory(isThere(folder) ? folder : QDir::homePath());
  QObject::connect(&dialog, &QFileDialog::filesSelected, &dialog, [key](const QStringList& paths) {
    QSettings().setValue(key, QFileInfo(paths.first()).absolutePath());
  });
}

QFileDialog* openingDialog(QWidget* window, const Document& document, const QString& title, const QString& filter) {
  auto* dialog = new QFileDialog(window, title, folderFor(document), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  QObject::connect(dialog, &QFileDialog::fileSelected, dialog, &rememberFolder);
  return dialog;
}

}  // namespace handwheel
