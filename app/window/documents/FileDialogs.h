// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QFileDialog;
class QWidget;

namespace handwheel {

class Document;

// The initial folder of file dialogs. Window thread.

// The folder that was used last in any of them; at first that of the user's documents. Never that of the samples.
QString lastFolder();
// From the path of a file that was chosen.
void rememberFolder(const QString& path);
// That of the document's own file; of one without a file, or with one of the samples, the folder that was used last.
QString folderFor(const Document& document);

// Lets a dialog begin in the folder that was used last for this purpose, a word for the settings; at first in that
// which was used last at all. What is chosen is remembered.
void beginInFolderOf(QFileDialog& dialog, const QString& purpose);

// A dialog for a file that is there, in the folder for the document; the folder that is chosen is remembered. It is
// owned by the window and ends with its closing; to be opened by the caller.
QFileDialog* openingDialog(QWidget* window, const Document& document, const QString& title, const QString& filter);

}  // namespace handwheel
