// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

class QFileDialog;
class QWidget;

namespace handwheel {

class Document;

// Functions for the initial folder of file dialogs. They must be called on the window thread.

// Returns the folder that was used last in any dialog; before the first use, the user's documents folder. The folder of
// the samples is never returned.
QString lastFolder();
// Remembers the folder of a file that was chosen.
void rememberFolder(const QString& path);
// Returns the folder of the document's file. If the document has no file, or is a sample, returns lastFolder().
QString folderFor(const Document& document);

// Sets the initial folder of a dialog to the one that was used last for this purpose; before the first use, to
// lastFolder(). The chosen folder is remembered. purpose: the key of the folder in the settings.
void beginInFolderOf(QFileDialog& dialog, const QString& purpose);

// Returns a dialog for an existing file, that starts in folderFor() the document; the chosen folder is remembered. The
// dialog is owned by the window and destroyed when it is closed. The caller must open it.
QFileDialog* openingDialog(QWidget* window, const Document& document, const QString& title, const QString& filter);

// Gives file dialogs the size and the columns at which names, sizes and dates of files are whole, when they appear.
class FileDialogLayout : public QObject {
  Q_OBJECT

 public:
  // Installs an event filter on the application for the lifetime of this object.
  explicit FileDialogLayout(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace handwheel
