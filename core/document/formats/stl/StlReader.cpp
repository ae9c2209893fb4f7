// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/stl/StlReader.h"

#include "document/formats/MeshTextValues.h"
#include "document/formats/stl/StlBinaryReader.h"
#include "document/formats/stl/StlTextReader.h"

namespace handwheel {

// Binary data has a NUL within a kilobyte, and no line that begins with "facet" or "endsolid".
bool isTextStl(std::string_view bytes) {
  TextScanner scanner(bytes.substr(0, 64 * 1024));
  const std::string_view first = scanner.wordOnAnyLine();
  if (equalsIgnoringCase(first, "facet")) return equalsIgnoringCase(scanner.word(), "normal");
  if (!equalsIgnoringCase(first, "solid")) return false;
  constexpr std::size_t kTextProof = 1024;
  const std::size_t firstNul = bytes.find('\0');
  if (firstNul == std::string_view::npos || firstNul > kTextProof) return true;
  while (scanner.nextLine()) {
    const std::string_view word = scanner.word();
    if (equalsIgnoringCase(word, "facet") || equalsIgnoringCase(word, "endsolid")) return true;
  }
  return false;
}

Result<MeshFile> readStl(std::string_view bytes, const ReadOptions& options, Progress progress) {
  if (!isWholeBinaryStl(bytes) && isTextStl(bytes)) return readTextStl(bytes, options, progress);
  return readBinaryStl(bytes, options, progress);
}

}  // namespace handwheel
