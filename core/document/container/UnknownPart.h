// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <span>

namespace handwheel {

// The part of a container that this program does not know. These are keys, in objects at any depth, that `known` does
// not have, and blobs that it does not have and that are not below a folder of ours ("mesh/"). Arrays and values count
// as a whole: where `known` has the key, nothing of them is unknown.
Container unknownPart(const Container& read, const Container& known, std::span<const std::string> ownFolders);

// Merges `ours` over the unknown part. Objects are merged key by key, at any depth; everything else is taken from
// `ours` where it exists. Like RFC 7386, except that a null in `ours` is a value and removes nothing. What was unknown
// within an object that was known when the file was read, and that `ours` no longer has, is deleted with it.
Container merged(const Container& unknown, Container ours, const Container& knownWhenRead = {});

}  // namespace handwheel
