// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <functional>
#include <span>

namespace handwheel {

struct Container;

// Converts a container from one version of the format to the next. Errors: ElementMalformed.
using Migration = std::function<Status(Container&)>;

// Returns the migrations of this program. Number i converts version i + 1 to i + 2; there are kContainerVersion - 1 of
// them.
std::span<const Migration> migrations();

// Converts a container from `version` to the last version of the chain. That is one more than the chain's length.
Status migrate(Container& container, std::uint64_t version, std::span<const Migration> chain);

}  // namespace handwheel
