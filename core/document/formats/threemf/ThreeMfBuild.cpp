// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/threemf/ThreeMfBuild.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::uint64_t kMost = std::uint64_t{1} << 25;  // triangles, and points
constexpr int kDeepestComponent = 100;

Error malformed(const ThreeMfReference& reference, const char* what) {
  return {ErrorCode::ElementMalformed, {"component", what}, reference.position, {}};
}

Error tooLarge(const char* what) {
  return {ErrorCode::FileTooLarge, {what, "", std::to_string(kMost)}, {}, {}};
}

// Returns every object of the part that is not a component of another.
std::vector<ThreeMfReference> uppermost(const ThreeMfPart& part) {
  std::set<std::uint32_t> components;
  for (const auto& [id, object] : part.objects)
    for (const ThreeMfReference& component : object.components)
      if (component.part.empty()) components.insert(component.object);
  std::vector<ThreeMfReference> items;
  for (const auto& [id, object] : part.objects) {
    if (object.isOther || components.contains(id)) continue;
    items.emplace_back();
    items.back().object = id;
  }
  return items;
}

}  // namespace

ThreeMfBuild::Target ThreeMfBuild::target(const ThreeMfPart& part, const ThreeMfReference& reference) const {
  const ThreeMfPart* const there = reference.part.empty() ? &part : m_findPart(reference.part);
  if (!there) return {};
  const auto found = there->objects.find(reference.object);
  return {there, found == there->objects.end() ? nullptr : &found->second};
}

// Adds the result of the reference to the size of its parent, which stays below twice the limit.
bool ThreeMfBuild::count(const ThreeMfPart& part, const ThreeMfReference& reference, int depth, Size& outer) {
  const auto giveUp = [&](Error error) {
    m_broken.insert(&reference);
    return m_assembly.tolerate(std::move(error));
  };
  const Target found = target(part, reference);
  if (!found.object) {
    const std::string name = reference.part + "#" + std::to_string(reference.object);
    return giveUp({ErrorCode::ReferenceMissing, {"the object", name}, reference.position, {}});
  }
  const auto [known, isNew] = m_sizes.try_emplace(found.object);
  Size& size = known->second;  // an element of a map keeps its address
  if (size.isCounting) return giveUp(malformed(reference, "it contains itself"));
  if (isNew) {
    const TriangleSoup& mesh = found.object->mesh;
    if (depth > kDeepestComponent) return m_assembly.fail(malformed(reference, "it is nested too deeply"));
    size = {mesh.points.size(), mesh.triangles.size(), 0, true};
    for (const ThreeMfReference& component : found.object->components) {
      if (!m_assembly.step() || !count(*found.part, component, depth + 1, size)) return false;
    }
    size.isCounting = false;
  }
  outer.points += size.points;
  outer.triangles += size.triangles;
  outer.height = std::max(outer.height, size.height + 1);
  // An object that was counted before may be deeper than this traversal.
  if (outer.height > kDeepestComponent) return m_assembly.fail(malformed(reference, "it is nested too deeply"));
  if (outer.triangles > kMost) return m_assembly.fail(tooLarge("triangles"));
  return outer.points <= kMost || m_assembly.fail(tooLarge("vertices"));
}

bool ThreeMfBuild::build(const ThreeMfPart& root, bool withoutBuild) {
  const std::vector<ThreeMfReference> orphans = withoutBuild ? uppermost(root) : std::vector<ThreeMfReference>();
  const std::vector<ThreeMfReference>& items = withoutBuild ? orphans : root.items;
  Size sum;
  for (const ThreeMfReference& item : items) {
    if (const Target found = target(root, item); found.object && found.object->isOther) {
      m_broken.insert(&item);
      m_assembly.mend({ErrorCode::ElementMalformed, {"item", "its object is of the type 'other'"}, item.position, {}});
    } else if (!count(root, item, 0, sum)) {
      return false;
    }
  }
  if (items.size() > 1) m_assembly.lose(LostAttribute::Groups);
  for (const ThreeMfReference& item : items) {
    if (!add(root, item, ThreeMfTransform::Identity())) return false;
  }
  return true;
}

// The depth is limited by count(). Objects that build nothing are not entered, so the work is bounded by the result.
bool ThreeMfBuild::add(const ThreeMfPart& part, const ThreeMfReference& reference, const ThreeMfTransform& outer) {
  if (m_broken.contains(&reference)) return true;
  const Target found = target(part, reference);
  if (m_sizes[found.object].triangles == 0) return true;
  const ThreeMfTransform transform = outer * reference.transform;
  if (!addMesh(found.object->mesh, transform)) return false;
  if (found.object->components.size() > 1) m_assembly.lose(LostAttribute::Groups);
  for (const ThreeMfReference& component : found.object->components) {
    if (!m_assembly.step() || !add(*found.part, component, transform)) return false;
  }
  return true;
}

bool ThreeMfBuild::addMesh(const TriangleSoup& mesh, const ThreeMfTransform& transform) {
  const bool isPlain = transform.matrix() == ThreeMfTransform::Identity().matrix();  // then no digit changes
  const bool isMirror = transform.linear().determinant() < 0.0;
  const auto first = static_cast<std::uint32_t>(m_assembly.pointCount());
  for (const Vec3& point : mesh.points) {
    const Vec3 placed = isPlain ? point : rounded(Vec3(transform * point), NumberType::Float64);
    if (!placed.allFinite()) return m_assembly.fail({ErrorCode::NumberNotFinite, {"inf"}, {}, {}});
    if (!m_assembly.step() || !m_assembly.addPoint(placed)) return false;
  }
  std::vector<Triangle>& triangles = m_assembly.soup().triangles;
  for (const Triangle& t : mesh.triangles) {
    if (!m_assembly.step()) return false;
    triangles.push_back({first + t[0], first + t[isMirror ? 2 : 1], first + t[isMirror ? 1 : 2]});
  }
  return true;
}

}  // namespace handwheel
