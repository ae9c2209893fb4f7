// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// An attribute of an XML element.
struct XmlAttribute {
  std::string name;
  std::string value;
};

// An XML element with its attributes, text and child elements. Names are as written, prefix included; text is UTF-8.
struct XmlElement {
  std::string name;
  std::vector<XmlAttribute> attributes;
  std::string text;  // directly inside, its pieces joined; empty where there are only blanks
  std::vector<XmlElement> children;
  std::uint64_t line = 0;  // from 1

  const std::string* attribute(std::string_view wanted) const;  // null when there is none
  const XmlElement* child(std::string_view wanted) const;       // the first of that name, or null
};

// Limits on the size of an XML document.
struct XmlLimits {
  std::size_t bytes = std::size_t{16} << 20;
  std::size_t elements = 200'000;  // and eight times as many attributes
  std::size_t depth = 64;
};

// Parses an XML document from untrusted bytes. Entities that it defines are refused, so it does not grow; elements are
// nested no deeper than the limit, so functions may recurse over them. O(bytes). Errors: FileTooLarge, ElementMalformed
// (with the line), Unsupported, OutOfMemory, Cancelled.
Result<XmlElement> readXml(std::string_view bytes, const XmlLimits& limits, Progress progress = {});

// Creates an error about an element, with its line.
Error malformed(const XmlElement& element, std::string what);

}  // namespace handwheel
