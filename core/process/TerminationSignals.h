// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <csignal>

namespace handwheel {

// The signals that ask a program to end. They are sent by a key, by the system, and when a terminal is closed.
inline constexpr std::array kTerminationSignals{SIGINT, SIGTERM, SIGHUP};

}  // namespace handwheel
