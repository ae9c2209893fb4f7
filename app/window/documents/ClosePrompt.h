// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace handwheel {

// The answer to the question before closing a modified document.
enum class CloseAnswer { Save, Discard, Cancel };

// Asks what to do with unsaved changes before a document is closed. Returns at once. then: the function that is called
// with the answer. Before the answer the window takes no input, but jobs may end and documents may be closed. It is the
// only modal question of the program.
void askBeforeClosing(QWidget* window, const QString& name, std::function<void(CloseAnswer)> then);

}  // namespace handwheel
