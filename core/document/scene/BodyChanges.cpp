// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyChanges.h"

#include "base/NumberText.h"
#include "base/Utf8.h"
#include "document/scene/BodyEdit.h"
#include "document/scene/BodyErrors.h"
#include "scene/RigidPose.h"

#include <algorithm>
#include <set>

namespace handwheel {

namespace {

Status checkName(const BodySet& bodies, const Body& body) {
  if (!isBodyName(body.name))
    return Error{BodyError::NameUnusable, {body.name, std::to_string(kLongestBodyName)}, {}, {}};
  const BodyPointer namesake = bodies.withName(body.name);
  if (namesake && namesake->id != body.id) return Error{BodyError::NameTaken, {body.name}, {}, {}};
  return Done{};
}

Status checkPose(const Pose& pose) {
  for (double v : Vec3(pose.translation())) {
    if (v >= -kFarthestBody && v <= kFarthestBody) continue;
    return Error{ErrorCode::ValueOutOfRange,
                 {"the position of the body", roundedText(v), roundedText(-kFarthestBody), roundedText(kFarthestBody)},
                 {},
                 {}};
  }
  if (!isRigid(pose)) return Error{ErrorCode::ElementMalformed, {"pose", "its matrix is not a rotation"}, {}, {}};
  return Done{};
}

Status checkBody(const BodySet& bodies, const Body& body) {
  const Status named = checkName(bodies, body);
  return named ? checkPose(body.pose) : named;
}

// Checks if there is room for this shape when it replaces that one, which may be null.
Status checkRoom(const BodySet& bodies, const BodyGeometry& shape, const BodyGeometry* replaced) {
  const std::size_t less = replaced ? replaced->surface()->triangles.size() : 0;
  const std::size_t count = bodies.triangleCount() - less + shape.surface()->triangles.size();
  if (count <= BodySet::kMostTriangles) return Done{};
  return Error{BodyError::TooManyTriangles, {std::to_string(count), std::to_string(BodySet::kMostTriangles)}, {}, {}};
}

std::unique_ptr<Edit> editOf(std::vector<BodyEdit::Change> changes) {
  if (changes.empty()) return nullptr;
  return std::make_unique<BodyEdit>(std::move(changes));
}

// The first so many bytes, or fewer, so that no character is cut.
std::string_view shortened(std::string_view text, std::size_t most) {
  while (text.size() > most || !isUtf8(text)) text.remove_suffix(1);
  return text;
}

}  // namespace

Result<std::unique_ptr<Edit>> addBodyEdit(const BodySet& bodies, Body body) {
  if (bodies.size() >= BodySet::kMost) return Error{BodyError::TooManyBodies, {std::to_string(BodySet::kMost)}, {}, {}};
  body.id = bodies.freeId();
  if (const Status checked = checkBody(bodies, body); !checked) return checked.error();
  if (const Status room = checkRoom(bodies, *body.geometry, nullptr); !room) return room.error();
  const BodyId id = body.id;
  return editOf({{id, std::make_shared<const Body>(std::move(body))}});
}

Result<std::unique_ptr<Edit>> changeBodyEdit(const BodySet& bodies, Body body) {
  std::vector<Body> one;
  one.push_back(std::move(body));
  return changeBodiesEdit(bodies, std::move(one));
}

Result<std::unique_ptr<Edit>> changeBodiesEdit(const BodySet& bodies, std::vector<Body> changed) {
  std::vector<BodyEdit::Change> changes;
  for (Body& body : changed) {
    const BodyPointer present = bodies.withId(body.id);
    if (!present) return Error{BodyError::BodyMissing, {std::to_string(body.id)}, {}, {}};
    if (body == *present) continue;
    if (const Status checked = checkBody(bodies, body); !checked) return checked.error();
    if (body.geometry != present->geometry) {
      const Status room = checkRoom(bodies, *body.geometry, present->geometry.get());
      if (!room) return room.error();
    }
    const BodyId id = body.id;
    changes.push_back({id, std::make_shared<const Body>(std::move(body))});
  }
  return editOf(std::move(changes));
}

std::unique_ptr<Edit> removeBodiesEdit(const BodySet& bodies, std::span<const BodyId> ids) {
  std::vector<BodyEdit::Change> changes;
  for (BodyId id : std::set<BodyId>(ids.begin(), ids.end())) {
    if (bodies.withId(id)) changes.push_back({id, nullptr});
  }
  return editOf(std::move(changes));
}

std::unique_ptr<Edit> showBodiesEdit(const BodySet& bodies, std::span<const BodyId> ids, bool visible) {
  std::vector<BodyEdit::Change> changes;
  for (BodyId id : std::set<BodyId>(ids.begin(), ids.end())) {
    const BodyPointer present = bodies.withId(id);
    if (!present || present->visible == visible) continue;
    Body changed = *present;
    changed.visible = visible;
    changes.push_back({id, std::make_shared<const Body>(std::move(changed))});
  }
  return editOf(std::move(changes));
}

bool isBodyName(std::string_view name) {
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  return !name.empty() && name.size() <= kLongestBodyName && name.front() != ' ' && name.back() != ' ' &&
         std::none_of(name.begin(), name.end(), isControl) && isUtf8(name);
}

std::string numberedBodyName(std::string_view preferred, std::size_t number) {
  constexpr std::size_t kMostDigits = 8;
  if (!isBodyName(preferred)) preferred = "body";
  if (number < 2) return std::string(preferred);
  return std::string(shortened(preferred, kLongestBodyName - kMostDigits)) + ' ' + std::to_string(number);
}

std::string freeBodyName(const BodySet& bodies, std::string_view preferred) {
  std::size_t number = 1;
  while (bodies.withName(numberedBodyName(preferred, number))) ++number;
  return numberedBodyName(preferred, number);
}

}  // namespace handwheel
