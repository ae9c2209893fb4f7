// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "scene/BodySet.h"

#include <optional>
#include <string_view>

namespace handwheel {

// Returns the visible bodies as displayed parts with the names "body.NUMBER". A body that was only moved keeps its
// soup.
std::vector<DisplayPart> displayPartsOf(const BodySet& bodies);

// Returns the name of the displayed part of a body.
std::string partOfBody(BodyId body);

// Returns the number of the body that a displayed part belongs to; nothing for other parts.
std::optional<BodyId> bodyOfPart(std::string_view part);

// Returns the name of a displayed part for the user. For a body this is its name, for a removed body its number; the
// names of other parts do not change.
std::string shownPart(const std::string& part, const BodySet& bodies);

}  // namespace handwheel
