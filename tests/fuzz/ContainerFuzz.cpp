// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/Blobs.h"
#include "document/container/UnknownPart.h"
#include "document/container/ZipWriter.h"
#include "document/mesh/MeshKind.h"
#include "document/mesh/SubdivisionLevelStore.h"
#include "mesh/structure/MeshValidator.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is an archive; or, where it
// begins with a brace, the manifest of one, so that changes get past the checksums. What is in it is read as a mesh.

using namespace handwheel;

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ContainerFuzz: %s\n", what);
  std::abort();
}

nlohmann::json ownPart(nlohmann::json manifest) {
  manifest.erase("handwheel");
  return manifest;
}

bool same(const Container& a, const Container& b) {
  return ownPart(*a.manifest) == ownPart(*b.manifest) && a.blobs == b.blobs;
}

// What was read is written, and reads back the same, whole.
void writeAndRead(const Container& container, Compression compression) {
  const auto bytes = writeContainer(container, compression);
  if (!bytes && bytes.error().code == ErrorCode::FileTooLarge) return;  // a manifest grows when it is written
  require(bytes.hasValue(), "what was read cannot be written");
  require(looksLikeContainer(*bytes), "what was written is not recognised");
  const auto again = readContainer(*bytes);
  require(again.hasValue() && again->damage.empty(), "what was written is not read");
  require(same(again->container, container), "what was written is read differently");
}

// Whatever the blobs hold: a mesh, and levels of a patch of it, or none.
void readAsMesh(const Container& container) {
  const MeshKind kind;
  std::vector<Error> damage;
  const auto content = kind.load(container, damage, {});
  if (!content) return;
  const auto& mesh = static_cast<const MeshSnapshot&>(**content);
  require(validate(mesh.mesh.mesh).empty(), "the mesh is not valid");
  if (!mesh.levels) return;
  require(isSameVersion(mesh.levels->mesh(), mesh.mesh.mesh), "the finest level is not the mesh");
  for (std::size_t i = 0; i < mesh.levels->finest(); ++i)
    require(validate(mesh.levels->mesh(i)).empty(), "a level is not valid");
  Container again;
  kind.save(mesh, again);
  const auto back = kind.load(again, damage, {});
  require(back && static_cast<const MeshSnapshot&>(**back).levels, "levels that were read are not saved");
}

void judge(std::string_view archive, Compression compression) {
  const auto read = readContainer(archive);
  if (!read) return;
  require(read->container.manifest->is_object(), "the manifest is no object");
  for (const auto& [name, bytes] : read->container.blobs)
    require(!name.empty() && name.front() != '/' && name.find("..") == std::string::npos, "a name leads elsewhere");
  for (std::uint64_t count : {std::uint64_t{7}, ~std::uint64_t{0}}) {
    const auto array = readArray<double>(read->container, "mesh/positions", count, 3);
    require(array.values.size() <= 3 * count || count > 7, "more values than asked for");
  }
  if (read->container.manifest->value("document", nlohmann::json()).is_object()) readAsMesh(read->container);
  writeAndRead(read->container, compression);
  const Container nothing;
  require(same(merged(unknownPart(read->container, nothing, {}), nothing), read->container), "unknown keys are lost");
}

// Two triangles, subdivided twice.
const Container& small() {
  static const Container kContainer = [] {
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    soup.triangles = {{0, 1, 2}, {0, 2, 3}};
    PatchLevels levels(buildMesh(soup).mesh, {0, 1});
    levels.refine();
    levels.refine();
    MeshSnapshot content;
    content.build = std::make_shared<const BuildReport>();
    content.mesh.mesh = levels.mesh();
    content.levels = std::make_shared<const PatchLevels>(levels);
    Container container;
    MeshKind().save(content, container);
    return container;
  }();
  return kContainer;
}

std::string withManifest(std::string_view manifest) {
  std::vector<ZipEntry> entries = {{"manifest.json", manifest}, {"a", ""}};
  for (const auto& [name, bytes] : small().blobs) entries.push_back({name, bytes});
  const auto archive = writeZip(entries, Compression::None);
  require(archive.hasValue(), "no archive");
  return *archive;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Compression compression = size % 2 == 0 ? Compression::None : Compression::Fast;
  judge(bytes.starts_with('{') ? withManifest(bytes) : std::string(bytes), compression);
  return 0;
}
