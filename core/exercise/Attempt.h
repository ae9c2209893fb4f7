// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace handwheel {

// Who did an exercise, when, and with how much help. What was made is a document of its own.
struct Attempt {
  static constexpr std::size_t kLongestText = 1000;  // bytes

  std::string student;             // as they write their name; may be empty until it is handed in
  std::string begun, handedIn;     // UTC, ISO 8601: "2026-11-23T08:15:00Z"; empty: not yet
  double seconds = 0.0;            // of work: while it was open, pauses left out
  std::vector<std::size_t> hints;  // how many of each step were looked at; may be shorter than the steps
  std::vector<bool> done;          // the steps that the student has ticked; may be shorter, too

  std::size_t hintCount() const;
  bool isHandedIn() const { return !handedIn.empty(); }
  bool operator==(const Attempt&) const = default;
};

}  // namespace handwheel
