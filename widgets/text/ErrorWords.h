// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace handwheel {

// Translates an argument of an error for use in a sentence. Phrases of the core are translated; other text, which may
// be a quotation from a damaged file, is only shortened.
QString errorArgument(const QString& english);

}  // namespace handwheel
