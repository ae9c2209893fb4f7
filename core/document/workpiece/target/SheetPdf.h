// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/drawing/Sheet.h"

#include <string>

namespace handwheel {

// Returns a sheet as a PDF file in the size of the sheet. This needs fonts and therefore a QGuiApplication. May be
// called on any thread. Error: LibraryFailed.
Result<std::string> pdfOf(const Sheet& sheet, const std::string& title);

}  // namespace handwheel
