// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/RecoveryFiles.h"

#include "base/JsonText.h"

#include <QByteArray>
#include <QStandardPaths>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr const char *kStamp = "stamp", *kFileBytes = "bytes", *kModified = "modified_ns", *kPartial = "partial",
                     *kPrivate = "private_name";

std::optional<FileTimestamp> stampIn(const nlohmann::json& info) {
  const auto found = info.find(kStamp);
  if (found == info.end() || !found->is_object()) return {};
  const auto bytes = found->find(kFileBytes), modified = found->find(kModified);
  if (bytes == found->end() || !bytes->is_number_unsigned()) return {};
  if (modified == found->end() || !modified->is_number_integer()) return {};
  return FileTimestamp{bytes->get<std::uintmax_t>(), modified->get<std::int64_t>()};
}

}  // namespace

std::filesystem::path recoveryFolder() {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
  return std::filesystem::path(folder.toStdString()) / "recovery";
}

namespace recovery {

std::filesystem::path autosaveFile(const std::filesystem::path& session, std::uint64_t key) {
  return session / (std::to_string(key) + kAutosaveEnding);
}

std::filesystem::path infoFile(std::filesystem::path autosave) {
  return autosave.replace_extension(".json");
}

std::filesystem::path changesFile(std::filesystem::path autosave) {
  return autosave.replace_extension(".changes");
}

std::filesystem::path damagedFile(std::filesystem::path autosave) {
  return autosave.replace_extension(kDamagedEnding);
}

// The autosave is removed first: changes alone mean nothing.
void removeAutosave(const std::filesystem::path& autosave) {
  std::error_code ignored;
  std::filesystem::remove(autosave, ignored);
  std::filesystem::remove(changesFile(autosave), ignored);
}

std::string infoText(const AutosaveInfo& info) {
  // A path need not be UTF-8; JSON must.
  const std::string path = QByteArray::fromStdString(info.path).toPercentEncoding("/ ").toStdString();
  nlohmann::json text = {{"id", info.documentId}, {"path", path}, {"name", info.name}, {"kind", info.kind}};
  if (info.stamp) text[kStamp] = {{kFileBytes, info.stamp->bytes}, {kModified, info.stamp->modifiedNs}};
  if (info.isPartial) text[kPartial] = true;
  if (info.hasPrivateName) text[kPrivate] = true;
  return text.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

AutosaveInfo parseInfo(std::string_view text) {
  AutosaveInfo info;
  const auto parsed = parseJson(text, "autosave");
  if (!parsed || !parsed->is_object()) return info;
  const auto take = [&parsed](const char* key, std::string& to) {
    if (const auto found = parsed->find(key); found != parsed->end() && found->is_string()) to = *found;
  };
  take("id", info.documentId);
  take("path", info.path);
  take("name", info.name);
  take("kind", info.kind);
  info.path = QByteArray::fromPercentEncoding(QByteArray::fromStdString(info.path)).toStdString();
  info.stamp = stampIn(*parsed);
  info.hasPrivateName = parsed->value(kPrivate, nlohmann::json()) == true;
  info.isPartial = parsed->value(kPartial, nlohmann::json()) == true;
  return info;
}

}  // namespace recovery

}  // namespace handwheel
