// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>

class QWidget;

namespace handwheel {

// The answer to the question before closing a modified document.
enum class CloseAnswer { Save, Discard, Cancel };

// Asks what to do with unsaved changes before a document is closed. Returns at once. then: the function that is called
// with the answer. Before the answer the window takes no input, but jobs may end and documents may be closed. These are
// the only modal questions of the program.
void askBeforeClosing(QWidget* window, const QString& name, std::function<void(CloseAnswer)> then);

// Asks the same once about several documents, with a check box for each. then: the function that is called with an
// answer for each name: Save for those that are checked, Discard for the others, or Cancel for all.
void askBeforeClosing(QWidget* window, const QStringList& names, std::function<void(QList<CloseAnswer>)> then);

}  // namespace handwheel
