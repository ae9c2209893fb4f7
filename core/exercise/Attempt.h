// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace handwheel {

// One student's attempt at an exercise, with its times and the help used. The work itself is a separate document.
struct Attempt {
  static constexpr std::size_t kLongestText = 1000;  // bytes

  std::string student;             // the student's name as entered; may be empty until the work is handed in
  std::string begun, handedIn;     // UTC, ISO 8601: "2026-11-23T08:15:00Z"; empty: not yet
  double seconds = 0.0;            // s, working time while the document was open, without pauses
  std::vector<std::size_t> hints;  // number of hints used, by step; may be shorter than the steps
  std::vector<bool> done;          // steps that the student has ticked; may be shorter than the steps

  std::size_t hintCount() const;
  bool isHandedIn() const { return !handedIn.empty(); }
  bool operator==(const Attempt&) const = default;
};

}  // namespace handwheel
