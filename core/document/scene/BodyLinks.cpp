// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyLinks.h"

#include "document/FileBytes.h"
#include "document/Utf8.h"

#include <QCryptographicHash>
#include <QtGlobal>
#include <map>

namespace handwheel {

namespace {

Result<std::string> sha256Of(const std::filesystem::path& path, Progress progress) {
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (!failed && size > kLargestLinkedFile)
    return Error{ErrorCode::FileTooLarge, {"bytes", std::to_string(size), std::to_string(kLargestLinkedFile)}, {}, {}};
  const Result<std::string> bytes = readFileBytes(path, progress);
  if (!bytes) return bytes.error();
  const QByteArrayView view(bytes->data(), static_cast<qsizetype>(bytes->size()));
  return QCryptographicHash::hash(view, QCryptographicHash::Sha256).toHex().toStdString();
}

Note noteOn(const Body& body) {
  const char* const text =
      body.link->state == LinkState::Missing
          ? QT_TRANSLATE_NOOP(
                "Note", "The body '%1' is linked to %2, which is missing; it is shown as it was when it was read.")
          : QT_TRANSLATE_NOOP("Note",
                              "The body '%1' is linked to %2, which has changed; it is shown as it was before.");
  return {text, {body.name, body.link->path}};
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
  std::vector<std::filesystem::path> places;
  if (!folder.empty() && !link.relative.empty()) places.push_back(folder / link.relative);
  if (path.is_absolute()) places.push_back(path);
  if (!folder.empty()) places.push_back(folder / path.filename());
  for (const std::filesystem::path& place : places) {
    std::error_code failed;
    if (std::filesystem::is_regular_file(place, failed)) return place.lexically_normal();
  }
  return {};
}

BodySet withCheckedBodyLinks(const BodySet& bodies, const std::filesystem::path& folder, std::vector<Note>& notes,
                             Progress progress) {
  BodySet checked = bodies;
  std::map<std::filesystem::path, std::string> digests;  // empty: unreadable
  for (const BodyPointer& body : bodies) {
    if (progress.cancelled()) break;
    if (!body->link) continue;
    Body found = *body;
    const std::filesystem::path path = locateLink(*body->link, folder);
    const auto [entry, isNew] = digests.try_emplace(path);
    if (isNew && !path.empty()) {
      const Result<std::string> digest = sha256Of(path, progress);
      if (digest) entry->second = *digest;
      if (!digest && digest.error().code == ErrorCode::Cancelled) break;
    }
    const bool isSame = entry->second == found.link->sha256;
    found.link->state = path.empty() ? LinkState::Missing : isSame ? LinkState::Present : LinkState::Changed;
    if (isSame && !path.empty() && isUtf8(path.string())) found.link->path = path.string();
    if (found.link->state != LinkState::Present) notes.push_back(noteOn(found));
    checked = checked.with(std::make_shared<const Body>(std::move(found)));
  }
  return checked;
}

}  // namespace handwheel
