// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace handwheel {

// The output of a reader process: its text, and then one byte for its kind.
struct ReaderAnswer {
  enum class Kind : char {
    Content = 'c',      // content of the file, in a form that the two have agreed on
    Reason = 'r',       // the reason that it cannot be read: an English clause
    OutOfMemory = 'm',  // it reached its limit
  };
  Kind kind = Kind::Reason;
  std::string text;
};

// Parses an answer. Nothing if it is no answer, or a reason longer than people want to read.
std::optional<ReaderAnswer> answerOf(std::string bytes);

}  // namespace handwheel
