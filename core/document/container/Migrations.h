// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <functional>
#include <span>

namespace handwheel {

struct Container;

// Turns a container of one version of the format into one of the next. Errors: ElementMalformed.
using Migration = std::function<Status(Container&)>;

// The program's own: number i leads from version i + 1 to i + 2; there are kContainerVersion - 1 of them.
std::span<const Migration> migrations();

// Runs those that lead from this version to the chain's end, which is one more than its length.
Status migrate(Container& container, std::uint64_t version, std::span<const Migration> chain);

}  // namespace handwheel
