// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentFile.h"

#include <QStringList>

namespace handwheel {

// Returns the names of the file content that a document does not keep. Examples: "colours", "texture coordinates",
// "quality"…
QStringList lostNames(const DocumentFile& file);
// Returns the names of lostNames() as a part of a sentence: "colours, texture coordinates, “quality”".
QString lostText(const DocumentFile& file);

}  // namespace handwheel
