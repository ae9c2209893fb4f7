// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace handwheel {

enum class CloseAnswer { Save, Discard, Cancel };

// The one question that the program asks: what becomes of the changes to this document.
CloseAnswer askBeforeClosing(QWidget* window, const QString& name);

}  // namespace handwheel
