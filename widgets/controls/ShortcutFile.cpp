// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ShortcutFile.h"

#include "document/DocumentErrors.h"

#include <QKeySequence>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "handwheel-shortcuts";
constexpr int kVersion = 1;
constexpr std::size_t kMostKeys = 8;  // keys of one action

bool isKey(const QString& text) {
  const QKeySequence keys = QKeySequence::fromString(text, QKeySequence::PortableText);
  for (int i = 0; i < keys.count(); ++i) {
    if (keys[static_cast<uint>(i)].key() == Qt::Key_unknown) return false;
  }
  return !keys.isEmpty();
}

Error malformed(const std::string& element, const char* why) {
  return {ErrorCode::ElementMalformed, {element, why}, {}, {}};
}

Result<QStringList> keysFrom(const std::string& id, const Json& list) {
  if (!list.is_array() || list.size() > kMostKeys) return malformed(id, "a short list of keys is expected");
  QStringList keys;
  for (const Json& key : list) {
    const QString text = key.is_string() ? QString::fromStdString(key.get<std::string>()) : QString();
    if (!isKey(text)) return malformed(id, "there is no such key");
    keys << text;
  }
  return keys;
}

}  // namespace

QByteArray toJson(const ShortcutChanges& changes) {
  Json all = Json::object();
  for (auto change = changes.begin(); change != changes.end(); ++change) {
    Json keys = Json::array();
    for (const QString& key : change.value()) keys.push_back(key.toStdString());
    all[change.key().toStdString()] = keys;
  }
  const Json file = {{"format", kFormat}, {"version", kVersion}, {"shortcuts", all}};
  return QByteArray::fromStdString(file.dump(2) + "\n");
}

Result<ShortcutChanges> shortcutsFromJson(const QByteArray& json) {
  if (json.size() > kLargestShortcutFile) {
    return Error{ErrorCode::FileTooLarge, {"bytes", "", std::to_string(kLargestShortcutFile)}, {}, {}};
  }
  const Json file = Json::parse(json.begin(), json.end(), nullptr, false);
  if (!file.is_object() || !file.contains("format") || file["format"] != kFormat) {
    return Error{DocumentError::FormatUnknown, {}, {}, {}};
  }
  const Json version = file.value("version", Json());
  if (!version.is_number_integer()) return malformed("version", "a whole number is expected");
  if (version > kVersion) return Error{ErrorCode::VersionNewer, {version.dump(), std::to_string(kVersion)}, {}, {}};
  const Json list = file.value("shortcuts", Json());
  if (!list.is_object()) return malformed("shortcuts", "an object is expected");
  ShortcutChanges changes;
  for (const auto& [id, keys] : list.items()) {
    const Result<QStringList> read = keysFrom(id, keys);
    if (!read) return read.error();
    changes.insert(QString::fromStdString(id), *read);
  }
  return changes;
}

}  // namespace handwheel
