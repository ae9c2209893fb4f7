// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyBlobs.h"

#include "base/JsonText.h"
#include "document/scene/BodyChanges.h"
#include "document/scene/BodyLinks.h"
#include "scene/RigidPose.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>

namespace handwheel {

namespace {

using nlohmann::json;

constexpr const char* kBodyList = "bodies";
constexpr const char* kNextBody = "next_body";
// Larger numbers in a file are replaced, so that there are always free ones.
constexpr BodyId kLargestReadId = 100'000'000;

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

bool boolAt(const json& object, const char* key, bool otherwise) {
  const auto found = object.find(key);
  return found != object.end() && found->is_boolean() ? found->get<bool>() : otherwise;
}

std::optional<Pose> poseAt(const json& entry) {
  const std::vector<double> numbers = numbersAt(entry, "pose", 12);
  if (numbers.size() != 12) return std::nullopt;
  Pose pose = Pose::Identity();
  for (Eigen::Index i = 0; i < 12; ++i) pose.matrix()(i / 4, i % 4) = numbers[static_cast<std::size_t>(i)];
  return isRigid(pose) ? std::optional(pose) : nearestRigid(pose);
}

BodyLook lookAt(const json& entry) {
  BodyLook look;
  look.smooth = boolAt(entry, "smooth", look.smooth);
  const std::vector<double> colour = numbersAt(entry, "colour", 3);
  for (std::size_t i = 0; i < colour.size(); ++i) {
    if (std::isfinite(colour[i])) look.colour[i] = static_cast<float>(std::clamp(colour[i], 0.0, 1.0));
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
    std::vector<std::pair<std::string, const json*>> others;  // Bodies whose numbers cannot be used
    std::size_t done = 0;
    for (const auto& [key, entry] : list.items()) {
      if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
      progress.set(static_cast<double>(done++) / static_cast<double>(list.size()));
      const BodyId id = idOf(key);
      if (key.find('/') != std::string::npos)  // its folder could hold that of others
        note(key, "its key is not a number");
      else if (id == 0 || m_bodies.withId(id))
        others.emplace_back(key, &entry);
      else
        add(id, key, entry);
    }
    m_bodies = m_bodies.withFreeId(static_cast<BodyId>(std::min<std::uint64_t>(next, kLargestReadId)));
    for (const auto& [key, entry] : others) add(m_bodies.freeId(), key, *entry);
    if (m_leftOut > 0) noteTooMany("bodies", m_bodies.size() + m_leftOut, BodySet::kMost);
    if (m_triangles > BodySet::kMostTriangles) noteTooMany("triangles", m_triangles, BodySet::kMostTriangles);
    return m_bodies;
  }

 private:
  void note(const std::string& key, const char* what) {
    m_damage.push_back({ErrorCode::ElementMalformed, {"bodies." + key, what}, {}, {}});
  }

  void add(BodyId id, const std::string& key, const json& entry) {
    if (!entry.is_object()) return note(key, "it is not an object");
    if (m_bodies.size() >= BodySet::kMost) {
      ++m_leftOut;
      return;
    }
    Body body;
    body.id = id;
    const std::string name = stringAt(entry, "name");
    body.name = freeName(isBodyName(name) ? name : "body " + std::to_string(id));
    if (const auto pose = poseAt(entry))
      body.pose = *pose;
    else
      note(key, "its pose cannot be used");
    body.look = lookAt(entry);
    body.carrier = stringAt(entry, "carrier");
    body.visible = boolAt(entry, "visible", true);
    body.link = linkAt(entry);
    const auto geometry = entry.find("geometry");
    body.geometry = shapeOf(geometry == entry.end() ? json() : *geometry, folderOfBody(m_folder, key));
    m_bodies = m_bodies.with(std::make_shared<const Body>(std::move(body)));
  }

  // A few bytes can stand for very many triangles: shapes beyond the limit are kept, but not shown.
  GeometryPointer shapeOf(const json& described, const std::string& folder) {
    if (m_triangles > BodySet::kMostTriangles) return keptAsItIs(described, folder, m_container, true);
    const GeometryPointer read = readGeometry(described, folder, m_container, m_damage, m_own);
    m_triangles += read->surface()->triangles.size();
    return m_triangles > BodySet::kMostTriangles ? keptAsItIs(described, folder, m_container, true) : read;
  }

  // Counts on from the last number for the same name, as a file may have it often.
  std::string freeName(const std::string& preferred) {
    std::size_t& number = m_numbers[preferred];
    std::string name;
    do {
      name = numberedBodyName(preferred, ++number);
    } while (!m_names.insert(name).second);
    return name;
  }

  void noteTooMany(const char* what, std::uint64_t count, std::uint64_t most) {
    m_damage.push_back({ErrorCode::FileTooLarge, {what, std::to_string(count), std::to_string(most)}, {}, {}});
  }

  const Container& m_container;
  const std::string& m_folder;
  std::vector<Error>& m_damage;
  std::span<const GeometryFormat> m_own;
  BodySet m_bodies;
  std::unordered_set<std::string> m_names;
  std::unordered_map<std::string, std::size_t> m_numbers;  // the last one for each name
  std::uint64_t m_triangles = 0;
  std::size_t m_leftOut = 0;  // bodies
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
    if (!body->carrier.empty()) list[key]["carrier"] = body->carrier;
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
    damage.push_back({ErrorCode::ElementMalformed, {kBodyList, "it is not an object"}, {}, {}});
    return BodySet();
  }
  return BodyReading(container, folder, damage, own).read(*list, countAt(*document, kNextBody), progress);
}

}  // namespace handwheel
