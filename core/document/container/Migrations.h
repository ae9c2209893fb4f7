// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <functional>
#include <span>

namespace handwheel {

struct Container;

// A function that converts a container from one version of the format to the next. Errors: ElementMalformed.
using Migration = std::function<Status(Container&)>;

// Returns the kContainerVersion - 1 migrations of this program. Element i converts version i + 1 to version i + 2.
std::span<const Migration> migrations();

// Converts a container from `version` to the last version of the chain, which is one more than the length of the chain.
Status migrate(Container& container, std::uint64_t version, std::span<const Migration> chain);

}  // namespace handwheel
