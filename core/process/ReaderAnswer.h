// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace handwheel {

// The output of a reader process. It consists of a text and one byte for its kind.
struct ReaderAnswer {
  enum class Kind : char {
    Content = 'c',      // content of the file, in a form on which caller and reader have agreed
    Reason = 'r',       // the reason why the file cannot be read, an English clause
    OutOfMemory = 'm',  // the process reached its memory limit
  };
  Kind kind = Kind::Reason;
  std::string text;
};

// Parses an answer. Returns nothing if the bytes are not an answer, or if the reason is too long to be displayed.
std::optional<ReaderAnswer> answerOf(std::string bytes);

}  // namespace handwheel
