// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Note.h"

#include <QString>

namespace handwheel {

// Converts a note to a sentence in the language of the program.
QString noteText(const Note& note);

}  // namespace handwheel
