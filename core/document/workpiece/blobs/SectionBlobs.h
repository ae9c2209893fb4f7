// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "machining/section/TurnedSection.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace handwheel {

// Writes the exact half section of a part. Returns the number of its segments, which the manifest keeps.
std::uint64_t writeSection(const TurnedSection& section, Container& container);

// Reads a section with this number of segments. Returns nothing if it is lost, has too many loops, or is not within the
// bar; it is then made again from the passes.
std::optional<TurnedSection> readSection(const Container& container, std::uint64_t segments,
                                         const StockCylinder& stock);

}  // namespace handwheel
