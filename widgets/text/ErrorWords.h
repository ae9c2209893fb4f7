// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace handwheel {

// An argument of an error as a sentence shows it: the phrases of the core in the language of the window, anything else,
// which may quote a damaged file, as it is but shortened.
QString errorArgument(const QString& english);

}  // namespace handwheel
