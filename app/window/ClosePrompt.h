// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace handwheel {

enum class CloseAnswer { Save, Discard, Cancel };

// The one question that the program asks: what becomes of the changes to this document. Returns at once; then: called
// with the answer. Until it is given the window takes no input, but jobs end and documents may go.
void askBeforeClosing(QWidget* window, const QString& name, std::function<void(CloseAnswer)> then);

}  // namespace handwheel
