// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace handwheel {

// Lists the planning data of a robot cell, one item per line. These are configurations, targets, frames, paths with
// their state, and pairs that may touch; only the first of very many pairs. Empty for other documents. described: the
// result of DocumentKind::describe(). before: prefix of each line.
std::string plansText(const nlohmann::json& described, const std::string& before = {});

}  // namespace handwheel
