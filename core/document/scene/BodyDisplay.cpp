// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyDisplay.h"

#include <charconv>

namespace handwheel {

namespace {
constexpr std::string_view kPartPrefix = "body.";
}

std::vector<DisplayPart> displayPartsOf(const BodySet& bodies) {
  std::vector<DisplayPart> parts;
  for (const BodyPointer& body : bodies) {
    if (!body->visible || body->geometry->surface()->triangles.empty()) continue;
    DisplayPart part;
    part.name = partOfBody(body->id);
    part.soup = body->geometry->surface();
    part.pose = body->pose;
    part.colour = body->look.colour;
    part.smooth = body->look.smooth;
    parts.push_back(std::move(part));
  }
  return parts;
}

std::string partOfBody(BodyId body) {
  return std::string(kPartPrefix) + std::to_string(body);
}

std::optional<BodyId> bodyOfPart(std::string_view part) {
  if (!part.starts_with(kPartPrefix)) return std::nullopt;
  part.remove_prefix(kPartPrefix.size());
  BodyId id = 0;
  const auto [stop, error] = std::from_chars(part.data(), part.data() + part.size(), id);
  return error == std::errc() && stop == part.data() + part.size() ? std::optional(id) : std::nullopt;
}

std::string shownPart(const std::string& part, const BodySet& bodies) {
  const auto id = bodyOfPart(part);
  const BodyPointer body = id ? bodies.withId(*id) : nullptr;
  return body ? body->name : part;
}

}  // namespace handwheel
