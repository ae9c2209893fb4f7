// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace handwheel {

// Returns the keys of an object, at any depth, that `known` does not have. An array or a value counts as a whole.
nlohmann::json keysBeyond(const nlohmann::json& read, const nlohmann::json& known);

// Merges the keys of the program over the unknown keys of an object. Objects are merged key by key, at any depth; for
// everything else the value in `ours` is taken.
nlohmann::json withUnknown(nlohmann::json unknown, nlohmann::json ours);

// Returns the part of a container that this program does not know. It contains the keys of objects, at any depth, that
// `known` does not have, and the blobs that `known` does not have and that are not in one of the program's folders
// ("mesh/"). An array or a value counts as a whole: if `known` has its key, no part of it is unknown.
Container unknownPart(const Container& read, const Container& known, std::span<const std::string> ownFolders);

// Merges `ours`, the container of the program, over the unknown part. Objects are merged key by key, at any depth;
// everything else is taken from `ours` if it exists there. This is a merge patch of RFC 7386, except that a null in
// `ours` is a value and removes no key. If `ours` no longer has an object that was known when the file was read, the
// unknown parts of the object are deleted.
Container merged(const Container& unknown, Container ours, const Container& knownWhenRead = {});

}  // namespace handwheel
