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

// An XML element with its attributes, text and child elements. Names include their prefixes; text is UTF-8.
struct XmlElement {
  std::string name;
  std::vector<XmlAttribute> attributes;
  std::string text;  // text directly inside the element, joined from its pieces; empty if there are only blanks
  std::vector<XmlElement> children;
  std::uint64_t line = 0;  // line number, from 1

  const std::string* attribute(std::string_view wanted) const;  // null: no such attribute
  const XmlElement* child(std::string_view wanted) const;       // first child of this name; null: none
};

// Limits on the size of an XML document.
struct XmlLimits {
  std::size_t bytes = std::size_t{16} << 20;
  std::size_t elements = 200'000;  // the limit for attributes is eight times this
  std::size_t depth = 64;
};

// Parses an XML document from untrusted bytes. Entities defined in the document are refused, so that it cannot grow.
// Elements are nested no deeper than the limit, so that functions may recurse over them. O(bytes). Errors:
// FileTooLarge, ElementMalformed (with the line), Unsupported, OutOfMemory, Cancelled.
Result<XmlElement> readXml(std::string_view bytes, const XmlLimits& limits, Progress progress = {});

// Creates an error about an element, with its line.
Error malformed(const XmlElement& element, std::string what);

}  // namespace handwheel
