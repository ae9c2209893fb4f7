// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyLinks.h"

#include "base/Utf8.h"
#include "scene/UnknownGeometry.h"

#include <QCryptographicHash>
#include <QtGlobal>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>

namespace handwheel {

namespace {

// Reads by blocks, and no more than the file's size: some files of the system never end.
Result<std::string> sha256Of(const std::filesystem::path& path, Progress progress) {
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) return Error{ErrorCode::FileMissing, {}, {}, {}};
  if (!std::filesystem::is_regular_file(path, failed))
    return Error{ErrorCode::FileUnreadable, {"it is not a regular file"}, {}, {}};
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (!failed && size > kLargestLinkedFile)
    return Error{ErrorCode::FileTooLarge, {"bytes", std::to_string(size), std::to_string(kLargestLinkedFile)}, {}, {}};
  std::ifstream file(path, std::ios::binary);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  std::vector<char> block(std::size_t{1} << 20);
  std::uintmax_t done = 0;
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    hash.addData(QByteArrayView(block.data(), file.gcount()));
    done += static_cast<std::uintmax_t>(file.gcount());
    if (done > size) return Error{ErrorCode::FileUnreadable, {"it is longer than its size"}, {}, {}};
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    progress.set(static_cast<double>(done) / static_cast<double>(size));
  }
  if (!file.eof()) return Error{ErrorCode::FileUnreadable, {std::strerror(errno)}, {}, {}};
  return hash.result().toHex().toStdString();
}

// Adds the notes on the shape and the link of a body.
void note(const Body& body, std::vector<Note>& notes) {
  if (const auto* shape = dynamic_cast<const UnknownGeometry*>(body.geometry.get()); shape && !shape->isDamaged()) {
    notes.push_back({QT_TRANSLATE_NOOP("Note",
                                       "The body '%1' has a shape that this program does not know ('%2'): it is kept, "
                                       "but cannot be shown. A newer version may know it."),
                     {body.name, std::string(shape->kind())}});
  }
  if (!body.link || body.link->state == LinkState::Present) return;
  const char* const text =
      body.link->state == LinkState::Missing
          ? QT_TRANSLATE_NOOP(
                "Note", "The body '%1' is linked to %2, which is missing; it is shown as it was when it was read.")
          : QT_TRANSLATE_NOOP("Note",
                              "The body '%1' is linked to %2, which has changed; it is shown as it was before.");
  notes.push_back({text, {body.name, body.link->path}});
}

// The body with the state of its link. None: cancelled. digests: by file; empty for one that cannot be read.
std::optional<Body> withCheckedLink(const Body& body, const std::filesystem::path& folder,
                                    std::map<std::filesystem::path, std::string>& digests, Progress progress) {
  Body found = body;
  const std::filesystem::path path = locateLink(*body.link, folder);
  std::error_code failed;
  const auto [entry, isNew] = digests.try_emplace(std::filesystem::canonical(path, failed));
  if (isNew && !path.empty()) {
    const Result<std::string> digest = sha256Of(path, progress);
    if (digest) entry->second = *digest;
    if (!digest && digest.error().code == ErrorCode::Cancelled) return std::nullopt;
  }
  const bool isSame = entry->second == found.link->sha256;
  found.link->state = path.empty() ? LinkState::Missing : isSame ? LinkState::Present : LinkState::Changed;
  if (isSame && !path.empty() && isUtf8(path.string())) found.link->path = path.string();
  return found;
}

}  // namespace

Result<BodyLink> linkTo(const std::filesystem::path& path, Progress progress) {
  const auto refused = [&](Error error) {
    if (error.subject.empty()) error.subject = path.string();
    return error;
  };
  std::error_code failed;
  const std::filesystem::path whole = std::filesystem::absolute(path, failed).lexically_normal();
  if (!isUtf8(whole.string()))
    return refused({ErrorCode::Unsupported, {"a link to a file name that is not UTF-8"}, {}, {}});
  const Result<std::string> sha256 = sha256Of(whole, progress);
  if (!sha256) return refused(sha256.error());
  return BodyLink{whole.string(), {}, *sha256, LinkState::Present};
}

std::string relativePathOf(const BodyLink& link, const std::filesystem::path& folder) {
  const bool isFound = link.state == LinkState::Present || link.state == LinkState::Changed;
  if (!isFound || folder.empty()) return link.relative;
  const std::string relative = std::filesystem::path(link.path).lexically_relative(folder.lexically_normal()).string();
  return isUtf8(relative) ? relative : std::string();
}

std::filesystem::path locateLink(const BodyLink& link, const std::filesystem::path& folder) {
  const std::filesystem::path path(link.path);
  std::vector<std::filesystem::path> candidates;
  if (!folder.empty() && !link.relative.empty()) candidates.push_back(folder / link.relative);
  if (path.is_absolute()) candidates.push_back(path);
  if (!folder.empty()) candidates.push_back(folder / path.filename());
  for (const std::filesystem::path& candidate : candidates) {
    std::error_code failed;
    if (std::filesystem::is_regular_file(candidate, failed)) return candidate.lexically_normal();
  }
  return {};
}

BodySet withCheckedBodyLinks(const BodySet& bodies, const std::filesystem::path& folder, std::vector<Note>& notes,
                             Progress progress) {
  BodySet checked = bodies;
  std::map<std::filesystem::path, std::string> digests;
  for (const BodyPointer& body : bodies) {
    if (body->link) {
      std::optional<Body> found = withCheckedLink(*body, folder, digests, progress);
      if (!found) break;
      checked = checked.with(std::make_shared<const Body>(*std::move(found)));
    }
    note(*checked.withId(body->id), notes);
  }
  return checked;
}

}  // namespace handwheel
