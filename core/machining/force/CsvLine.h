// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Takes the next line off a text, without its end; also "\r\n".
std::string_view takeLine(std::string_view& text);

// The fields of one line of comma-separated values (RFC 4180), without blanks around them: at most so many. A quoted
// field ends at the end of the line at the latest. O(length).
void splitCsvLine(std::string_view line, std::size_t most, std::vector<std::string>& fields);

}  // namespace handwheel
