// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/FileDialogs.h"

#include "document/Document.h"
#include "window/documents/Samples.h"

#include <QApplication>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QTreeView>

namespace handwheel {

namespace {
const auto kFolderKey = QStringLiteral("lastFolder");
constexpr QSize kDialogSize(860, 560);  // logical pixels
}  // namespace

QString lastFolder() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const bool hasDocuments = !documents.isEmpty() && QFileInfo(documents).isDir();
  return QSettings().value(kFolderKey, hasDocuments ? documents : QDir::homePath()).toString();
}

void rememberFolder(const QString& path) {
  if (!isSample(QFileInfo(path))) QSettings().setValue(kFolderKey, QFileInfo(path).absolutePath());
}

QString folderFor(const Document& document) {
  const QFileInfo file(document.path());
  const bool isOwn = !document.path().isEmpty() && file.absoluteDir().exists() && !isSample(file);
  return isOwn ? file.absolutePath() : lastFolder();
}

void beginInFolderOf(QFileDialog& dialog, const QString& purpose) {
  const QString key = QStringLiteral("folders/") + purpose;
  const QString folder = QSettings().value(key).toString();
  dialog.setDirectory(!folder.isEmpty() && QFileInfo(folder).isDir() ? folder : lastFolder());
  QObject::connect(&dialog, &QFileDialog::filesSelected, &dialog, [key](const QStringList& paths) {
    QSettings().setValue(key, QFileInfo(paths.first()).absolutePath());
    rememberFolder(paths.first());
  });
}

QFileDialog* openingDialog(QWidget* window, const Document& document, const QString& title, const QString& filter) {
  auto* dialog = new QFileDialog(window, title, folderFor(document), filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  QObject::connect(dialog, &QFileDialog::fileSelected, dialog, &rememberFolder);
  return dialog;
}

FileDialogLayout::FileDialogLayout(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

// Dialogs of the desktop have no such list.
bool FileDialogLayout::eventFilter(QObject* watched, QEvent* event) {
  auto* const dialog = event->type() == QEvent::Show ? qobject_cast<QFileDialog*>(watched) : nullptr;
  auto* const files = dialog ? dialog->findChild<QTreeView*>(QStringLiteral("treeView")) : nullptr;
  if (!files) return QObject::eventFilter(watched, event);
  dialog->resize(dialog->size().expandedTo(kDialogSize.boundedTo(dialog->screen()->availableSize())));
  files->header()->setStretchLastSection(false);
  files->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  files->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  return QObject::eventFilter(watched, event);
}

}  // namespace handwheel
