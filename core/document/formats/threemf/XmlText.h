// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "base/Progress.h"

#include <QXmlStreamReader>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Checks that a text is safe for Qt's XML reader. Returns nothing if it is safe, otherwise an error: TextEncoding,
// ElementMalformed {"XML", problem} with the byte, or Cancelled. Safe texts are in UTF-8, with no tag over 8 KiB, no
// text over 16 MiB and no document type, because Qt's reader takes time quadratic in a tag's attributes, keeps each
// text in one piece and resolves entities. O(text).
std::optional<Error> objectionToXml(std::string_view text, const Progress& progress = {});

// Replaces the declaration at the begin of a text in UTF-8 by blanks. Qt's reader refuses versions other than 1.0,
// although nothing else of them matters here.
void blankXmlDeclaration(std::string& text);

// Returns the text of an attribute as bytes, without blanks around it. Each character that is not ASCII becomes '?'.
std::string asciiOf(QStringView value);

}  // namespace handwheel
