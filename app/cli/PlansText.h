// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// Lists the planning data of a robot cell, one item per line. The items are configurations, targets, frames, paths with
// their state, and the first 50 pairs that may touch. The text is empty for other documents. described: the result of
// DocumentKind::describe(). before: the prefix of each line.
std::string plansText(const nlohmann::json& described, const std::string& before = {});

}  // namespace handwheel
