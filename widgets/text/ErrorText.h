// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <QString>

namespace handwheel {

// Describes an error and its position in one sentence. For example "scan.stl, line 12: 'abc' is not a number." The
// window and the command line use this function. Numbers are written as in the C locale, and the text is English unless
// a translator is installed.
QString errorSentence(const Error& error);

// Suggests a remedy for an error in one sentence. The result is empty for a cancelled job.
QString errorAdvice(const Error& error);

}  // namespace handwheel
