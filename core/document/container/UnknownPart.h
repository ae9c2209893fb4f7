// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace handwheel {

// Returns the keys of an object that `known` does not have, at any depth. Arrays and values count as a
// whole.
nlohmann::json keysBeyond(const nlohmann::json& read, const nlohmann::json& known);

// Merges our keys over the unknown keys of an object: objects are merged key by key, at any depth; everything else is
// ours.
nlohmann::json withUnknown(nlohmann::json unknown, nlohmann::json ours);

// Returns the part of a container that this program does not know. These are keys, in objects at any depth, that
// `known` does not have, and blobs that it does not have and that are not below a folder of ours ("mesh/"). Arrays and
// values count as a whole: if `known` has the key, nothing of them is unknown.
Container unknownPart(const Container& read, const Container& known, std::span<const std::string> ownFolders);

// Merges `ours` over the unknown part. Objects are merged key by key, at any depth; everything else is taken from
// `ours` if it exists. Like RFC 7386, except that a null in `ours` is a value and removes nothing. Unknown parts of an
// object that was known when the file was read, and that `ours` no longer has, are deleted with it.
Container merged(const Container& unknown, Container ours, const Container& knownWhenRead = {});

}  // namespace handwheel
