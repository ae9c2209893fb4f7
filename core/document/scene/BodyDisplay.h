// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "scene/BodySet.h"

#include <optional>
#include <string_view>

namespace handwheel {

// The visible bodies as displayed parts, "body.NUMBER". A body that was only moved keeps its soup.
std::vector<DisplayPart> displayPartsOf(const BodySet& bodies);

// The name of the displayed part of a body.
std::string partOfBody(BodyId body);

// The number of the body that a displayed part belongs to; none for other parts.
std::optional<BodyId> bodyOfPart(std::string_view part);

// What people call a displayed part: a body by its name, one that was removed by its number, others as they are.
std::string shownPart(const std::string& part, const BodySet& bodies);

}  // namespace handwheel
