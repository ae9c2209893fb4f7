// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/UnknownPart.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using nlohmann::json;

// All of these recurse no deeper than what parseJson() lets in.

// Removes the parts of objects that were known and have been deleted.
json withoutDeleted(const json& unknown, const json& known, const json& ours) {
  json left = json::object();
  for (const auto& [key, value] : unknown.items()) {
    const auto was = known.find(key), is = ours.find(key);
    if (was == known.end())
      left[key] = value;
    else if (is != ours.end() && is->is_object())
      left[key] = withoutDeleted(value, *was, *is);
  }
  return left;
}

void put(json& onto, json&& ours) {
  if (!onto.is_object() || !ours.is_object()) {
    onto = std::move(ours);
    return;
  }
  for (auto& [key, value] : ours.items()) put(onto[key], std::move(value));
}

}  // namespace

json keysBeyond(const json& read, const json& known) {
  json beyond = json::object();
  for (const auto& [key, value] : read.items()) {
    const auto found = known.find(key);
    if (found == known.end()) {
      beyond[key] = value;
    } else if (value.is_object() && found->is_object()) {
      json inner = keysBeyond(value, *found);
      if (!inner.empty()) beyond[key] = std::move(inner);
    }
  }
  return beyond;
}

json withUnknown(json unknown, json ours) {
  put(unknown, std::move(ours));
  return unknown;
}

Container unknownPart(const Container& read, const Container& known, std::span<const std::string> ownFolders) {
  Container unknown;
  *unknown.manifest = keysBeyond(*read.manifest, *known.manifest);
  for (const auto& [name, bytes] : read.blobs) {
    const auto isWithin = [&name = name](const std::string& folder) { return name.starts_with(folder); };
    const bool isOurs = known.blobs.contains(name) || std::any_of(ownFolders.begin(), ownFolders.end(), isWithin);
    if (!isOurs) unknown.blobs.emplace(name, bytes);
  }
  return unknown;
}

Container merged(const Container& unknown, Container ours, const Container& knownWhenRead) {
  Container both;
  *both.manifest = withoutDeleted(*unknown.manifest, *knownWhenRead.manifest, *ours.manifest);
  both.blobs = unknown.blobs;
  put(*both.manifest, std::move(*ours.manifest));
  for (auto& [name, bytes] : ours.blobs) both.blobs[name] = std::move(bytes);
  return both;
}

}  // namespace handwheel
