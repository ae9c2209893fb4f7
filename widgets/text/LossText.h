// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentFile.h"

#include <QStringList>

namespace handwheel {

// The names of the content of a file that its document does not keep. Such as "colours", "texture coordinates",
// "quality"…
QStringList lostNames(const DocumentFile& file);
// The same as a part of a sentence: "colours, texture coordinates, “quality”"
QString lostText(const DocumentFile& file);

}  // namespace handwheel
