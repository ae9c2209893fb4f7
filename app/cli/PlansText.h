// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// What a robot cell keeps for planning, a line each. These are configurations, targets, frames, paths with what is
// known of them, and pairs that may touch; of very many pairs the first. Empty for other documents. described: as
// DocumentKind::describe() has it. before: of each line.
std::string plansText(const nlohmann::json& described, const std::string& before = {});

}  // namespace handwheel
