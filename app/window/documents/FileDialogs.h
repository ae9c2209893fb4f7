// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileDialog;
class QWidget;

namespace handwheel {

class Document;

// The initial folder of file dialogs. Window thread.

// Returns the folder that was used last in any dialog; at first that of the user's documents. Never that of the
// samples.
QString lastFolder();
// Remembers the folder of a file that was chosen.
void rememberFolder(const QString& path);
// Returns the folder of the document's file; if it has no file, or is a sample, the folder that was used last.
QString folderFor(const Document& document);

// Sets the initial folder of a dialog to the one that was used last for this purpose, a word for the settings; at first
// to the one that was used last at all. The chosen folder is remembered.
void beginInFolderOf(QFileDialog& dialog, const QString& purpose);

// Returns a dialog for an existing file, in the folder for the document; the chosen folder is remembered. It is owned
// by the window and destroyed when it is closed; the caller opens it.
QFileDialog* openingDialog(QWidget* window, const Document& document, const QString& title, const QString& filter);

}  // namespace handwheel
