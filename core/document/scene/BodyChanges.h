// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/Edit.h"
#include "scene/BodySet.h"

#include <memory>
#include <span>

namespace handwheel {

// Checked edits of the bodies of a document.

inline constexpr std::size_t kLongestBodyName = 200;  // bytes

// Adds a body under a number of its own. Errors: NameUnusable {name, most bytes}, NameTaken {name}; ValueOutOfRange
// {"the position of the body", value, least, largest}, ElementMalformed {"pose", what is wrong}; FileTooLarge
// {"bodies", count, limit}.
Result<std::unique_ptr<Edit>> addBodyEdit(const BodySet& bodies, Body body);

// Replaces the body with the same number. Null when nothing changes. Errors: those of adding, ReferenceMissing {"the
// body", number}.
Result<std::unique_ptr<Edit>> changeBodyEdit(const BodySet& bodies, Body body);

// The same of several, whose names and shapes do not change. Null when none changes.
Result<std::unique_ptr<Edit>> changeBodiesEdit(const BodySet& bodies, std::vector<Body> changed);

// Removes bodies. Null when there is none with these numbers.
std::unique_ptr<Edit> removeBodiesEdit(const BodySet& bodies, std::span<const BodyId> ids);

// Shows or hides bodies. Null when nothing changes.
std::unique_ptr<Edit> showBodiesEdit(const BodySet& bodies, std::span<const BodyId> ids, bool visible);

// Whether a text can be the name of a body: UTF-8, one line, neither empty nor too long, no space at either end.
bool isBodyName(std::string_view name);

// The preferred name, from the second on with a number: "name 2". "body" for one that cannot be a name.
std::string numberedBodyName(std::string_view preferred, std::size_t number);

// A name that no body has: the preferred one if possible, or "name 2", "name 3", … "body" for one that cannot be a
// name.
std::string freeBodyName(const BodySet& bodies, std::string_view preferred);

}  // namespace handwheel
