// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PartActors.h"

#include "viewport/surface/PolyData.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <algorithm>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kScanned = 2'000'000;  // points that set() looks at, whatever the size of the soups: 5 ms
constexpr double kFadedOpacity = 0.4;
constexpr float kTint = 0.35f;  // share of the accent, in a highlighted part
constexpr float kSelectedTint = 0.6f;

QColor toColour(const std::array<float, 3>& c) {
  const auto channel = [&](int k) { return std::clamp(c[k], 0.0f, 1.0f); };
  return QColor::fromRgbF(channel(0), channel(1), channel(2));
}

}  // namespace

PartActors::PartActors(LayerProps& props, double opacity) : m_props(props), m_opacity(opacity) {}

void PartActors::set(const std::vector<DisplayPart>& parts) {
  std::unordered_map<std::string, Part> before;
  for (Part& part : m_parts) {
    const auto [it, isNew] = before.try_emplace(part.description.name, std::move(part));
    if (!isNew) remove(part);
  }
  std::set<Soup> unknown;
  for (const DisplayPart& part : parts) {
    if (!m_shapes.contains(part.soup)) unknown.insert(part.soup);
  }
  const std::size_t scanned = kScanned / std::max<std::size_t>(unknown.size(), 1);
  std::set<std::string> groups;
  ++m_changes;
  m_parts.clear();
  for (const DisplayPart& description : parts) {
    Part part;
    if (const auto it = before.find(description.name); it != before.end()) {
      part = std::move(it->second);
      before.erase(it);
    } else {
      part.number = ++m_lastNumber;
    }
    if (part.description.group != description.group) part.next.reset();
    part.description = description;
    part.wanted = shapeFor(description.soup, scanned);
    if (description.group.empty()) showAlone(part);
    place(part);
    style(part);
    groups.insert(description.group);
    m_parts.push_back(std::move(part));
  }
  for (auto& [name, part] : before) {
    if (part.shown && groups.contains(part.description.group) && !part.description.group.empty()) {
      part.goneSince = m_changes;
      m_leaving.push_back(std::move(part));
    } else {
      remove(part);
    }
  }
  before.clear();
  for (const Part& part : m_leaving) groups.insert(part.description.group);
  for (const auto& [group, call] : m_next) groups.insert(group);
  for (const std::string& group : groups) showGroup(group);
  std::erase_if(m_shapes, [](const auto& entry) { return entry.second.expired(); });
  updateBounds();
}

PartActors::ShapePointer PartActors::shapeFor(const Soup& soup, std::size_t scanned) {
  std::weak_ptr<Shape>& known = m_shapes[soup];
  if (const ShapePointer shape = known.lock()) return shape;
  const auto shape = std::make_shared<Shape>();
  shape->soup = soup;
  shape->outline = outlineOf(*soup, scanned);
  known = shape;
  return shape;
}

// A part without a group shows its newest shape as far as it is uploaded.
void PartActors::showAlone(Part& part) {
  if (part.wanted == part.shown) {
    part.next.reset();
  } else if (!part.wanted->blocks.empty()) {
    show(part, part.wanted);
    part.next.reset();
  } else if (part.next && !part.next->blocks.empty()) {
    show(part, part.next);
    part.next = part.wanted;
    part.nextSince = m_changes;
  } else if (!part.next) {
    part.next = part.wanted;
    part.nextSince = m_changes;
  }
}

void PartActors::show(Part& part, const ShapePointer& shape) {
  if (part.shown == shape) return;
  remove(part);
  part.shown = shape;
  for (const auto& block : shape->blocks) addActor(part, block);
}

bool PartActors::isUpToDate(const std::string& group) const {
  const auto isThere = [&](const Part& part) { return part.isIn(group); };
  const auto isOld = [&](const Part& part) { return part.isIn(group) && part.shown != part.wanted; };
  return std::none_of(m_parts.begin(), m_parts.end(), isOld) &&
         std::none_of(m_leaving.begin(), m_leaving.end(), isThere);
}

bool PartActors::isNextComplete(const std::string& group) const {
  const auto isOwing = [&](const Part& part) { return part.isIn(group) && part.next && !part.next->isComplete(); };
  return std::none_of(m_parts.begin(), m_parts.end(), isOwing) &&
         std::none_of(m_leaving.begin(), m_leaving.end(), isOwing);
}

// Shows the next state of a group as soon as all of its shapes are uploaded. The state stays the next one while set()
// is called again: otherwise parts that change all the time would never be complete.
void PartActors::showGroup(const std::string& group) {
  if (group.empty()) return;
  while (!isUpToDate(group)) {
    const auto [next, isBegun] = m_next.try_emplace(group, m_changes);
    for (Part& part : m_parts) {
      if (!isBegun || !part.isIn(group)) continue;
      part.next = part.wanted;
      part.nextSince = m_changes;
    }
    if (!isNextComplete(group)) return;
    const std::uint64_t call = next->second;
    m_next.erase(next);
    for (auto* parts : {&m_parts, &m_leaving}) {
      for (Part& part : *parts) {
        if (part.isIn(group) && part.next) show(part, std::exchange(part.next, nullptr));
      }
    }
    std::erase_if(m_leaving, [&](Part& part) {
      const bool isGone = part.isIn(group) && part.goneSince <= call;
      if (isGone) remove(part);
      return isGone;
    });
  }
  m_next.erase(group);
  for (Part& part : m_parts) {
    if (part.isIn(group)) part.next.reset();
  }
}

std::vector<PartActors::Soup> PartActors::missing() const {
  std::vector<std::pair<std::uint64_t, const Shape*>> awaited;
  const auto add = [&](const ShapePointer& shape, std::uint64_t since) {
    if (shape && shape->blockCount == 0) awaited.emplace_back(since, shape.get());
  };
  for (const auto* parts : {&m_parts, &m_leaving}) {
    for (const Part& part : *parts) add(part.next, part.nextSince);
  }
  for (const Part& part : m_parts) add(part.wanted, std::numeric_limits<std::uint64_t>::max());
  std::stable_sort(awaited.begin(), awaited.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Soup> soups;
  std::set<const Shape*> listed;
  for (const auto& [since, shape] : awaited) {
    if (listed.insert(shape).second) soups.push_back(shape->soup);
  }
  return soups;
}

bool PartActors::setShape(const Soup& soup, PartShape& made) {
  const auto it = m_shapes.find(soup);
  const ShapePointer shape = it == m_shapes.end() ? nullptr : it->second.lock();
  if (!shape || shape->blockCount > 0) return false;
  shape->blockCount = made.blocks.size();
  shape->origin = made.origin;
  shape->faces = std::move(made.faces);
  for (SurfaceGeometry& block : made.blocks) m_queue.emplace_back(shape, std::move(block));
  return true;
}

std::size_t PartActors::takeOne() {
  if (m_queue.empty()) return 0;
  const auto [shape, geometry] = std::move(m_queue.front());
  m_queue.pop_front();
  shape->blocks.push_back(toPolyData(geometry));
  std::set<std::string> groups;
  for (Part& part : m_parts) {
    if (part.shown == shape) {
      addActor(part, shape->blocks.back());
    } else if (part.description.group.empty()) {
      showAlone(part);
    }
  }
  for (const auto& [group, call] : m_next) groups.insert(group);
  for (const std::string& group : groups) showGroup(group);
  ++m_built;
  return std::max<std::size_t>(geometry.indices.size() / 3, 1);
}

void PartActors::addActor(Part& part, vtkPolyData* block) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(block);
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->SetUserMatrix(vtkNew<vtkMatrix4x4>());
  m_props.add(actor);
  part.actors.push_back(actor);
  place(part);
  style(part);
}

void PartActors::remove(Part& part) {
  for (const auto& actor : part.actors) m_props.remove(actor);
  part.actors.clear();
}

// Sets the matrices of the actors. The geometry is relative to a point of the part, the drawing to a point near the
// model: so that far away from their origins, too, only small numbers meet single precision.
void PartActors::place(const Part& part) const {
  if (!part.shown) return;
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = part.description.pose.matrix();
  matrix.topRightCorner<3, 1>() = part.description.pose * part.shown->origin - m_origin;
  for (const auto& actor : part.actors) actor->GetUserMatrix()->DeepCopy(matrix.data());
}

void PartActors::style(const Part& part) const {
  const std::string& name = part.description.name;
  QColor colour = toColour(part.description.colour);
  const bool isSelected = m_selected.contains(name);
  if (isSelected) colour = mixed(colour, m_style.colours.accent, kSelectedTint);
  if (isHighlighted(part)) colour = mixed(colour, m_style.colours.accent, kTint);
  const bool isFaded = m_faded.contains(name) || part.isIn(m_faintGroup) || (m_isCovered && !isSelected);
  const double opacity = isFaded ? kFadedOpacity : m_opacity;
  SurfaceStyle style = m_style;
  if (!part.description.isSectioned) style.clip = nullptr;
  SurfaceMaterial material{colour, part.description.smooth, opacity, part.description.gloss};
  material.isSolid = true;
  for (const auto& actor : part.actors) applyStyle(actor, style, material);
}

void PartActors::setStyle(const SurfaceStyle& style) {
  m_style = style;
  for (const auto* parts : {&m_parts, &m_leaving}) {
    for (const Part& part : *parts) this->style(part);
  }
}

void PartActors::setOrigin(const Vec3& origin) {
  if (origin == m_origin) return;
  m_origin = origin;
  for (const auto* parts : {&m_parts, &m_leaving}) {
    for (const Part& part : *parts) place(part);
  }
}

// All parts of a group are highlighted: to the user they are one.
bool PartActors::isHighlighted(const Part& part) const {
  if (m_highlighted.empty()) return false;
  return part.description.name == m_highlighted || part.isIn(m_highlightedGroup);
}

void PartActors::setHighlighted(const std::string& name) {
  if (name == m_highlighted) return;
  std::vector<const Part*> changed;
  const auto note = [&] {
    for (const Part& part : m_parts) {
      if (isHighlighted(part)) changed.push_back(&part);
    }
  };
  note();
  m_highlighted = name;
  const auto part =
      std::find_if(m_parts.begin(), m_parts.end(), [&](const Part& p) { return p.description.name == name; });
  m_highlightedGroup = part == m_parts.end() ? std::string() : part->description.group;
  note();
  for (const Part* each : changed) style(*each);
}

bool PartActors::setSelected(const std::set<std::string>& names, bool isCovered) {
  if (names == m_selected && isCovered == m_isCovered) return false;
  const std::set<std::string> before = std::exchange(m_selected, names);
  const bool isEachOther = std::exchange(m_isCovered, isCovered) != isCovered;
  for (const Part& part : m_parts) {
    const std::string& name = part.description.name;
    if (isEachOther || before.contains(name) || names.contains(name)) style(part);
  }
  return true;
}

bool PartActors::isAnyShown() const {
  return std::any_of(m_parts.begin(), m_parts.end(), [](const Part& part) { return part.shown != nullptr; });
}

bool PartActors::setFaded(const std::vector<DisplayPart>& proposed) {
  std::set<std::string> names;
  for (const DisplayPart& part : proposed) names.insert(part.name);
  if (names == m_faded) return false;
  m_faded = std::move(names);
  for (const Part& part : m_parts) style(part);
  return true;
}

void PartActors::setFaintGroup(const std::string& group) {
  m_faintGroup = group;
  for (const Part& part : m_parts) style(part);
}

}  // namespace handwheel
