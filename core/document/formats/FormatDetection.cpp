// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/FormatDetection.h"

#include "document/formats/ObjReader.h"
#include "document/formats/TextScanner.h"
#include "document/formats/off/OffHeader.h"
#include "document/formats/stl/StlReader.h"
#include "document/formats/threemf/ThreeMfReader.h"

namespace handwheel {

namespace {

// Empty when the text is in single bytes. Without a mark: ASCII characters with a NUL before or behind each.
std::string_view wideEncoding(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xFF\xFE\0\0"sv) || bytes.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv)) return "UTF-16";
  constexpr std::size_t kProbe = 32;
  if (bytes.size() < kProbe) return {};
  for (std::size_t nul : {0u, 1u}) {
    bool wide = true;
    for (std::size_t i = 0; i < kProbe; ++i) wide &= (bytes[i] == '\0') == (i % 2 == nul);
    if (wide) return "UTF-16";
  }
  return {};
}

bool looksLikePly(std::string_view bytes) {
  TextScanner scanner(bytes.substr(0, 256));
  return scanner.wordOnAnyLine() == "ply";
}

}  // namespace

Result<MeshFormat> detectFormat(std::string_view bytes, std::string_view name) {
  if (bytes.empty()) return Error{ErrorCode::FileEmpty, {}, {}, {}};
  if (looksLikePly(bytes)) return MeshFormat::Ply;
  if (isWholeBinaryStl(bytes)) return MeshFormat::Stl;
  if (looksLikeThreeMf(bytes)) return MeshFormat::ThreeMf;
  const auto named = formatForName(name);
  if (const auto wide = wideEncoding(bytes); !wide.empty() && named != MeshFormat::Stl)
    return Error{ErrorCode::TextEncoding, {std::string(wide)}, {}, {}};
  if (beginsWithOffKeyword(bytes)) return MeshFormat::Off;
  if (isTextStl(bytes)) return MeshFormat::Stl;
  if (looksLikeObj(bytes)) return MeshFormat::Obj;
  if (named) return *named;
  return Error{ErrorCode::FormatUnknown, meshEndings(), {}, {}};
}

}  // namespace handwheel
