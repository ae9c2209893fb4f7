// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Removes the next line from a text and returns the line. Its end, "\n" or "\r\n", is not returned.
std::string_view takeLine(std::string_view& text);

// Splits one line of comma-separated values (RFC 4180) into at most `most` fields, without blanks around them. A quoted
// field without a closing quote ends at the end of the line. O(length).
void splitCsvLine(std::string_view line, std::size_t most, std::vector<std::string>& fields);

}  // namespace handwheel
