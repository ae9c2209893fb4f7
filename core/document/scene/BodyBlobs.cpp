// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyBlobs.h"

#include "document/container/JsonText.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyLinks.h"
#include "scene/RigidPose.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using nlohmann::json;

constexpr const char* kBodyList = "bodies";
constexpr const char* kNextBody = "next_body";
// Larger numbers in a file are replaced, so that there are always free ones.
constexpr BodyId kLargestReadId = 100'000'000;
// Of all bodies together, as for the shapes of a robot.
constexpr std::uint64_t kMostBodyTriangles = 20'000'000;

std::string keyOfBody(BodyId id) {
  const std::string digits = std::to_string(id);
  return std::string(4 - std::min<std::size_t>(4, digits.size()), '0') + digits;
}

std::string folderOfBody(const std::string& folder, const std::string& key) {
  return folder + "/bodies/" + key;
}

json poseNumbers(const Pose& pose) {
  json numbers = json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) numbers.push_back(pose.matrix()(row, column));
  }
  return numbers;
}

json linkEntry(const std::optional<BodyLink>& link, const std::filesystem::path& folder) {
  if (!link) return nullptr;
  return {{"path", link->path}, {"relative", relativePathOf(*link, folder)}, {"sha256", link->sha256}};
}

std::string stringAt(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool boolAt(const json& object, const char* key, bool otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

// None where there are not as many numbers.
std::optional<std::vector<double>> numbersAt(const json& object, const char* key, std::size_t count) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != count) return std::nullopt;
  std::vector<double> numbers;
  for (const json& entry : *found) {
    if (!entry.is_number()) return std::nullopt;
    numbers.push_back(entry.get<double>());
  }
  return numbers;
}

std::optional<Pose> poseAt(const json& entry) {
  const auto numbers = numbersAt(entry, "pose", 12);
  if (!numbers) return std::nullopt;
  Pose pose = Pose::Identity();
  for (Eigen::Index i = 0; i < 12; ++i) pose.matrix()(i / 4, i % 4) = (*numbers)[static_cast<std::size_t>(i)];
  if (isRigid(pose)) return pose;
  const Pose mended = nearestRigid(pose);
  const bool isNothing = mended.matrix() == Pose::Identity().matrix();
  return isNothing ? std::nullopt : std::optional(mended);
}

BodyLook lookAt(const json& entry) {
  BodyLook look;
  look.smooth = boolAt(entry, "smooth", look.smooth);
  const auto colour = numbersAt(entry, "colour", 3);
  for (std::size_t i = 0; colour && i < 3; ++i) {
    if (std::isfinite((*colour)[i])) look.colour[i] = static_cast<float>(std::clamp((*colour)[i], 0.0, 1.0));
  }
  return look;
}

std::optional<BodyLink> linkAt(const json& entry) {
  const auto found = entry.find("link");
  if (found == entry.end() || !found->is_object()) return std::nullopt;
  BodyLink link{stringAt(*found, "path"), stringAt(*found, "relative"), stringAt(*found, "sha256")};
  return link.path.empty() ? std::nullopt : std::optional(std::move(link));
}

// The number that a key stands for; 0 where it is none that can be used.
BodyId idOf(const std::string& key) {
  BodyId id = 0;
  const auto [stop, error] = std::from_chars(key.data(), key.data() + key.size(), id);
  const bool isNumber = error == std::errc() && stop == key.data() + key.size();
  return isNumber && id <= kLargestReadId ? id : 0;
}

class BodyReading {
 public:
  BodyReading(const Container& container, const std::string& folder, std::vector<Error>& damage,
              std::span<const GeometryFormat> own)
      : m_container(container), m_folder(folder), m_damage(damage), m_own(own) {}

  Result<BodySet> read(const json& list, std::uint64_t next, Progress progress) {
    std::vector<std::pair<std::string, const json*>> others;  // whose numbers cannot be used
    std::size_t done = 0;
    for (const auto& [key, entry] : list.items()) {
      if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
      progress.set(static_cast<double>(done++) / static_cast<double>(list.size()));
      const BodyId id = idOf(key);
      if (id == 0 || m_bodies.withId(id))
        others.emplace_back(key, &entry);
      else
        add(id, key, entry);
    }
    m_bodies = m_bodies.withFreeId(static_cast<BodyId>(std::min<std::uint64_t>(next, kLargestReadId)));
    for (const auto& [key, entry] : others) add(m_bodies.freeId(), key, *entry);
    return m_bodies;
  }

 private:
  void note(const std::string& key, const char* what) {
    m_damage.push_back({ErrorCode::ElementMalformed, {"bodies." + key, what}, {}, {}});
  }

  void add(BodyId id, const std::string& key, const json& entry) {
    if (m_isTooMuch) return;
    if (!entry.is_object()) return note(key, "it is no object");
    if (m_bodies.size() >= BodySet::kMost) return noteTooMany("bodies", BodySet::kMost);
    Body body;
    body.id = id;
    const std::string name = stringAt(entry, "name");
    body.name = freeBodyName(m_bodies, isBodyName(name) ? name : "body " + std::to_string(id));
    if (const auto pose = poseAt(entry))
      body.pose = *pose;
    else
      note(key, "its pose cannot be used");
    body.look = lookAt(entry);
    body.visible = boolAt(entry, "visible", true);
    body.link = linkAt(entry);
    const auto geometry = entry.find("geometry");
    body.geometry = readGeometry(geometry == entry.end() ? json() : *geometry, folderOfBody(m_folder, key), m_container,
                                 m_damage, m_own);
    // A few bytes can stand for very many triangles.
    m_triangles += body.geometry->surface()->triangles.size();
    if (m_triangles > kMostBodyTriangles) return noteTooMany("triangles", kMostBodyTriangles);
    m_bodies = m_bodies.with(std::make_shared<const Body>(std::move(body)));
  }

  void noteTooMany(const char* what, std::uint64_t most) {
    m_isTooMuch = true;
    m_damage.push_back({ErrorCode::FileTooLarge, {what, "", std::to_string(most)}, {}, {}});
  }

  const Container& m_container;
  const std::string& m_folder;
  std::vector<Error>& m_damage;
  std::span<const GeometryFormat> m_own;
  BodySet m_bodies;
  std::uint64_t m_triangles = 0;
  bool m_isTooMuch = false;  // the rest is left out
};

}  // namespace

void writeBodies(const BodySet& bodies, const std::string& folder, Container& container,
                 std::span<const GeometryFormat> own) {
  json& document = (*container.manifest)["document"];
  json& list = document[kBodyList] = json::object();
  for (const BodyPointer& body : bodies) {
    const std::string key = keyOfBody(body->id);
    list[key] = {{"name", body->name},
                 {"pose", poseNumbers(body->pose)},
                 {"colour", body->look.colour},
                 {"smooth", body->look.smooth},
                 {"visible", body->visible},
                 {"link", linkEntry(body->link, container.folder)},
                 {"geometry", writeGeometry(*body->geometry, folderOfBody(folder, key), container, own)}};
  }
  document[kNextBody] = bodies.freeId();
}

Result<BodySet> readBodies(const Container& container, const std::string& folder, std::vector<Error>& damage,
                           Progress progress, std::span<const GeometryFormat> own) {
  const auto document = container.manifest->find("document");
  if (document == container.manifest->end() || !document->is_object()) return BodySet();
  const auto list = document->find(kBodyList);
  if (list == document->end() || list->is_null()) return BodySet();
  if (!list->is_object()) {
    damage.push_back({ErrorCode::ElementMalformed, {kBodyList, "it is no object"}, {}, {}});
    return BodySet();
  }
  return BodyReading(container, folder, damage, own).read(*list, countAt(*document, kNextBody), progress);
}

}  // namespace handwheel
