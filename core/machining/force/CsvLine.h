// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Removes the next line from a text and returns it without its end; also "\r\n".
std::string_view takeLine(std::string_view& text);

// Splits one line of comma-separated values (RFC 4180) into at most `most` fields, without blanks around them. A quoted
// field ends at the end of the line at the latest. O(length).
void splitCsvLine(std::string_view line, std::size_t most, std::vector<std::string>& fields);

}  // namespace handwheel
