// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/MeshLocation.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>

namespace handwheel {

namespace {

namespace fs = std::filesystem;

constexpr int kFoldersUp = 4;      // levels that a relative name may climb
constexpr int kPackageClimb = 16;  // levels above the description in which a package is sought

// Returns the number of levels that a relative path climbs.
int climbOf(const fs::path& normal) {
  return static_cast<int>(std::count(normal.begin(), normal.end(), fs::path("..")));
}

bool isFile(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool isFolder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

Error missing(std::string_view name) {
  return {ErrorCode::ReferenceMissing, {"the mesh", std::string(name)}, {}, {}};
}

Error refused(std::string_view name, const char* why) {
  return {ErrorCode::Unsupported, {"the mesh name '" + std::string(name) + "', " + why + ","}, {}, {}};
}

std::string decoded(std::string_view address) {
  std::string path;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = address.data() + i + 1;
    if (address[i] == '%' && i + 2 < address.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      path.push_back(static_cast<char>(byte));
      i += 2;
    } else {
      path.push_back(address[i]);
    }
  }
  return path;
}

Result<fs::path> inPackage(std::string_view name, std::string_view address, const fs::path& folder) {
  const std::size_t slash = std::min(address.find('/'), address.size());
  const fs::path package(address.substr(0, slash));
  const fs::path rest = fs::path(address.substr(std::min(slash + 1, address.size()))).lexically_normal();
  if (package.empty() || package == "." || package == "..") return refused(name, "which names no package");
  if (rest.is_absolute() || climbOf(rest) > 0) return refused(name, "which leaves its package");
  fs::path above = folder;
  bool isThere = false;
  for (int i = 0; i <= kPackageClimb; ++i, above = above.parent_path()) {
    if (isFile(above / package / rest)) return above / package / rest;
    if (above.filename() == package && isFile(above / rest)) return above / rest;
    isThere = isThere || above.filename() == package || isFolder(above / package);
    if (!above.has_relative_path()) break;
  }
  if (isThere) return missing(name);
  return Error{ErrorCode::ReferenceMissing, {"the package", package.string(), folder.string()}, {}, {}};
}

}  // namespace

Result<fs::path> locateMesh(std::string_view name, const fs::path& folder) {
  std::error_code ignored;
  const fs::path base = (fs::absolute(folder, ignored) / "x").lexically_normal().parent_path();
  for (std::string_view scheme : {"package://", "model://"}) {
    if (name.starts_with(scheme)) return inPackage(name, name.substr(scheme.size()), base);
  }
  fs::path path;
  constexpr std::string_view kFile = "file://";
  if (name.starts_with(kFile)) {
    path = decoded(name.substr(kFile.size()));
    if (!path.is_absolute()) return refused(name, "which lies on another machine");
  } else if (name.find("://") != name.npos) {
    return refused(name, "which is no file on this machine");
  } else {
    const fs::path relative = fs::path(name).lexically_normal();
    if (climbOf(relative) > kFoldersUp) return refused(name, "which leads too far away");
    path = relative.is_absolute() ? relative : (base / relative).lexically_normal();
  }
  if (!isFile(path)) return missing(name);
  return path;
}

}  // namespace handwheel
