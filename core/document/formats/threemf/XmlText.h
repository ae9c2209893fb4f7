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

// Checks that a text is safe for Qt's XML reader. Returns none if it is. That reader takes time quadratic in a tag's
// attributes and keeps texts in one piece: no tag over 8 KiB, no text over 16 MiB, no document type (which could define
// entities), UTF-8 only. O(text). Checks the cancel flag. Errors: TextEncoding, ElementMalformed {"XML", problem}, with
// the byte; Cancelled.
std::optional<Error> objectionToXml(std::string_view text, const Progress& progress = {});

// Returns the attribute's text as bytes, without blanks around it; empty if there is none. Only ASCII is kept.
std::string asciiOf(QStringView value);

}  // namespace handwheel
