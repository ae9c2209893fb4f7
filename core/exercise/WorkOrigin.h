// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace handwheel {

// Origin of work, as far as its recording tells: a set of bits. Unknown: nothing was made, or the kind of work does not
// record it. Hand: a hand moved the tool. Program: a program moved it. Command: a command made the shape without a
// machine.
enum class WorkOrigin {
  Unknown = 0,
  Hand = 1,
  Program = 2,
  Both = Hand | Program,
  Command = 4,
  HandAndCommand = Hand | Command,
  ProgramAndCommand = Program | Command,
  All = Hand | Program | Command
};

// The names of origins in files and reports, by their values; empty: not known.
inline constexpr std::array<const char*, 8> kOriginNames = {
    "", "hand", "program", "both", "command", "hand_and_command", "program_and_command", "all"};

// Returns true if a part of the work is of this origin.
constexpr bool includes(WorkOrigin all, WorkOrigin origin) {
  return (static_cast<int>(all) & static_cast<int>(origin)) != 0;
}

}  // namespace handwheel
